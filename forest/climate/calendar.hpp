#pragma once

#include <array>
#include <cstddef>

namespace forest {

/// Days in a month (1-12); February has 28, as in 3-PG.
constexpr int days_in_month(int month) {
    constexpr std::array<int, 12> days{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    return days[static_cast<std::size_t>(month - 1)];
}

/// Day of the year that stands for a month (1-12).
constexpr int middle_day(int month) {
    constexpr std::array<int, 12> middle{15, 46, 74, 105, 135, 166, 196, 227, 258, 288, 319, 349};
    return middle[static_cast<std::size_t>(month - 1)];
}

constexpr double seconds_per_day = 86400.0;

}  // namespace forest
