#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/table/table.hpp"
#include "coupling/exchange/regimes/areas.hpp"
#include "coupling/exchange/regimes/intervention.hpp"
#include "coupling/exchange/regimes/run_years.hpp"
#include "forest/stand/patch.hpp"
#include "forest/stand/species.hpp"

namespace coupling {

/// A table that a regime names, by the role of its file. Throws config::InputError.
using ReadTable = std::function<config::Table(const std::string& role, const std::string& file)>;

/// A management regime on a forest: valid, and the same for all years and replicates.
class Regime {
public:
    /// Throws one InputError (data) with all that is wrong with the table
    /// (coupling/exchange/regimes/rows.hpp), with its areas (areas.hpp), with rows that could never act in
    /// the run (run_years.hpp), and with interventions that contradict each other in a year.
    ///
    /// Contradictions are looked for where the calendar alone decides, over 500 years, by the patches that
    /// areas share: two cuts (a thinning may go with a cut of target diameters), a thinning and planting, one
    /// treatment twice. What conditions bring together stands in the report of the year as nothing to cut.
    static Regime read(const config::Table& table, std::string name, const forest::SpeciesTable& species,
                       const forest::PatchGrid& grid, const ShapesOf& shapes_of, const RunYears& run = {},
                       const ReadTable& table_of = {});

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const std::vector<Intervention>& interventions() const { return interventions_; }
    /// The ground of an intervention: interventions on the same ground have the same number.
    [[nodiscard]] std::size_t ground_of(std::size_t intervention) const { return ground_of_[intervention]; }
    [[nodiscard]] const std::vector<Area>& areas_of(std::size_t intervention) const {
        return areas_[ground_of_[intervention]];
    }
    /// The row on whose cuts or salvages an intervention acts (where = cuts_of): its areas are in
    /// RegimeState::cuts.
    [[nodiscard]] std::optional<std::size_t> cuts_of(std::size_t intervention) const {
        return cuts_of_[intervention];
    }
    /// Whether another row acts on the cuts of an intervention.
    [[nodiscard]] bool keeps_cuts_of(std::size_t intervention) const;
    /// The row that an intervention follows.
    [[nodiscard]] std::optional<std::size_t> predecessor_of(std::size_t intervention) const {
        return follows_[intervention];
    }

private:
    std::string name_;
    std::vector<Intervention> interventions_;
    std::vector<std::size_t> ground_of_;
    std::vector<std::vector<Area>> areas_;
    std::vector<std::optional<std::size_t>> follows_;
    std::vector<std::optional<std::size_t>> cuts_of_;
};

/// The entry whose turn it is in a year by the calendar of a row; nothing in other years. Rows with `after`
/// have no calendar of their own.
std::optional<int> turn_of(const Intervention& intervention, int year);

/// Adds a problem for interventions that contradict each other (see Regime::read).
void find_contradictions(const Regime& regime, config::Problems& problems);

}  // namespace coupling
