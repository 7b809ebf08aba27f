#include "coupling/assessments/decades/report/target_profile.hpp"

#include <gtest/gtest.h>

namespace coupling::decades::target_profile_test {
namespace {

const forest::SpeciesTable table = forest::SpeciesTable::shipped();

Series series_of(const std::string& quantity, double first, double middle, double last) {
    Series series;
    series.quantity = quantity;
    series.values = {{{{0, first}, {5, middle}, {10, last}}}, {{{0, 100.0}, {5, 100.0}, {10, 100.0}}}};
    return series;
}

const Names names{{"none", "a < b"}, {}, table};

TEST(StandsAgainstRocks, SayWhereTheProfileIsMetAtStartMiddleAndEnd) {
    const std::vector<Series> series{series_of("gap_95_m", 11.0, 12.0, 13.0),
                                     series_of("gap_max_m", 25.0, 14.0, 50.0),
                                     series_of("target_profile_met_percent", 0.0, 62.0, 4.2),
                                     series_of("stopped_by_tree_percent", 41.5, 42.0, 43.5),
                                     series_of("stopped_by_log_percent", 1.5, 2.0, 3.5),
                                     series_of("stopped_by_ground_percent", 20.0, 20.0, 21.5),
                                     series_of("left_terrain_percent", 37.0, 36.0, 31.5),
                                     series_of("gave_up_percent", 0.0, 0.0, 0.0)};
    std::vector<Series> all = series;
    all.back().values[1][0] = {{0, 0.0}, {5, 0.0}, {10, 0.0}};
    const std::string html = stands_against_rocks(names, all, forest::target_profile(0.5), 0.5);
    EXPECT_NE(html.find("at least 300 stems a hectare from 24\u00a0cm on (better 400)"), std::string::npos);
    EXPECT_NE(
        html.find("<b>A: none</b>. Stands meet this <b>nowhere</b> in year 0, <b>on 62 % of the area</b> in "
                  "year 5 and <b>on 4.2 % of the area</b> in year 10."),
        std::string::npos)
        << html;
    EXPECT_NE(html.find("B: a &lt; b</b>. Stands meet this <b>on the whole area</b> in year 0"),
              std::string::npos);
    EXPECT_NE(html.find("<td>A: none</td><td>41.5</td><td>43.5</td>"), std::string::npos);
    EXPECT_NE(html.find("<td>A: none</td><td>25</td><td>14</td><td>50</td>"), std::string::npos);
    EXPECT_EQ(html.find("Given up"), std::string::npos) << "nothing to tell";
}

TEST(StandsAgainstRocks, SayThatNoProfileSpeaksOfSuchRocks) {
    const std::vector<Series> series{series_of("gap_95_m", 11.0, 12.0, 13.0),
                                     series_of("gap_max_m", 25.0, 14.0, 50.0)};
    const std::string html = stands_against_rocks(names, series, forest::target_profile(2.5), 2.5);
    EXPECT_NE(html.find("larger than any"), std::string::npos);
    EXPECT_EQ(html.find("Stands meet"), std::string::npos);
    EXPECT_NE(html.find("Longest gap"), std::string::npos);
}

}  // namespace
}  // namespace coupling::decades::target_profile_test
