#pragma once

#include <vector>

#include "config/table/table.hpp"

namespace forest {

/// CO2 of the air by year: straight between the years given, constant before the first and after the last.
class Co2Series {
public:
    /// Reads year,co2 (ppm) in rising order of years. Throws InputError (data).
    static Co2Series read(const config::Table& table);
    /// 310 ppm in 1950, 360 in 1995, 420 in 2023: config/data/co2.csv.
    static Co2Series shipped();
    /// The same in all years.
    static Co2Series constant(double co2_ppm);

    [[nodiscard]] double ppm(int year) const;

private:
    struct Point {
        int year;
        double ppm;
    };
    std::vector<Point> points_;
};

}  // namespace forest
