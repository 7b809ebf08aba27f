#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "coupling/decades/records.hpp"
#include "coupling/results/out_file.hpp"
#include "forest/species.hpp"

namespace coupling::decades {

/// What the numbers in the rows of members mean.
struct Names {
    std::vector<std::string> regimes;
    const forest::SpeciesTable& species;
};

/// Writes tables/stands.csv, dbh_classes.csv, forest_years.csv, mortality.csv and trees_YEAR.csv: tidy, one
/// row an observation, members in the order given. Throws config::InputError (file).
std::vector<WrittenFile> write_forest_tables(const std::filesystem::path& folder, const Names& names,
                                             std::span<const MemberYears> members);

}  // namespace coupling::decades
