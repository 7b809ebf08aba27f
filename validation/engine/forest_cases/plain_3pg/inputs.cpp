#include "validation/engine/forest_cases/plain_3pg/inputs.hpp"

#include <algorithm>
#include <map>

#include "config/table/schema.hpp"
#include "config/text/numbers.hpp"
#include "forest/climate/vapour.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

namespace {

using config::above;
using config::RowProblems;
using config::Schema;
using config::Table;

struct SiteRow : Site {
    std::string from_text, to_text;
};
struct SpeciesRow : StartingSpecies {
    std::string planted_text;
};
struct ClimateRow : ClimateMonth {
    std::optional<double> mean_degc, vpd_mbar;
};

// Columns and units are those of r3PG.
// clang-format off
Schema<SiteRow> site_columns() {
    using R = SiteRow;
    return {{.role = "site", .setting = "site.csv", .row = "site"},
            {{"latitude", &R::latitude, "", {.range = {-89, 89}}},
             {"soil_class", &R::soil_class, "", {.range = {-1, 4}}},
             {"asw_i", &R::start_water_mm, "", {.range = {0, 10000}}},
             {"asw_min", &R::min_water_mm, "", {.range = {0, 10000}}},
             {"asw_max", &R::max_water_mm, "", {.range = {0, 10000, above}}},
             {"from", &R::from_text, "", {.may_be_empty = true}},
             {"to", &R::to_text, "", {.may_be_empty = true}}}};
}

Schema<SpeciesRow> species_columns() {
    using R = SpeciesRow;
    return {{.role = "species", .setting = "species.csv", .row = "species"},
            {{"species", &R::species, "", {.may_be_empty = true}},
             {"planted", &R::planted_text, "", {.may_be_empty = true}},
             {"fertility", &R::fertility, "", {.range = {0, 1}}},
             {"stems_n", &R::stems_pha, "", {.range = {0, 1e6, above}}},
             {"biom_stem", &R::stem_tpha, "", {.range = {0, 5000, above}}},
             {"biom_root", &R::root_tpha, "", {.range = {0, 5000}}},
             {"biom_foliage", &R::foliage_tpha, "", {.range = {0, 500}}}}};
}

Schema<ClimateRow> climate_columns() {
    using R = ClimateRow;
    return {{.role = "climate", .setting = "climate.csv", .row = "month", .unique_together = {{"year", "month"}}},
            {{"year", [](R& r) -> auto& { return r.when.year; }, "", {.range = {0, 9999}}},
             {"month", [](R& r) -> auto& { return r.when.month; }, "", {.range = {1, 12}}},
             {"tmp_min", &R::tmin_degc, "", {.range = {-80, 50}}},
             {"tmp_max", &R::tmax_degc, "", {.range = {-80, 60}}},
             {"tmp_ave", &R::mean_degc, "", {.range = {-80, 60}}},
             {"prcp", &R::prec_mm, "", {.range = {0, 5000}}},
             {"srad", &R::radiation_mjpm2, "", {.range = {0, 50}}},
             {"frost_days", &R::frost_days, "", {.range = {0, 31}}},
             {"co2", &R::co2_ppm, "", {.range = {100, 5000}, .optional = true}},
             {"vpd_day", &R::vpd_mbar, "", {.range = {0, 100}}}}};
}

Schema<Thinning> thinning_columns() {
    using R = Thinning;
    return {{.role = "thinning", .setting = "thinning.csv", .row = "thinning"},
            {{"species", &R::species, "", {.may_be_empty = true}},
             {"age", &R::age_years, "", {.range = {0, 10000}}},
             {"stems_n", &R::stems_pha, "", {.range = {0, 1e6}}},
             {"stem", &R::stem, "", {.range = {0, 100}}},
             {"root", &R::root, "", {.range = {0, 100}}},
             {"foliage", &R::foliage, "", {.range = {0, 100}}}}};
}
// clang-format on

/// A month as "2001-01".
YearMonth read_month(const std::string& text, std::size_t row, const std::string& column,
                     RowProblems& wrong) {
    const std::size_t dash = std::min(text.find('-'), text.size());
    const long long year = config::parse_whole(text.substr(0, dash)).value_or(-1);
    const long long month = dash < text.size() ? config::parse_whole(text.substr(dash + 1)).value_or(0) : 0;
    if (year < 0 || year > 9999 || month < 1 || month > 12) {
        wrong.refuse(row, column, column + " " + config::in_quotes(text), "a month such as 2001-01");
        return {};
    }
    return {static_cast<int>(year), static_cast<int>(month)};
}

void check_temperatures(const Table& table, const config::Read<ClimateRow>& month, RowProblems& wrong) {
    const auto text = [&](const char* column) {
        return std::string{column} + " " + table.text(month.row, column);
    };
    if (month.tmin_degc > month.tmax_degc) {
        wrong.refuse(month.row, "tmp_min", text("tmp_min") + " above " + text("tmp_max"),
                     "a minimum below the maximum", "the two columns may be swapped");
    } else if (month.tave_degc < month.tmin_degc || month.tave_degc > month.tmax_degc) {
        wrong.refuse(month.row, "tmp_ave", text("tmp_ave") + ", " + text("tmp_min") + ", " + text("tmp_max"),
                     "a mean between minimum and maximum", "correct it, or leave the column tmp_ave out");
    }
}

}  // namespace

Site read_site(const Table& table) {
    RowProblems wrong{table};
    std::vector<config::Read<SiteRow>> sites = site_columns().rows(table, wrong);
    if (table.rows() != 1) {
        wrong.refuse(std::to_string(table.rows()) + " sites", "one");
    }
    for (config::Read<SiteRow>& site : sites) {
        if (site.min_water_mm > site.max_water_mm) {
            wrong.refuse(site.row, "asw_min",
                         "asw_min " + table.text(0, "asw_min") + " above asw_max " + table.text(0, "asw_max"),
                         "at most what the soil holds, asw_max [mm]");
        }
        site.from = read_month(site.from_text, site.row, "from", wrong);
        site.to = read_month(site.to_text, site.row, "to", wrong);
        if (wrong.empty() && site.to.count() < site.from.count()) {
            wrong.refuse(site.row, "to", "to " + config::in_quotes(site.to_text),
                         "a month after " + site.from_text);
        }
    }
    wrong.throw_first();
    return sites.front();
}

std::vector<StartingSpecies> read_species(const Table& table) {
    RowProblems wrong{table};
    std::vector<StartingSpecies> result;
    for (config::Read<SpeciesRow>& row : species_columns().rows(table, wrong)) {
        row.planted = read_month(row.planted_text, row.row, "planted", wrong);
        result.push_back(row);
    }
    wrong.throw_first();
    return result;
}

std::vector<ClimateMonth> read_climate(const Table& table, const Site& site) {
    constexpr double kpa_per_mbar = 0.1;
    RowProblems wrong{table};
    std::map<int, ClimateMonth> months;
    for (config::Read<ClimateRow>& row : climate_columns().rows(table, wrong)) {
        row.tave_degc = row.mean_degc.value_or(0.5 * (row.tmin_degc + row.tmax_degc));
        row.vpd_kpa = row.vpd_mbar ? kpa_per_mbar * *row.vpd_mbar
                                   : forest::vpd_from_temperatures_kpa(row.tmin_degc, row.tmax_degc);
        check_temperatures(table, row, wrong);
        months.emplace(row.when.count(), row);
    }
    std::vector<ClimateMonth> result;
    for (int count = site.from.count(); count <= site.to.count(); ++count) {
        const auto found = months.find(count);
        if (found != months.end()) {
            result.push_back(found->second);
        } else {
            wrong.refuse("no month " + std::to_string(count / 12) + "-" + std::to_string(count % 12 + 1),
                         "every month of the site's period");
        }
    }
    wrong.throw_first();
    return result;
}

std::vector<Thinning> read_thinnings(const Table& table) {
    const auto rows = thinning_columns().all(table);
    return {rows.begin(), rows.end()};
}

}  // namespace coupling::validation::forest_cases::plain_3pg
