#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "config/text/numbers.hpp"
#include "coupling/assessments/hazard/hazard_matrix.hpp"
#include "coupling/results/maps/rasters.hpp"
#include "coupling/results/maps/read_raster.hpp"
#include "rockfall/tally/release_window.hpp"
#include "tests/runs/hazard.hpp"
#include "tests/runs/years.hpp"

namespace coupling::hazard_cells_test {
namespace {

/// Cells whose squares of a reference width lie in a box.
std::vector<std::size_t> cells_within(const config::GridFrame& frame, double width_m, double west_m,
                                      double south_m, double east_m, double north_m) {
    const double half_m = (rockfall::reach_of_width(width_m, frame).columns + 0.5) * frame.cell_width_m;
    std::vector<std::size_t> cells;
    for (std::size_t i = 0; i < frame.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        const double x_m = frame.x_centre_m(cell.column);
        const double y_m = frame.y_centre_m(cell.row);
        if (x_m - half_m >= west_m && x_m + half_m <= east_m && y_m - half_m >= south_m &&
            y_m + half_m <= north_m) {
            cells.push_back(i);
        }
    }
    return cells;
}

void expect_no_square_hit_more_often_than_its_area(const SampleProject& project, double width_m) {
    const config::Table arrivals = table(project, "out/hazard/tables/hazard_arrivals.csv");
    const config::Table targets = table(project, "out/hazard/tables/hazard_targets.csv");
    int hit = 0;
    for (const std::string slope : {"bare", "forest"}) {
        const std::string rasters = "out/hazard/rasters/" + slope + "/";
        const config::Raster<float> levels = read_raster(project.file(rasters + "Hazard_level.asc"));
        for (const std::string id : {"a", "b"}) {
            const std::vector<std::size_t> cells =
                id == "a" ? cells_within(levels.frame, width_m, 1060, 2000, 1100, 2100)
                          : cells_within(levels.frame, width_m, 1040, 2030, 1070, 2070);
            ASSERT_FALSE(cells.empty());
            for (const std::string years : {"30", "100"}) {
                const auto of_cells =
                    read_raster(project.file(rasters + "Arrival_return_period_" + years + ".asc"));
                for (std::size_t row = 0; row < arrivals.rows(); ++row) {
                    if (arrivals.text(row, "target_id") != id ||
                        arrivals.text(row, "return_period_years") != years) {
                        continue;
                    }
                    const double area_years =
                        std::stod("0" + arrivals.text(row, slope == "bare" ? "arrival_period_bare_years"
                                                                           : "arrival_period_years"));
                    for (const std::size_t cell : cells) {
                        if (!std::isnan(of_cells.values[cell])) {
                            EXPECT_GE(of_cells.values[cell], 0.99999 * area_years) << id << years << slope;
                            ++hit;
                        }
                    }
                }
            }
            const std::string level = targets.text(row_of(targets, id, slope), "level");
            const auto of_area = std::find(hazard::level_names.begin(), hazard::level_names.end(), level);
            for (const std::size_t cell : cells) {
                if (!std::isnan(levels.values[cell])) {
                    EXPECT_LE(levels.values[cell], of_area - hazard::level_names.begin()) << id << slope;
                }
            }
        }
    }
    EXPECT_GT(hit, 50) << width_m;
}

/// A rock that comes into the square of a cell within an area has entered the area. So of two zones with
/// unlike numbers of rocks and several return periods no square is passed more often than the area is hit,
/// and by a matrix of how often alone no cell has a higher level.
TEST(HazardOfTargets, NoCellIsHitMoreOftenThanTheAreaThatItLiesIn) {
    const SampleProject project;
    add_blocks(project);
    project.write("blocks.csv",
                  "return_period_years,zone,diameter_m,blocks\n30,1,0.5,300\n30,2,0.5,60\n"
                  "100,1,0.8,50\n100,2,1.2,400\n");
    project.write(
        "lines.csv",
        "zone,wkt\n1,\"LINESTRING (1025 2035, 1025 2050)\"\n2,\"LINESTRING (1025 2052, 1025 2065)\"\n");
    project.replace("scenario.ini", "source = source.asc", "source_shapes = lines.csv");
    project.write("areas.csv",
                  "target_id,name,wkt\n"
                  "a,Area,\"POLYGON ((1060 2000,1100 2000,1100 2100,1060 2100,1060 2000))\"\n"
                  "b,Other,\"POLYGON ((1040 2030,1070 2030,1070 2070,1040 2070,1040 2030))\"\n");
    project.write("often.csv",
                  "energy_from_kj,return_period_to_years,level\n0,30,high\n0,100,moderate\n0,300,low\n"
                  "0,,residual\n");
    for (const double width_m : {0.0, 10.0}) {
        const std::string width = config::to_text(width_m);
        const Outcome outcome =
            call(project,
                 "run scenario.ini --quiet --set targets.file=areas.csv --set hazard.rule=cadanav "
                 "--set hazard.matrix=often.csv --set hazard.reference_width_m=" +
                     width + " --overwrite --out out");
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        expect_no_square_hit_more_often_than_its_area(project, width_m);
    }
}

/// The rasters of a return period.
std::string raster_of(const std::string& out, const std::string& slope, const std::string& stem) {
    return out + "/return_period_30/rasters/" + slope + "/" + stem + ".asc";
}

/// Cells count what comes into their square: as wide as a cell or less it is the cell, and what comes into a
/// square comes into a wider one.
TEST(HazardCells, ArePassedMoreOftenInWiderSquares) {
    const SampleProject project;
    add_blocks(project);
    const std::string run = std::string{quick_hazard} + "--set hazard.rule=cadanav --set ";
    const std::string cell = config::to_text([&] {
        EXPECT_EQ(call(project, run + "hazard.reference_width_m=0 --out w0").code, 0);
        return read_raster(project.file(raster_of("w0", "bare", "Per_release"))).frame.cell_width_m;
    }());
    const std::string three = config::to_text(3.0 * std::stod(cell));
    const std::string five = config::to_text(4.5 * std::stod(cell));  // the next odd number of cells
    const std::string width = "hazard.reference_width_m=";
    ASSERT_EQ(call(project, run + width + cell + " --out w1").code, 0);
    ASSERT_EQ(call(project, run + width + three + " --threads 1 --out w3").code, 0);
    ASSERT_EQ(call(project, run + width + three + " --threads 3 --out w3_of_three").code, 0);
    ASSERT_EQ(call(project, run + width + five + " --out w5").code, 0);
    std::size_t more = 0;
    for (const std::string slope : {"bare", "forest"}) {
        for (const RasterKind& kind : release_kinds()) {
            const std::string stem{kind.stem};
            EXPECT_EQ(project.read(raster_of("w0", slope, stem)), project.read(raster_of("w1", slope, stem)));
            EXPECT_EQ(project.read(raster_of("w3", slope, stem)),
                      project.read(raster_of("w3_of_three", slope, stem)));
            const auto one = read_raster(project.file(raster_of("w1", slope, stem)));
            const auto wider = read_raster(project.file(raster_of("w3", slope, stem)));
            const auto widest = read_raster(project.file(raster_of("w5", slope, stem)));
            for (std::size_t i = 0; i < one.values.size(); ++i) {
                ASSERT_EQ(std::isnan(one.values[i]), std::isnan(wider.values[i]))
                    << "no rock passes, no value";
                if (!std::isnan(one.values[i])) {
                    EXPECT_LE(one.values[i], wider.values[i]);
                    EXPECT_LE(wider.values[i], widest.values[i]);
                    more += one.values[i] < wider.values[i] ? 1U : 0U;
                }
            }
        }
        EXPECT_EQ(project.read(raster_of("w1", slope, "E_95")), project.read(raster_of("w5", slope, "E_95")));
        const auto levels = read_raster(project.file("w1/hazard/rasters/" + slope + "/Hazard_level.asc"));
        const auto of_wider = read_raster(project.file("w3/hazard/rasters/" + slope + "/Hazard_level.asc"));
        for (std::size_t i = 0; i < levels.values.size(); ++i) {
            EXPECT_FALSE(levels.values[i] > of_wider.values[i]);
        }
    }
    EXPECT_GT(more, 100U);
    const std::string square = "comes into the square of " + three;
    EXPECT_NE(project.read("w3/hazard/report.html").find(square), std::string::npos);
    EXPECT_EQ(project.read("w1/hazard/report.html").find("comes into the square"), std::string::npos);
}

/// The rule of the release asks how often rocks break off, not where they come: its falls stay.
TEST(HazardCells, OfTheRuleReleaseKnowNoSquare) {
    const SampleProject project;
    add_blocks(project);
    const std::string run = std::string{quick_hazard} + "--set hazard.rule=release --out out";
    ASSERT_EQ(call(project, run).code, 0);
    const std::string before = project.read(raster_of("out", "bare", "Per_release"));
    const Outcome again = call(project,
                               "run scenario.ini --set release.rocks=400 --set hazard.reference_width_m=30 "
                               "--out out");
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("finished before"), std::string::npos) << again.out;
    EXPECT_EQ(project.read(raster_of("out", "bare", "Per_release")), before);
}

}  // namespace
}  // namespace coupling::hazard_cells_test
