#include "forest/stand/species.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "config/data/shipped_tables.hpp"
#include "forest/stand/species_fields.hpp"

namespace forest {

namespace {

using config::ExitCode;
using config::Problems;
using config::Table;

bool same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// What single ranges cannot say: values that contradict each other.
void check_consistent(const config::Read<Species>& species, const Table& table, config::RowProblems& wrong) {
    const auto expect = [&](bool holds, std::string_view column, const std::string& expected) {
        if (!holds) {
            wrong.refuse(species.row, column,
                         std::string{column} + " " + config::in_quotes(table.text(species.row, column)) +
                             " of " + config::in_quotes(species.code),
                         expected);
        }
    };
    const TemperatureCurve& temperature = species.three_pg.temperature;
    expect(temperature.min_degc < temperature.optimum_degc, "pg_Topt", "more than pg_Tmin");
    expect(temperature.optimum_degc < temperature.max_degc, "pg_Tmax", "more than pg_Topt");
    expect(species.three_pg.root_share.min <= species.three_pg.root_share.max, "pg_pRx", "at least pg_pRn");
    expect(species.response.zero_growth_degc < species.response.full_growth_degc, "temp_max_iland",
           "more than temp_min_iland");
    expect(species.response.min_degree_days < species.response.max_degree_days, "gdd_max",
           "more than gdd_min");
    expect(species.establishment.min_degree_days < species.establishment.max_degree_days, "est_gdd_max",
           "more than est_gdd_min");
    const Light& light = species.light;
    expect(species.evergreen ? light.leaf_on_month == 0 : light.leaf_on_month > 0, "leaf_on_month",
           species.evergreen ? "0 for an evergreen species" : "a month (1-12) for a deciduous species");
    expect(species.evergreen ? light.leaf_off_month == 0 : light.leaf_off_month > light.leaf_on_month,
           "leaf_off_month",
           species.evergreen ? "0 for an evergreen species" : "a month after leaf_on_month");
}

}  // namespace

SpeciesTable SpeciesTable::read(const Table& table) {
    config::RowProblems wrong{table};
    SpeciesTable result;
    for (config::Read<Species>& species : species_columns().rows(table, wrong)) {
        check_consistent(species, table, wrong);
        for (const auto& [column, name] :
             {std::pair{"species_code", species.code}, std::pair{"latin_name", species.latin_name}}) {
            if (result.find(name)) {
                wrong.refuse(species.row, column, config::in_quotes(name) + " a second time",
                             "each species once");
            }
        }
        result.species_.push_back(std::move(species));
    }
    wrong.throw_first();
    return result;
}

SpeciesTable SpeciesTable::shipped() {
    return read(config::read_shipped_table("species.csv"));
}

std::optional<SpeciesId> SpeciesTable::find(std::string_view name) const {
    for (std::size_t i = 0; i < species_.size(); ++i) {
        if (same_word(species_[i].code, name) || same_word(species_[i].latin_name, name)) {
            return static_cast<SpeciesId>(i);
        }
    }
    return std::nullopt;
}

std::optional<SpeciesId> SpeciesTable::find(std::string_view name, const config::Place& place,
                                            Problems& problems) const {
    const std::optional<SpeciesId> found = find(name);
    if (!found) {
        std::vector<std::string> names;
        for (const Species& species : species_) {
            names.push_back(species.code);
            names.push_back(species.latin_name);
        }
        const std::string nearest = config::nearest_word(name, names);
        std::string codes;
        for (const Species& species : species_) {
            codes += (codes.empty() ? "" : ", ") + species.code;
        }
        problems.add(
            ExitCode::data, place, "species " + config::in_quotes(name),
            nearest.empty() ? "a species of the species table: " + codes : config::in_quotes(nearest));
    }
    return found;
}

}  // namespace forest
