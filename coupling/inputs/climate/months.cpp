#include "coupling/inputs/climate/months.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "config/text/joined.hpp"

namespace coupling::climate {
namespace {

using config::joined;

constexpr int months_of_year = 12;
constexpr std::size_t most_missing = 5;         ///< days of a month (WMO 1989, WMO-TD 341)
constexpr std::size_t most_missing_in_row = 3;  ///< the same
constexpr double threshold_degc = 5.5;          ///< as forest/climate/summary

/// The known values of a quantity in a month, and where there are too few of them.
struct DaysOfMonth {
    std::vector<double> known{};
    std::size_t missing = 0;
    std::size_t most_in_row = 0;
    [[nodiscard]] bool suffice() const {
        return !known.empty() && missing <= most_missing && most_in_row <= most_missing_in_row;
    }
};

/// "1981", "1981 to 1983"; of single years a list.
std::string years_in_words(const std::vector<int>& years) {
    std::string text;
    for (std::size_t i = 0; i < years.size();) {
        std::size_t end = i + 1;
        while (end < years.size() && years[end] == years[end - 1] + 1) {
            ++end;
        }
        text += joined(text.empty() ? "" : ", ", std::to_string(years[i]),
                       end > i + 1 ? joined(" to ", std::to_string(years[end - 1])) : "");
        i = end;
    }
    return text;
}

}  // namespace

double in_places(double value) {
    constexpr double places = 1e4;
    return std::round(value * places) / places;
}

void DaysByMonth::add(const Quantity& quantity, const Values& values) {
    columns_.push_back({quantity, values});
}

std::optional<Month> DaysByMonth::month_of(int year, int month, const std::vector<std::size_t>& rows,
                                           std::size_t& filled, std::string& gap) const {
    const auto length = static_cast<std::size_t>(days_of_month(year, month));
    Month made{.year = year, .month = month, .first_row = rows.empty() ? 0 : rows.front()};
    for (const auto& [quantity, values] : columns_) {
        std::vector<std::optional<double>> by_day(length);
        for (const std::size_t row : rows) {
            by_day[static_cast<std::size_t>(dates_[row].day - 1)] = values.of_rows[row];
        }
        DaysOfMonth days;
        std::size_t in_row = 0;
        for (const std::optional<double>& value : by_day) {
            in_row = value ? 0 : in_row + 1;
            days.most_in_row = std::max(days.most_in_row, in_row);
            if (value) {
                days.known.push_back(*value);
            }
        }
        days.missing = length - days.known.size();
        if (!days.suffice()) {
            gap = joined(quantity.column, ", ", std::to_string(year), month < 10 ? "-0" : "-",
                         std::to_string(month));
            return std::nullopt;
        }
        filled += days.missing;
        double sum = 0.0;
        for (const double value : days.known) {
            sum += value;
        }
        const double mean = sum / static_cast<double>(days.known.size());
        made.values.push_back(quantity.of_month == OfMonth::sum ? mean * static_cast<double>(length) : mean);
    }
    add_temperatures(made, rows);
    return made;
}

void DaysByMonth::add_temperatures(Month& month, const std::vector<std::size_t>& rows) const {
    const auto column = [&](std::string_view name) {
        const auto found = std::find_if(columns_.begin(), columns_.end(),
                                        [&](const Column& each) { return each.quantity.column == name; });
        return found == columns_.end() ? nullptr : &found->values;
    };
    const Values* low = column("tmin_c");
    const Values* high = column("tmax_c");
    const Values* mean = column("tave_c");
    if (low == nullptr || high == nullptr) {
        return;
    }
    bool is_first = true;
    std::size_t known = 0;
    for (const std::size_t row : rows) {
        if (!low->of_rows[row] || !high->of_rows[row]) {
            continue;
        }
        const double tmin_degc = *low->of_rows[row];
        const double tave_degc = mean != nullptr && mean->of_rows[row]
                                     ? *mean->of_rows[row]
                                     : 0.5 * (tmin_degc + *high->of_rows[row]);
        month.frost_days += tmin_degc < 0.0 ? 1.0 : 0.0;
        month.degree_days += std::max(0.0, tave_degc - threshold_degc);
        month.lowest_degc = is_first ? tmin_degc : std::min(month.lowest_degc, tmin_degc);
        is_first = false;
        ++known;
    }
    if (known > 0) {  // missing days are as the others
        const double share = days_of_month(month.year, month.month) / static_cast<double>(known);
        month.frost_days = std::round(month.frost_days * share);
        month.degree_days *= share;
    }
}

WholeYears DaysByMonth::whole_years() const {
    std::map<int, std::map<int, std::vector<std::size_t>>> rows;
    for (std::size_t row = 0; row < dates_.size(); ++row) {
        rows[dates_[row].year][dates_[row].month].push_back(row);
    }
    struct Year {
        std::vector<Month> months{};
        std::size_t filled = 0;
        std::string gap{};
    };
    std::map<int, Year> years;
    const int first = rows.begin()->first;
    const int last = rows.rbegin()->first;
    for (int year = first; year <= last; ++year) {
        Year& made = years[year];
        for (int month = 1; month <= months_of_year && made.gap.empty(); ++month) {
            if (auto known = month_of(year, month, rows[year][month], made.filled, made.gap)) {
                made.months.push_back(std::move(*known));
            }
        }
    }
    int best_first = first;
    int best_length = 0;
    int length = 0;
    for (const auto& [year, made] : years) {
        length = made.gap.empty() ? length + 1 : 0;
        if (length > 0 && length >= best_length) {
            best_length = length;
            best_first = year - length + 1;
        }
    }
    WholeYears found;
    std::vector<int> out;
    for (auto& [year, made] : years) {
        if (year >= best_first && year < best_first + best_length) {
            found.months.insert(found.months.end(), made.months.begin(), made.months.end());
            found.filled += made.filled;
            continue;
        }
        out.push_back(year);
        found.is_cut_inside = found.is_cut_inside || made.gap.empty();
    }
    // What ended the run: before it, else behind it.
    const auto gap =
        years.contains(best_first - 1) ? years.find(best_first - 1) : years.find(best_first + best_length);
    found.gap = gap == years.end() ? "" : gap->second.gap;
    found.left_out = years_in_words(out);
    return found;
}

}  // namespace coupling::climate
