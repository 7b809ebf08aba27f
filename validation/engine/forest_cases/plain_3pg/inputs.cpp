#include "validation/engine/forest_cases/plain_3pg/inputs.hpp"

#include <algorithm>
#include <map>

#include "config/text/numbers.hpp"
#include "forest/climate/vapour.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

namespace {

using config::ExitCode;
using config::NumberRange;
using config::Problems;
using config::Table;

constexpr bool above = true;

double number(const Table& table, std::size_t row, std::string_view column, NumberRange range,
              Problems& problems) {
    return table.number(row, column, range, problems).value_or(0.0);
}

/// A month as "2001-01".
YearMonth read_month(const Table& table, std::size_t row, std::string_view column, Problems& problems) {
    const std::string& text = table.text(row, column);
    const std::size_t dash = std::min(text.find('-'), text.size());
    const long long year = config::parse_whole(text.substr(0, dash)).value_or(-1);
    const long long month = dash < text.size() ? config::parse_whole(text.substr(dash + 1)).value_or(0) : 0;
    if (year < 0 || year > 9999 || month < 1 || month > 12) {
        problems.add(ExitCode::data, table.place(row, column),
                     std::string{column} + " " + config::in_quotes(text), "a month such as 2001-01");
        return {};
    }
    return {static_cast<int>(year), static_cast<int>(month)};
}

void check_temperatures(const Table& table, std::size_t row, const ClimateMonth& month, Problems& problems) {
    if (month.tmin_degc > month.tmax_degc) {
        problems.add(ExitCode::data, table.place(row, "tmp_min"),
                     "tmp_min " + table.text(row, "tmp_min") + " above tmp_max " + table.text(row, "tmp_max"),
                     "a minimum below the maximum", "the two columns may be swapped");
    } else if (month.tave_degc < month.tmin_degc || month.tave_degc > month.tmax_degc) {
        problems.add(ExitCode::data, table.place(row, "tmp_ave"),
                     "tmp_ave " + table.text(row, "tmp_ave") + ", tmp_min " + table.text(row, "tmp_min") +
                         ", tmp_max " + table.text(row, "tmp_max"),
                     "a mean between minimum and maximum", "correct it, or leave the column tmp_ave out");
    }
}

ClimateMonth read_climate_month(const Table& table, std::size_t row, Problems& problems) {
    const std::size_t problems_before = problems.list().size();
    ClimateMonth result;
    result.when = {static_cast<int>(table.whole(row, "year", {0, 9999}, problems).value_or(0)),
                   static_cast<int>(table.whole(row, "month", {1, 12}, problems).value_or(1))};
    result.tmin_degc = number(table, row, "tmp_min", {-80, 50}, problems);
    result.tmax_degc = number(table, row, "tmp_max", {-80, 60}, problems);
    result.tave_degc = table.has("tmp_ave") ? number(table, row, "tmp_ave", {-80, 60}, problems)
                                            : 0.5 * (result.tmin_degc + result.tmax_degc);
    if (problems.list().size() == problems_before) {
        check_temperatures(table, row, result, problems);
    }
    result.prec_mm = number(table, row, "prcp", {0, 5000}, problems);
    result.radiation_mjpm2 = number(table, row, "srad", {0, 50}, problems);
    result.frost_days = number(table, row, "frost_days", {0, 31}, problems);
    result.co2_ppm = table.has("co2") ? number(table, row, "co2", {100, 5000}, problems) : 350.0;
    constexpr double kpa_per_mbar = 0.1;
    result.vpd_kpa = table.has("vpd_day")
                         ? kpa_per_mbar * number(table, row, "vpd_day", {0, 100}, problems)
                         : forest::vpd_from_temperatures_kpa(result.tmin_degc, result.tmax_degc);
    return result;
}

}  // namespace

Site read_site(const Table& table) {
    Problems problems;
    table.require({"latitude", "soil_class", "asw_i", "asw_min", "asw_max", "from", "to"}, problems);
    if (table.rows() != 1) {
        problems.add(ExitCode::data, {table.file()}, std::to_string(table.rows()) + " sites", "one");
    }
    problems.throw_if_any();
    Site site;
    site.latitude = config::Angle::from_degrees(number(table, 0, "latitude", {-89, 89}, problems));
    site.soil_class = static_cast<double>(table.whole(0, "soil_class", {-1, 4}, problems).value_or(0));
    site.start_water_mm = number(table, 0, "asw_i", {0, 10000}, problems);
    site.min_water_mm = number(table, 0, "asw_min", {0, 10000}, problems);
    site.max_water_mm = number(table, 0, "asw_max", {0, 10000, above}, problems);
    if (problems.empty() && site.min_water_mm > site.max_water_mm) {
        problems.add(ExitCode::data, table.place(0, "asw_min"),
                     "asw_min " + table.text(0, "asw_min") + " above asw_max " + table.text(0, "asw_max"),
                     "at most what the soil holds, asw_max [mm]");
    }
    site.from = read_month(table, 0, "from", problems);
    site.to = read_month(table, 0, "to", problems);
    if (problems.empty() && site.to.count() < site.from.count()) {
        problems.add(ExitCode::data, table.place(0, "to"), "to " + config::in_quotes(table.text(0, "to")),
                     "a month after " + table.text(0, "from"));
    }
    problems.throw_if_any();
    return site;
}

std::vector<StartingSpecies> read_species(const Table& table) {
    Problems problems;
    table.require({"species", "planted", "fertility", "stems_n", "biom_stem", "biom_root", "biom_foliage"},
                  problems);
    problems.throw_if_any();
    std::vector<StartingSpecies> result;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        result.push_back({table.text(row, "species"), read_month(table, row, "planted", problems),
                          number(table, row, "fertility", {0, 1}, problems),
                          number(table, row, "stems_n", {0, 1e6, above}, problems),
                          number(table, row, "biom_stem", {0, 5000, above}, problems),
                          number(table, row, "biom_root", {0, 5000}, problems),
                          number(table, row, "biom_foliage", {0, 500}, problems)});
    }
    problems.throw_if_any();
    return result;
}

std::vector<ClimateMonth> read_climate(const Table& table, const Site& site) {
    Problems problems;
    table.require({"year", "month", "tmp_min", "tmp_max", "prcp", "srad", "frost_days"}, problems);
    problems.throw_if_any();
    std::map<int, ClimateMonth> months;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const ClimateMonth month = read_climate_month(table, row, problems);
        if (!months.emplace(month.when.count(), month).second) {
            problems.add(ExitCode::data, table.place(row, "month"),
                         "month " + std::to_string(month.when.year) + "-" + std::to_string(month.when.month) +
                             " a second time",
                         "each month once");
        }
    }
    std::vector<ClimateMonth> result;
    for (int count = site.from.count(); count <= site.to.count(); ++count) {
        const auto found = months.find(count);
        if (found != months.end()) {
            result.push_back(found->second);
        } else {
            problems.add(ExitCode::data, {table.file()},
                         "no month " + std::to_string(count / 12) + "-" + std::to_string(count % 12 + 1),
                         "every month of the site's period");
        }
    }
    problems.throw_if_any();
    return result;
}

std::vector<Thinning> read_thinnings(const Table& table) {
    Problems problems;
    table.require({"species", "age", "stems_n", "stem", "root", "foliage"}, problems);
    problems.throw_if_any();
    std::vector<Thinning> result;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        result.push_back({table.text(row, "species"), number(table, row, "age", {0, 10000}, problems),
                          number(table, row, "stems_n", {0, 1e6}, problems),
                          number(table, row, "stem", {0, 100}, problems),
                          number(table, row, "root", {0, 100}, problems),
                          number(table, row, "foliage", {0, 100}, problems)});
    }
    problems.throw_if_any();
    return result;
}

}  // namespace coupling::validation::forest_cases::plain_3pg
