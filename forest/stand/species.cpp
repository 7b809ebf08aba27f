#include "forest/stand/species.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>
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

std::vector<std::string> wanted_columns() {
    std::vector<std::string> wanted;
    const auto add = [&](const auto& fields) {
        for (const auto& field : fields) {
            wanted.emplace_back(field.column);
        }
    };
    add(text_fields());
    add(flag_fields());
    add(whole_fields());
    add(number_fields());
    wanted.emplace_back(crown_shape_column);
    return wanted;
}

/// A table that gives units must give ours: a factor of 1000 is silent.
void check_units(const Table& table, Problems& problems) {
    const auto check = [&](const auto& fields) {
        for (const auto& field : fields) {
            const std::string& unit = table.units()[table.find(field.column).value()];
            if (!unit.empty() && unit != field.unit) {
                problems.add(ExitCode::data, {table.file()},
                             "unit " + config::in_quotes(unit) + " of column " + std::string{field.column},
                             config::in_quotes(field.unit));
            }
        }
    };
    if (!table.units().empty()) {
        check(number_fields());
        check(whole_fields());
    }
}

CrownShape read_crown_shape(const Table& table, std::size_t row, Problems& problems) {
    const std::string& shape = table.text(row, crown_shape_column);
    if (shape != "P" && shape != "E") {
        problems.add(ExitCode::data, table.place(row, crown_shape_column),
                     "crown_shape " + config::in_quotes(shape), "P (paraboloid) or E (ellipsoid)");
    }
    return shape == "E" ? CrownShape::ellipsoid : CrownShape::paraboloid;
}

Species read_species(const Table& table, std::size_t row, Problems& problems) {
    Species species;
    for (const TextField& field : text_fields()) {
        field.of(species) = table.text(row, field.column);
    }
    for (const FlagField& field : flag_fields()) {
        field.of(species) = table.whole(row, field.column, {0.0, 1.0}, problems).value_or(0) == 1;
    }
    for (const WholeField& field : whole_fields()) {
        field.of(species) =
            static_cast<int>(table.whole(row, field.column, field.range, problems).value_or(0));
    }
    for (const NumberField& field : number_fields()) {
        field.of(species) = table.number(row, field.column, field.range, problems).value_or(0.0);
    }
    species.crown.shape = read_crown_shape(table, row, problems);
    return species;
}

/// What single ranges cannot say: values that contradict each other.
void check_consistent(const Species& species, const Table& table, std::size_t row, Problems& problems) {
    const auto expect = [&](bool holds, std::string_view column, const std::string& expected) {
        if (!holds) {
            problems.add(ExitCode::data, table.place(row, column),
                         std::string{column} + " " + config::in_quotes(table.text(row, column)) + " of " +
                             config::in_quotes(species.code),
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
    expect(!species.code.empty(), "species_code", "a code");
    expect(!species.latin_name.empty(), "latin_name", "a name");
}

}  // namespace

SpeciesTable SpeciesTable::read(const Table& table) {
    Problems problems;
    table.require(wanted_columns(), problems);
    problems.throw_if_any();
    check_units(table, problems);

    SpeciesTable result;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::size_t problems_before = problems.list().size();
        Species species = read_species(table, row, problems);
        if (problems.list().size() == problems_before) {
            check_consistent(species, table, row, problems);
        }
        for (const std::string_view column : {"species_code", "latin_name"}) {
            const std::string& name = table.text(row, column);
            if (!name.empty() && result.find(name)) {
                problems.add(ExitCode::data, table.place(row, column),
                             config::in_quotes(name) + " a second time", "each species once");
            }
        }
        result.species_.push_back(std::move(species));
    }
    if (table.rows() == 0) {
        problems.add(ExitCode::data, {table.file()}, "no species", "a row for each");
    }
    problems.throw_if_any();
    return result;
}

SpeciesTable SpeciesTable::read(std::istream& in, std::string file) {
    return read(Table::read(in, std::move(file)));
}

SpeciesTable SpeciesTable::shipped() {
    std::istringstream in{std::string{config::shipped_table("species.csv")}};
    return read(in, "species.csv");
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
