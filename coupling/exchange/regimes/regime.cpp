#include "coupling/exchange/regimes/regime.hpp"

#include <algorithm>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/exchange/regimes/fell_list.hpp"
#include "coupling/exchange/regimes/rows.hpp"
#include "coupling/exchange/regimes/stem_numbers.hpp"

namespace coupling {

namespace {

using config::joined;

/// How the areas lie, whoever takes turns on them; the rungs of slits are cut into entries.
Ground lie_of(Ground ground) {
    ground.entries = ground.where == Where::slits ? ground.entries : 1;
    return ground;
}

/// The trees of recorded cuts and the stems of yield tables.
void read_lists(std::vector<Intervention>& rows, const RunYears& run, const ReadTable& table_of,
                config::Problems& problems) {
    for (Intervention& row : rows) {
        const bool is_list = row.treatment == Treatment::fell_list;
        if (!is_list && row.treatment != Treatment::thin_to_stems) {
            continue;
        }
        if (!table_of) {
            problems.add(config::ExitCode::data, row.place,
                         joined("a list of ", is_list ? "trees" : "stems", ", but no files to read it from"),
                         "a regime in a file beside the scenario");
            continue;
        }
        const config::Table table =
            is_list ? table_of("trees to fell", row.trees) : table_of("stems by age", row.stems);
        if (is_list) {
            row.listed = read_fell_list(table);
            use_run_years(row.listed, table.file(), run, problems);
            row.every_years = 1;  // each year is looked up in the list
        } else {
            row.stems_at = read_stem_numbers(table);
            check_ground(row, table.file(), problems);
        }
    }
}

}  // namespace

Regime Regime::read(const config::Table& table, std::string name, const forest::SpeciesTable& species,
                    const forest::PatchGrid& grid, const ShapesOf& shapes_of, const RunYears& run,
                    const ReadTable& table_of) {
    config::Problems problems;
    Regime regime;
    regime.name_ = std::move(name);
    regime.interventions_ = read_interventions(table, species, problems);
    use_run_years(regime.interventions_, run, problems);
    read_lists(regime.interventions_, run, table_of, problems);
    std::vector<Ground> grounds;
    for (const Intervention& intervention : regime.interventions_) {
        const Ground ground = lie_of(intervention.ground);
        const auto known = std::find(grounds.begin(), grounds.end(), ground);
        regime.ground_of_.push_back(static_cast<std::size_t>(known - grounds.begin()));
        if (known == grounds.end()) {
            grounds.push_back(ground);
            regime.areas_.push_back(
                coupling::areas_of(ground, grid, shapes_of, intervention.place, problems));
        }
        const auto row_named = [&](const std::string& wanted) -> std::optional<std::size_t> {
            for (std::size_t i = 0; i < regime.interventions_.size(); ++i) {
                if (!wanted.empty() && regime.interventions_[i].name == wanted) {
                    return i;
                }
            }
            return std::nullopt;
        };
        regime.follows_.push_back(row_named(intervention.after));
        regime.cuts_of_.push_back(row_named(intervention.ground.cuts_of));
    }
    find_contradictions(regime, problems);
    problems.throw_if_any();
    return regime;
}

bool Regime::keeps_cuts_of(std::size_t intervention) const {
    return std::find(cuts_of_.begin(), cuts_of_.end(), intervention) != cuts_of_.end();
}

std::optional<int> turn_of(const Intervention& intervention, int year) {
    if (intervention.treatment == Treatment::fell_list) {
        const bool is_listed = std::any_of(intervention.listed.begin(), intervention.listed.end(),
                                           [year](const ListedTree& tree) { return tree.year == year; });
        return is_listed ? std::optional{0} : std::nullopt;
    }
    if (!intervention.after.empty() || year < intervention.first_year ||
        year > intervention.last_year.value_or(year)) {
        return std::nullopt;
    }
    const int since = year - intervention.first_year;
    if (!intervention.every_years) {
        return since == 0 || intervention.has_condition() ? std::optional{0} : std::nullopt;
    }
    return since % *intervention.every_years == 0
               ? std::optional{since / *intervention.every_years % intervention.ground.entries}
               : std::nullopt;
}

}  // namespace coupling
