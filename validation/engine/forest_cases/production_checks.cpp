#include "validation/engine/forest_cases/production_checks.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "validation/engine/forest_cases/shared/plot_checks.hpp"
#include "validation/engine/forest_cases/shared/unknown_columns.hpp"

namespace coupling::validation::forest_cases {
namespace {

using config::joined;
using plain_3pg::ClimateMonth;

/// No forest grows with less in a year [mm].
constexpr double least_rain_mm = 150.0;

double mean_of_month(const std::vector<ClimateMonth>& climate, int month) {
    double sum_degc = 0.0;
    double months = 0.0;
    for (const ClimateMonth& one : climate) {
        if (one.when.month == month) {
            sum_degc += one.tave_degc;
            months += 1.0;
        }
    }
    return months > 0.0 ? sum_degc / months : std::nan("");
}

double yearly_rain_mm(const std::vector<ClimateMonth>& climate) {
    double sum_mm = 0.0;
    for (const ClimateMonth& month : climate) {
        sum_mm += month.prec_mm;
    }
    return 12.0 * sum_mm / static_cast<double>(climate.size());
}

}  // namespace

void warn_of_site(const config::Table& table, config::Warnings& warnings) {
    warn_of_unknown_columns(
        table, {"latitude", "altitude", "soil_class", "asw_i", "asw_min", "asw_max", "from", "to"}, warnings);
}

void warn_of_start(const config::Table& table, config::Warnings& warnings) {
    warn_of_unknown_columns(
        table, {"species", "planted", "fertility", "stems_n", "biom_stem", "biom_root", "biom_foliage"},
        warnings);
}

void warn_of_climate(const config::Table& table, const std::vector<ClimateMonth>& months,
                     config::Warnings& warnings) {
    warn_of_unknown_columns(table,
                            {"year", "month", "tmp_min", "tmp_max", "tmp_ave", "prcp", "srad", "frost_days",
                             "vpd_day", "co2", "d13catm"},
                            warnings);
    constexpr std::size_t a_year = 12;
    if (const double rain_mm = yearly_rain_mm(months); months.size() >= a_year && rain_mm < least_rain_mm) {
        warnings.add(joined(table.file(), ": prcp is ", config::to_text(std::round(rain_mm)),
                            " mm a year: no forest grows with so little; write it in mm a month"));
    }
}

void note_late_planting(const std::string& run, const plain_3pg::Inputs& inputs, config::Warnings& warnings) {
    const auto first =
        std::min_element(inputs.species.begin(), inputs.species.end(),
                         [](const auto& a, const auto& b) { return a.planted.count() < b.planted.count(); });
    if (first->planted.count() > inputs.site.from.count()) {
        warnings.add_note(joined("run ", run, " begins before its first species is planted, in month ",
                                 std::to_string(first->planted.month), " of ",
                                 std::to_string(first->planted.year), "; nothing stands before"));
    }
}

void check_latitude(const config::Table& site, const config::Table& climate,
                    const plain_3pg::Inputs& inputs) {
    const double january_degc = mean_of_month(inputs.climate, 1);
    const double july_degc = mean_of_month(inputs.climate, 7);
    if (std::isnan(january_degc) || std::isnan(july_degc)) {
        return;
    }
    constexpr double clear_k = 3.0;
    config::Problems problems;
    check_hemisphere({.latitude_deg = inputs.site.latitude.in_degrees(),
                      .january = january_degc,
                      .july = july_degc,
                      .clear = clear_k},
                     site.place(0, "latitude"), joined("latitude ", site.text(0, "latitude")), climate.file(),
                     problems);
    problems.throw_if_any();
}

}  // namespace coupling::validation::forest_cases
