#include "forest/disturbance/beetle_season.hpp"

#include <algorithm>
#include <numbers>

#include "config/math/elementary.hpp"
#include "forest/climate/calendar.hpp"
#include "forest/climate/normal.hpp"
#include "forest/production/day_length.hpp"

namespace forest {

namespace {

constexpr int days_of_year = 365;
constexpr int first_of_april = 90;
constexpr double base_degc = 8.3;
constexpr double cut_degc = 38.9;
constexpr double waking_degree_days = 140.0;
constexpr double flight_degc = 16.5;
constexpr double brood_degree_days = 557.0;
constexpr int solstice = 172;
constexpr double least_day_h = 14.5;
constexpr double sister_share = 0.5;
constexpr double counted_share = 0.6;

using Months = std::array<double, 12>;
using Days = std::array<double, days_of_year>;

Days days_between(const Months& months) {
    Days days{};
    for (int day = 0; day < days_of_year; ++day) {
        int next = 0;  // month whose middle comes next, 0-11; 0 also after the middle of December
        while (next < 12 && middle_day(next + 1) <= day + 1) {
            ++next;
        }
        const int before_day = next == 0 ? middle_day(12) - days_of_year : middle_day(next);
        const int after_day = next == 12 ? middle_day(1) + days_of_year : middle_day(next + 1);
        const double share = static_cast<double>(day + 1 - before_day) / (after_day - before_day);
        const double s = config::sin_cos_of(0.5 * std::numbers::pi * share).sin;
        const double before = months[static_cast<std::size_t>((next + 11) % 12)];
        const double after = months[static_cast<std::size_t>(next % 12)];
        days[static_cast<std::size_t>(day)] = before + (after - before) * s * s;
    }
    return days;
}

template <class Value>
Months months_of(const ClimateYear& year, Value value) {
    Months months{};
    for (std::size_t m = 0; m < months.size(); ++m) {
        months[m] = value(year.months[m]);
    }
    return months;
}

/// Day of the first flight, days_of_year if there is none.
int first_flight(const Days& max_degc) {
    double degree_days = 0.0;
    for (int day = first_of_april; day < days_of_year; ++day) {
        const double degc = max_degc[static_cast<std::size_t>(day)];
        degree_days += std::max(0.0, degc - base_degc);
        if (degree_days >= waking_degree_days && degc > flight_degc) {
            return day;
        }
    }
    return days_of_year;
}

}  // namespace

BeetleDays beetle_days(const ClimateYear& year, config::Angle latitude) {
    constexpr double wh_per_mj = 1.0 / 0.0036;
    Months day_length_h{};
    for (int month = 1; month <= 12; ++month) {
        day_length_h[static_cast<std::size_t>(month - 1)] = day_length_s(latitude, month) / 3600.0;
    }
    return {.mean_degc = days_between(months_of(year, [](const ClimateMonth& m) { return m.tave_degc; })),
            .max_degc = days_between(months_of(year, [](const ClimateMonth& m) { return m.tmax_degc; })),
            .radiation_whpm2 = days_between(
                months_of(year, [](const ClimateMonth& m) { return wh_per_mj * m.radiation_mjpm2; })),
            .day_length_h = days_between(day_length_h)};
}

Broods broods_of(const BeetleDays& days, double ground_light) {
    const int start = first_flight(days.max_degc);
    Broods broods;
    if (start == days_of_year) {
        return broods;
    }
    // Heat gathered until the end of a day.
    Days heat{};
    double sum = 0.0;
    for (std::size_t d = 0; d < heat.size(); ++d) {
        const double bark_degc =
            -0.173 + 0.0008518 * days.radiation_whpm2[d] * ground_light + 1.054 * days.mean_degc[d];
        sum += std::max(0.0, std::min(bark_degc, cut_degc) - base_degc);
        heat[d] = sum;
    }
    const auto day_with = [&heat](double degree_days) {
        return static_cast<std::size_t>(std::lower_bound(heat.begin(), heat.end(), degree_days) -
                                        heat.begin());
    };
    const auto may_begin = [&](std::size_t day) {
        return day < heat.size() && (day < solstice || days.day_length_h[day] >= least_day_h);
    };
    const auto counts = [&](std::size_t day) {
        return heat.back() - heat[day] >= counted_share * brood_degree_days;
    };
    auto day = static_cast<std::size_t>(start);
    while (may_begin(day) && counts(day)) {
        ++broods.generations;
        const std::size_t sister = day_with(heat[day] + sister_share * brood_degree_days);
        broods.sister = broods.sister || (may_begin(sister) && counts(sister));
        day = day_with(heat[day] + brood_degree_days);
    }
    return broods;
}

double cold_days(const ClimateYear& year) {
    constexpr double deadly_degc = -15.0;
    double days = 0.0;
    for (int month = 1; month <= 12; ++month) {
        const double tmin_degc = year.months[static_cast<std::size_t>(month - 1)].tmin_degc;
        days += days_in_month(month) * normal_probability((deadly_degc - tmin_degc) / daily_scatter_k);
    }
    return days;
}

double winter_survival(double cold_days) {
    return 0.6 * config::exp_of(-0.1005 * cold_days);
}

}  // namespace forest
