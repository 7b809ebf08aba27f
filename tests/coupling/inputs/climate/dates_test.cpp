#include "coupling/inputs/climate/dates.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <string>

namespace coupling::climate_dates_test {
namespace {

using climate::Date;
using climate::date_of;
using climate::DateOrder;

std::string two(int number) {
    return (number < 10 ? "0" : "") + std::to_string(number);
}

TEST(Dates, AreReadInEachOfTheFormsOfServices) {
    EXPECT_TRUE(rc::check([] {
        const int year = *rc::gen::inRange(1800, 2200);
        const int month = *rc::gen::inRange(1, 13);
        const int day = *rc::gen::inRange(1, climate::days_of_month(year, month) + 1);
        const Date date{year, month, day};
        const std::string y = std::to_string(year);
        const std::string m = two(month);
        const std::string d = two(day);
        const std::string time = *rc::gen::element(std::string{}, std::string{" 00:00"});
        RC_ASSERT(date_of(y + m + d) == date);
        RC_ASSERT(date_of(y + m + d + "06") == date);
        RC_ASSERT(date_of(y + "-" + m + "-" + d + time) == date);
        RC_ASSERT(date_of(y + "-" + m + "-" + d + "T00:00:00+00:00") == date);
        RC_ASSERT(date_of(y + "/" + m + "/" + d + time) == date);
        RC_ASSERT(date_of(d + "." + m + "." + y + time) == date);
        RC_ASSERT(date_of(std::to_string(day) + "." + std::to_string(month) + "." + y) == date);
        RC_ASSERT(date_of(m + "/" + d + "/" + y + time, DateOrder::month_first) == date);
        RC_ASSERT(date_of(y + m) == (Date{year, month, 0}));
        RC_ASSERT(date_of(y + "-" + m) == (Date{year, month, 0}));
    }));
}

TEST(Dates, OfDaysOfTheYearFollowEachOther) {
    for (const int year : {1900, 1999, 2000, 2004}) {
        const bool is_leap = year == 2000 || year == 2004;
        int day_of_year = 0;
        for (int month = 1; month <= 12; ++month) {
            for (int day = 1; day <= climate::days_of_month(year, month); ++day) {
                EXPECT_EQ(climate::date_of_day(year, ++day_of_year), (Date{year, month, day}));
            }
        }
        EXPECT_EQ(day_of_year, is_leap ? 366 : 365);
        EXPECT_FALSE(climate::date_of_day(year, day_of_year + 1));
        EXPECT_FALSE(climate::date_of_day(year, 0));
    }
}

TEST(Dates, AreNoneWhereADayOrMonthDoesNotExist) {
    for (const char* text :
         {"", "x", "1981", "19811302", "1981-02-29", "31.6.1981", "1981-13", "5.1981", "-3.5"}) {
        EXPECT_FALSE(date_of(text)) << text;
    }
    EXPECT_TRUE(date_of("1984-02-29"));
}

}  // namespace
}  // namespace coupling::climate_dates_test
