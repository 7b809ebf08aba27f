#include "coupling/inputs/climate/sunshine.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/climate/dates.hpp"
#include "coupling/inputs/climate/months.hpp"
#include "forest/climate/calendar.hpp"
#include "forest/light/sun.hpp"
#include "forest/production/day_length.hpp"

namespace coupling::climate {
namespace {

constexpr double without_sun = 0.25;  ///< of extraterrestrial radiation (FAO-56, equation 35)
constexpr double by_sun = 0.50;       ///< the same
constexpr double by_range = 0.16;     ///< per root of a kelvin, inland (FAO-56, equation 50)
constexpr double seconds_of_hour = 3600.0;

double radiation_mjpm2(config::Angle latitude, const Date& date, double sunshine_h) {
    const double possible_h =
        days_of_month(date.year, date.month) * forest::day_length_s(latitude, date.month) / seconds_of_hour;
    const double share = possible_h > 0.0 ? std::min(1.0, sunshine_h / possible_h) : 0.0;
    return (without_sun + by_sun * share) *
           forest::extraterrestrial_mjpm2(latitude, forest::middle_day(date.month));
}

/// After Hargreaves: clear days warm up more than dark ones.
std::string take_range_of_temperatures(config::Table& table, config::Angle latitude) {
    std::vector<std::string> radiation;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto month = config::parse_whole(table.text(row, "month"));
        const auto tmin_degc = config::parse_number(table.text(row, "tmin_c"));
        const auto tmax_degc = config::parse_number(table.text(row, "tmax_c"));
        const bool is_month = month && *month >= 1 && *month <= 12 && tmin_degc && tmax_degc;
        radiation.push_back(is_month ? config::to_text(in_places(
                                           by_range * std::sqrt(std::max(0.0, *tmax_degc - *tmin_degc)) *
                                           forest::extraterrestrial_mjpm2(
                                               latitude, forest::middle_day(static_cast<int>(*month)))))
                                     : "");
    }
    table.add_column("rad_mj_m2_d", std::move(radiation), "tmax_c");
    return config::joined(table.file(),
                          ": no radiation and no sunshine; radiation is made from the daily range of "
                          "temperatures, which is up to 15 % high over a year, and up to 31 % in a month");
}

}  // namespace

std::string take_sunshine(config::Table& table, config::Angle latitude) {
    if (table.find("rad_mj_m2_d") || !table.find("year") || !table.find("month")) {
        return "";
    }
    if (!table.find("sunshine_h")) {
        return table.find("tmin_c") && table.find("tmax_c") ? take_range_of_temperatures(table, latitude)
                                                            : "";
    }
    std::vector<std::string> radiation;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto year = config::parse_whole(table.text(row, "year"));
        const auto month = config::parse_whole(table.text(row, "month"));
        const auto hours = config::parse_number(table.text(row, "sunshine_h"));
        const bool is_month = year && month && *month >= 1 && *month <= 12 && hours && *hours >= 0.0;
        radiation.push_back(
            is_month ? config::to_text(in_places(radiation_mjpm2(
                           latitude, {static_cast<int>(*year), static_cast<int>(*month), 0}, *hours)))
                     : "");
    }
    table.add_column("rad_mj_m2_d", std::move(radiation), "sunshine_h");
    return config::joined(table.file(),
                          ": no radiation; it is made from sunshine hours, which is a few percent "
                          "low between mountains");
}

}  // namespace coupling::climate
