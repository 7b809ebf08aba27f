#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "coupling/inputs/climate/dates.hpp"
#include "coupling/inputs/climate/quantities.hpp"

namespace coupling::climate {

/// A month made of its days.
struct Month {
    int year = 0;
    int month = 0;
    std::size_t first_row = 0;
    std::vector<double> values{};  ///< of the quantities, in the order in which they were added
    double frost_days = 0.0;       ///< with a minimum below 0 degC
    double degree_days = 0.0;      ///< sum of the daily means above 5.5 degC
    double lowest_degc = 0.0;
};

/// The longest run of years of which each month is known; of equal runs the last.
struct WholeYears {
    std::vector<Month> months{};  ///< January first, all twelve of each year
    std::size_t filled = 0;       ///< values of single days that were missing in these months
    std::string left_out{};       ///< "1981, 1995 to 1997"; "" where no year is
    bool is_cut_inside = false;   ///< a gap parts years that are known
    std::string gap{};            ///< that the run ends at: "tmin_c, 2000-07"
};

/// Days of a place, on their way into months.
class DaysByMonth {
public:
    explicit DaysByMonth(const std::vector<Date>& dates) : dates_{dates} {}
    void add(const Quantity& quantity, const Values& values);
    [[nodiscard]] WholeYears whole_years() const;

private:
    struct Column {
        Quantity quantity;
        const Values& values;
    };
    [[nodiscard]] std::optional<Month> month_of(int year, int month, const std::vector<std::size_t>& rows,
                                                std::size_t& filled, std::string& gap) const;
    void add_temperatures(Month& month, const std::vector<std::size_t>& rows) const;

    const std::vector<Date>& dates_;
    std::vector<Column> columns_;
};

/// Rounded to four places, which is finer than any service measures.
double in_places(double value);

}  // namespace coupling::climate
