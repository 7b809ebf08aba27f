#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/inputs/forest/climate_input.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/tables/table_layout.hpp"
#include "forest/stand/species.hpp"

namespace coupling::decades {

/// What the numbers in the rows of members mean.
///
/// A course is a regime in a climate: what tables compare and a line of a chart is about. Courses are
/// numbered regime by regime.
struct Names {
    std::vector<std::string> regimes;
    std::vector<std::vector<std::pair<std::string, std::string>>>
        interventions;  ///< by regime: name and treatment of each row
    const forest::SpeciesTable& species;
    std::vector<std::string> climates{only_climate};

    [[nodiscard]] std::size_t courses() const { return regimes.size() * climates.size(); }
    [[nodiscard]] std::size_t course(std::size_t regime, std::size_t climate) const {
        return regime * climates.size() + climate;
    }
    [[nodiscard]] std::size_t course_of(const Member& member) const {
        return course(member.regime, member.climate);
    }
    [[nodiscard]] std::size_t regime_of(std::size_t course) const { return course / climates.size(); }
    [[nodiscard]] std::size_t climate_of(std::size_t course) const { return course % climates.size(); }
    /// "pfm1", where there are several climates "pfm1, warm".
    [[nodiscard]] std::string course_name(std::size_t course) const;
    /// Folder of its rasters below that of their kind: "pfm1", or "pfm1/warm".
    [[nodiscard]] std::string course_folder(std::size_t course) const;
};

/// Writes tables/stands.csv, dbh_classes.csv, forest_years.csv, mortality.csv and trees_YEAR.csv of the years
/// given: tidy, one row an observation, members in the order given. Throws config::InputError (file).
std::vector<WrittenFile> write_forest_tables(const std::filesystem::path& folder, const Names& names,
                                             std::span<const MemberYears> members,
                                             std::span<const int> tree_list_years);
std::vector<TableLayout> forest_layouts();

}  // namespace coupling::decades
