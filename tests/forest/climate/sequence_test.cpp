#include "forest/climate/sequence.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/forest/climate/weather.hpp"

namespace forest::sequence_test {
namespace {

TEST(YearSequence, RepeatsItsWindowAfterTheSeries) {
    const YearSequence sequence = YearSequence::repeating(alpine_series(2001, 2010), {2005, 2007});
    EXPECT_EQ(sequence.source_of(2003), 2003);
    EXPECT_EQ(sequence.source_of(2010), 2010);
    EXPECT_EQ(sequence.source_of(2011), 2005);
    EXPECT_EQ(sequence.source_of(2012), 2006);
    EXPECT_EQ(sequence.source_of(2014), 2005);
    EXPECT_EQ(sequence.source_of(2000), 2007);
}

TEST(YearSequence, DrawsTheSameYearsForTheSameKey) {
    const YearSequence one = YearSequence::drawn({1981, 2010}, 7, 3);
    const YearSequence same = YearSequence::drawn({1981, 2010}, 7, 3);
    const YearSequence other = YearSequence::drawn({1981, 2010}, 7, 4);
    int different = 0;
    for (int year = 2020; year < 2120; ++year) {
        EXPECT_EQ(one.source_of(year), same.source_of(year));
        different += one.source_of(year) != other.source_of(year) ? 1 : 0;
    }
    EXPECT_GT(different, 80);
}

TEST(YearSequence, DrawsEachYearOfItsWindowAlike) {
    constexpr int draws = 30'000;
    constexpr int years = 30;
    const YearSequence sequence = YearSequence::drawn({1981, 2010}, 11, 0);
    std::array<int, years> hits{};
    for (int year = 0; year < draws; ++year) {
        const int source = sequence.source_of(year);
        ASSERT_GE(source, 1981);
        ASSERT_LE(source, 2010);
        ++hits[static_cast<std::size_t>(source - 1981)];
    }
    constexpr double p = 1.0 / years;
    const double five_sigma = 5.0 * std::sqrt(draws * p * (1.0 - p));
    for (const int hit : hits) {
        EXPECT_NEAR(hit, draws * p, five_sigma);
    }
}

TEST(YearWindow, MustLieInTheSeries) {
    const ClimateSeries series = alpine_series(2001, 2010);
    EXPECT_NO_THROW(check(YearWindow{2001, 2010}, series));
    EXPECT_THROW(check(YearWindow{2000, 2010}, series), config::InputError);
    EXPECT_THROW(check(YearWindow{2005, 2004}, series), config::InputError);
}

}  // namespace
}  // namespace forest::sequence_test
