#include "coupling/exchange/regimes/stem_numbers.hpp"

#include <algorithm>
#include <tuple>

#include "config/table/schema.hpp"
#include "config/text/joined.hpp"
#include "coupling/exchange/regimes/columns.hpp"

namespace coupling {

const config::Schema<StemsAtAge>& stem_number_columns() {
    // clang-format off
    static const config::Schema<StemsAtAge> columns{
        {.role = "stem_numbers", .setting = "regime column stems", .row = "age", .no_rows = "a row for each age",
         .unique_together = {{"stand", "age_years"}}},
        {{"stand", &StemsAtAge::stand, "its number on the map; without the column the rows are for every area", {.range = {1.0, 4e9}, .optional = true}},
         {"age_years", &StemsAtAge::age_years, "of the 100 thickest stems, or since a clear cut", {.range = {0.0, 2000.0}}},
         {"stems_pha", &StemsAtAge::stems_pha, "that stay", {.range = {0.0, 1e6}}}}};
    // clang-format on
    return columns;
}

std::vector<StemsAtAge> read_stem_numbers(const config::Table& table) {
    const auto rows = stem_number_columns().all(table);
    std::vector<StemsAtAge> stems{rows.begin(), rows.end()};
    std::sort(stems.begin(), stems.end(), [](const StemsAtAge& a, const StemsAtAge& b) {
        return std::tie(a.stand, a.age_years) < std::tie(b.stand, b.age_years);
    });
    return stems;
}

void check_ground(const Intervention& intervention, const std::string& file, config::Problems& problems) {
    const bool by_stand = std::any_of(intervention.stems_at.begin(), intervention.stems_at.end(),
                                      [](const StemsAtAge& row) { return row.stand > 0; });
    if (by_stand && intervention.ground.where != Where::stands) {
        problems.add(config::ExitCode::data, intervention.place,
                     config::joined("where = ", name_of(intervention.ground.where), ", but ", file,
                                    " has stems by stand"),
                     "where = stands", "write it, or leave the column `stand` out");
    }
}

std::optional<double> stems_at(std::span<const StemsAtAge> stems, const Area& area, double age_years) {
    const std::vector<std::uint32_t>& units = area.place.management_units;
    const StemsAtAge* before = nullptr;
    for (const StemsAtAge& row : stems) {
        if (row.stand > 0 && (units.size() != 1 || row.stand != units.front())) {
            continue;
        }
        if (row.age_years == age_years) {
            return row.stems_pha;
        }
        if (row.age_years > age_years) {
            if (before == nullptr) {
                return std::nullopt;
            }
            const double part = (age_years - before->age_years) / (row.age_years - before->age_years);
            return before->stems_pha + part * (row.stems_pha - before->stems_pha);
        }
        before = &row;
    }
    return std::nullopt;
}

}  // namespace coupling
