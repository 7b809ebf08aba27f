#include "validation/engine/forest_cases/plain_3pg/parameters.hpp"

#include <algorithm>
#include <array>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

namespace {

using config::ExitCode;
using config::Problems;
using config::Table;

constexpr bool without_bound = true;  // the lower bound itself is excluded

#define AT(member) [](Parameters& p) -> double& { return p.member; }

// Names, units and defaults are those of r3PG (Trotsiuk, Hartig & Forrester 2020).
// clang-format off
constexpr ParameterField fields[] = {
    {"pFS2", "-", 1.0, {0, 100, without_bound}, AT(foliage_to_stem.at_2cm)},
    {"pFS20", "-", 0.15, {0, 100, without_bound}, AT(foliage_to_stem.at_20cm)},
    {"aWS", "-", 0.095, {0, 100, without_bound}, AT(stem_mass.factor)},
    {"nWS", "-", 2.4, {0, 10, without_bound}, AT(stem_mass.exponent)},
    {"pRx", "-", 0.8, {0, 1, without_bound}, AT(root_share.max)},
    {"pRn", "-", 0.25, {0, 1, without_bound}, AT(root_share.min)},
    {"gammaF1", "1/month", 0.027, {0, 1}, AT(litterfall.mature_pmonth)},
    {"gammaF0", "1/month", 0.001, {0, 1}, AT(litterfall.initial_pmonth)},
    {"tgammaF", "month", 12, {0, 10000}, AT(litterfall.median_months)},
    {"gammaR", "1/month", 0.015, {0, 1}, AT(root_turnover_pmonth)},
    {"leafgrow", "month", 0, {0, 12}, AT(leaf_grow_month)},
    {"leaffall", "month", 0, {0, 12}, AT(leaf_fall_month)},
    {"Tmin", "degC", 8.5, {-50, 50}, AT(temperature.min_degc)},
    {"Topt", "degC", 16, {-50, 50}, AT(temperature.optimum_degc)},
    {"Tmax", "degC", 40, {-50, 80}, AT(temperature.max_degc)},
    {"kF", "-", 0, {0, 30}, AT(frost_loss)},
    {"SWconst", "-", 0.7, {0, 1000}, AT(soil_water.half_deficit)},
    {"SWpower", "-", 9, {0, 100}, AT(soil_water.power)},
    {"fCalpha700", "-", 1.4, {0, 1.99, without_bound}, AT(assimilation_at_700)},
    {"fCg700", "-", 0.7, {0, 2, without_bound}, AT(conductance_at_700)},
    {"m0", "-", 0, {0, 1}, AT(root_response_at_zero)},
    {"fN0", "-", 1, {0, 1}, AT(nutrition.at_zero)},
    {"fNn", "-", 0, {0, 100}, AT(nutrition.power)},
    {"MaxAge", "year", 50, {0, 100000, without_bound}, AT(age.max_years)},
    {"nAge", "-", 4, {0, 100}, AT(age.power)},
    {"rAge", "-", 0.95, {0, 100, without_bound}, AT(age.relative_half)},
    {"gammaN1", "%/year", 0, {0, 1200}, AT(random_mortality.mature)},
    {"gammaN0", "%/year", 0, {0, 1200}, AT(random_mortality.initial)},
    {"tgammaN", "year", 0, {0, 100000}, AT(random_mortality.median_years)},
    {"ngammaN", "-", 1, {0, 100}, AT(random_mortality.shape)},
    {"wSx1000", "kg", 300, {0, 100000, without_bound}, AT(self_thinning.at_1000_kg)},
    {"thinPower", "-", 1.5, {0, 10, without_bound}, AT(self_thinning.power)},
    {"mF", "-", 0, {0, 10}, AT(lost.foliage)},
    {"mR", "-", 0.2, {0, 10}, AT(lost.root)},
    {"mS", "-", 0.2, {0, 10}, AT(lost.stem)},
    {"SLA0", "m2/kg", 11, {0, 1000, without_bound}, AT(sla_m2pkg.young)},
    {"SLA1", "m2/kg", 4, {0, 1000, without_bound}, AT(sla_m2pkg.mature)},
    {"tSLA", "year", 2.5, {0, 10000}, AT(sla_m2pkg.half_years)},
    {"k", "-", 0.5, {0, 10, without_bound}, AT(extinction)},
    {"fullCanAge", "year", 3, {0, 1000}, AT(full_canopy_years)},
    {"MaxIntcptn", "-", 0.15, {0, 1}, AT(interception.max_share)},
    {"LAImaxIntcptn", "m2/m2", 0, {0, 100}, AT(interception.full_lai)},
    {"cVPD", "m2/m2", 5, {0, 1000, without_bound}, AT(vpd_halving_lai)},
    {"alphaCx", "mol/mol", 0.06, {0, 1}, AT(quantum_efficiency)},
    {"Y", "-", 0.47, {0, 1}, AT(light_use.npp_share)},
    {"MinCond", "m/s", 0, {0, 1}, AT(min_conductance_mps)},
    {"MaxCond", "m/s", 0.02, {0, 1}, AT(max_conductance_mps)},
    {"LAIgcx", "m2/m2", 3.33, {0, 100, without_bound}, AT(full_conductance_lai)},
    {"CoeffCond", "1/mbar", 0.05, {0, 10}, AT(vpd_sensitivity_pmbar)},
    {"BLcond", "m/s", 0.2, {0, 10, without_bound}, AT(boundary_layer_mps)},
    {"fracBB0", "-", 0.75, {0, 1}, AT(branch_share.young)},
    {"fracBB1", "-", 0.15, {0, 1}, AT(branch_share.mature)},
    {"tBB", "year", 2, {0, 10000}, AT(branch_share.half_years)},
    {"rhoMin", "t/m3", 0.45, {0, 3, without_bound}, AT(wood_density_tpm3.young)},
    {"rhoMax", "t/m3", 0.45, {0, 3, without_bound}, AT(wood_density_tpm3.mature)},
    {"tRho", "year", 4, {0, 10000}, AT(wood_density_tpm3.half_years)},
    {"aH", "-", 0, {-1000, 1000}, AT(height_m.factor)},
    {"nHB", "-", 0, {-1000, 1000}, AT(height_m.dbh)},
    {"nHC", "-", 0, {-100, 100}, AT(height_m.competition)},
    {"aV", "-", 0, {0, 1000}, AT(volume_m3.factor)},
    {"nVB", "-", 0, {-100, 100}, AT(volume_m3.dbh)},
    {"nVH", "-", 0, {-100, 100}, AT(volume_m3.height)},
    {"nVBH", "-", 0, {-100, 100}, AT(volume_m3.joint)},
    {"aK", "-", 0, {0, 1000}, AT(crown_width_m.factor)},
    {"nKB", "-", 0, {-100, 100}, AT(crown_width_m.dbh)},
    {"nKH", "-", 0, {-100, 100}, AT(crown_width_m.height)},
    {"nKC", "-", 0, {-100, 100}, AT(crown_width_m.competition)},
    {"nKrh", "-", 0, {-100, 100}, AT(crown_width_m.relative_height)},
    {"aHL", "-", 0, {-1000, 1000}, AT(crown_length_m.factor)},
    {"nHLB", "-", 0, {-1000, 1000}, AT(crown_length_m.dbh)},
    {"nHLL", "-", 0, {-100, 100}, AT(crown_length_m.lai)},
    {"nHLC", "-", 0, {-100, 100}, AT(crown_length_m.competition)},
    {"nHLrh", "-", 0, {-100, 100}, AT(crown_length_m.relative_height)},
    {"Qa", "W/m2", -90, {-1000, 1000}, AT(net_radiation.intercept_wpm2)},
    {"Qb", "-", 0.8, {0, 10}, AT(net_radiation.slope)},
    {"gDM_mol", "g/mol", 24, {0, 1000, without_bound}, AT(light_use.dry_matter_gpmol)},
    {"molPAR_MJ", "mol/MJ", 2.3, {0, 100, without_bound}, AT(light_use.photons_molpmj)},
};
// clang-format on

#undef AT

constexpr std::string_view crown_form_name = "crownshape";
constexpr std::array<std::string_view, 4> carbon_isotopes{"RGcGw", "D13CTissueDif", "aFracDiffu",
                                                          "bFracRubi"};

bool is_known(std::string_view name) {
    return name == crown_form_name ||
           std::find(carbon_isotopes.begin(), carbon_isotopes.end(), name) != carbon_isotopes.end() ||
           std::any_of(std::begin(fields), std::end(fields),
                       [&](const ParameterField& field) { return field.name == name; });
}

/// Row of each parameter; all rows are checked on the way.
class Rows {
public:
    Rows(const Table& table, Problems& problems) : table_{table} {
        std::vector<std::string> names;
        for (const ParameterField& field : fields) {
            names.emplace_back(field.name);
        }
        for (std::size_t row = 0; row < table.rows(); ++row) {
            const std::string& name = table.text(row, "parameter");
            if (!is_known(name)) {
                const std::string nearest = config::nearest_word(name, names);
                problems.add(ExitCode::data, table.place(row, "parameter"),
                             "parameter " + config::in_quotes(name),
                             nearest.empty() ? "a parameter of 3-PG" : config::in_quotes(nearest));
            } else if (row_of(name) < row) {
                problems.add(ExitCode::data, table.place(row, "parameter"),
                             "parameter " + config::in_quotes(name) + " a second time", "each once");
            }
        }
    }

    /// The first row of a name; the number of rows if there is none.
    [[nodiscard]] std::size_t row_of(std::string_view name) const {
        for (std::size_t row = 0; row < table_.rows(); ++row) {
            if (table_.text(row, "parameter") == name) {
                return row;
            }
        }
        return table_.rows();
    }

private:
    const Table& table_;
};

Parameters read_column(const Table& table, const Rows& rows, const std::string& column, Problems& problems) {
    Parameters result;
    result.species = column;
    for (const ParameterField& field : fields) {
        const std::size_t row = rows.row_of(field.name);
        field.of(result) = row < table.rows() ? table.number(row, column, field.range, problems).value_or(0.0)
                                              : field.default_value;
    }
    if (const std::size_t row = rows.row_of(crown_form_name); row < table.rows()) {
        result.crown_form =
            static_cast<CrownForm>(table.whole(row, column, {1.0, 4.0}, problems).value_or(3));
    }
    return result;
}

}  // namespace

bool dormant(const Parameters& species, int month) {
    const double grow = species.leaf_grow_month;
    const double fall = species.leaf_fall_month;
    if (grow > fall) {  // leaves in the winter of the calendar: the southern half of the world
        return month >= fall && month <= grow;
    }
    return grow < fall && (month < grow || month >= fall);
}

std::span<const ParameterField> parameter_fields() {
    return fields;
}

std::vector<Parameters> read_parameters(const Table& table) {
    Problems problems;
    table.require({"parameter"}, problems);
    problems.throw_if_any();
    const Rows rows{table, problems};
    std::vector<Parameters> result;
    for (const std::string& column : table.columns()) {
        if (column != "parameter") {
            result.push_back(read_column(table, rows, column, problems));
        }
    }
    if (result.empty()) {
        problems.add(ExitCode::data, {table.file()}, "no species", "a column for each",
                     "call the columns as the species are spelt in the other tables");
    }
    if (table.rows() == 0) {
        problems.add(ExitCode::data, {table.file()}, "no parameter",
                     "a row for each parameter of 3-PG that is known, such as alphaCx or k",
                     "add the rows: no stand grows on defaults alone");
    }
    problems.throw_if_any();
    return result;
}

std::vector<std::string> defaults_in(const Table& table) {
    Problems reported;  // by read_parameters
    const Rows rows{table, reported};
    std::vector<std::string> filled;
    for (const ParameterField& field : fields) {
        if (rows.row_of(field.name) == table.rows()) {
            filled.push_back(config::joined(field.name, " = ", config::to_text(field.default_value)));
        }
    }
    if (rows.row_of(crown_form_name) == table.rows()) {
        filled.push_back(config::joined(crown_form_name, " = ",
                                        std::to_string(static_cast<int>(Parameters{}.crown_form))));
    }
    return filled;
}

}  // namespace coupling::validation::forest_cases::plain_3pg
