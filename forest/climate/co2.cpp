#include "forest/climate/co2.hpp"

#include <algorithm>
#include <string>

#include "config/data/shipped_tables.hpp"

namespace forest {

Co2Series Co2Series::read(const config::Table& table) {
    config::Problems problems;
    table.require({"year", "co2"}, problems);
    problems.throw_if_any();
    Co2Series series;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto year = table.whole(row, "year", {0.0, 9999.0}, problems);
        const auto ppm = table.number(row, "co2", {150.0, 2000.0}, problems);
        if (!year || !ppm) {
            continue;
        }
        if (!series.points_.empty() && *year <= series.points_.back().year) {
            problems.add(config::ExitCode::data, table.place(row, "year"), "year " + table.text(row, "year"),
                         "a year after " + std::to_string(series.points_.back().year));
        }
        series.points_.push_back({static_cast<int>(*year), *ppm});
    }
    if (problems.empty() && series.points_.empty()) {
        problems.add(config::ExitCode::data, {table.file()}, "no years", "at least one");
    }
    problems.throw_if_any();
    return series;
}

Co2Series Co2Series::shipped() {
    return read(config::read_shipped_table("co2.csv"));
}

Co2Series Co2Series::constant(double co2_ppm) {
    Co2Series series;
    series.points_.push_back({0, co2_ppm});
    return series;
}

double Co2Series::ppm(int year) const {
    const auto after =
        std::find_if(points_.begin(), points_.end(), [&](const Point& point) { return point.year >= year; });
    if (after == points_.end()) {
        return points_.back().ppm;
    }
    if (after == points_.begin() || after->year == year) {
        return after->ppm;
    }
    const Point& before = *(after - 1);
    const double share = static_cast<double>(year - before.year) / (after->year - before.year);
    return before.ppm + share * (after->ppm - before.ppm);
}

}  // namespace forest
