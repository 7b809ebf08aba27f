#include "validation/engine/kinds/collapse_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace coupling::validation {
namespace {

/// A second of the example collapse-small beside figures of a study.
Outcome second_of_small_mass() {
    const CaseFiles files{.name = "small",
                          .folder = "cases/small",
                          .texts = {{"case.ini",
                                     "[case]\ntitle = small\ncitation = none\nkind = collapse\n"
                                     "[collapse]\nexample = collapse-small\n"},
                                    {"targets.csv",
                                     "target_id,name,wkt\nall,all (artificial),\"POLYGON ((1000 1900, 1300 "
                                     "1900, 1300 2300, 1000 2300, 1000 1900))\"\n"},
                                    {"published.csv",
                                     "quantity,value,source\npeak_mean_speed_mps,13,x\npeak_time_s,10,x\n"
                                     "front_6s_m,50,x\nfront_10s_m,200,x\nlargest_speed_mps,50,x\n"}}};
    CaseHead head;
    const Comparison comparison =
        read_collapse_case(files, head, {"collapse.duration_s=1", "collapse.settle_s=0"});
    return comparison.run({.threads = 1, .done = [](std::uint64_t) {}});
}

const Plot& plot_named(const Outcome& outcome, const std::string& title) {
    const std::vector<Plot>& plots = outcome.plots.at(0).plots;
    return *std::find_if(plots.begin(), plots.end(), [&](const Plot& plot) { return plot.title == title; });
}

std::vector<std::pair<double, double>> study_of(const Plot& plot) {
    std::vector<std::pair<double, double>> points;
    for (const PlotSeries& series : plot.series) {
        if (series.name == "study") {
            for (const report::ChartPoint& point : series.points) {
                points.emplace_back(point.x, point.y);
            }
        }
    }
    return points;
}

TEST(CollapseCase, ShowsTheFiguresOfTheStudyBesideItsOwnCourses) {
    using Points = std::vector<std::pair<double, double>>;
    const Outcome outcome = second_of_small_mass();
    EXPECT_EQ(study_of(plot_named(outcome, "Mean speed of the mass")), (Points{{10.0, 13.0}}));
    EXPECT_EQ(study_of(plot_named(outcome, "Front")), (Points{{6.0, 50.0}, {10.0, 200.0}}));
    EXPECT_EQ(study_of(plot_named(outcome, "Largest speed of a block")), (Points{{10.0, 50.0}}));
    EXPECT_TRUE(study_of(plot_named(outcome, "Friction")).empty());
    for (const Plot& plot : outcome.plots.at(0).plots) {
        for (const PlotSeries& series : plot.series) {
            for (const report::ChartPoint& point : series.points) {
                const double room = series.name == "study" ? 1.05 : 1.0;  // dots are drawn whole
                EXPECT_LE(room * point.x, plot.x.high) << plot.title;
                EXPECT_LE(room * point.y, plot.y.high) << plot.title;
            }
        }
    }
    EXPECT_GT(outcome.values.at("floor_m2"), 10.0);
    EXPECT_GT(outcome.values.at("front_m"), 0.0);
}

}  // namespace
}  // namespace coupling::validation
