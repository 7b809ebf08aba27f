#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "coupling/assessments/hazard/hazard_matrix.hpp"
#include "coupling/results/maps/read_raster.hpp"
#include "tests/runs/hazard.hpp"
#include "tests/runs/years.hpp"

namespace coupling::hazard_cells_test {
namespace {

/// Cells whose corners lie in a box.
std::vector<std::size_t> cells_within(const config::GridFrame& frame, double west_m, double south_m,
                                      double east_m, double north_m) {
    std::vector<std::size_t> cells;
    for (std::size_t i = 0; i < frame.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        const double x_m = frame.x_centre_m(cell.column);
        const double y_m = frame.y_centre_m(cell.row);
        const double half_m = 0.5 * frame.cell_width_m;
        if (x_m - half_m >= west_m && x_m + half_m <= east_m && y_m - half_m >= south_m &&
            y_m + half_m <= north_m) {
            cells.push_back(i);
        }
    }
    return cells;
}

/// A rock that passes a cell within an area has entered the area. So of two zones with unlike numbers of
/// rocks and several return periods no cell is passed more often than the area is hit, and by a matrix of how
/// often alone no cell has a higher level.
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
    const Outcome outcome = call(project,
                                 "run scenario.ini --quiet --set targets.file=areas.csv --set "
                                 "hazard.rule=cadanav --set hazard.matrix=often.csv --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table arrivals = table(project, "out/hazard/tables/hazard_arrivals.csv");
    const config::Table targets = table(project, "out/hazard/tables/hazard_targets.csv");
    int hit = 0;
    for (const std::string slope : {"bare", "forest"}) {
        const std::string rasters = "out/hazard/rasters/" + slope + "/";
        const config::Raster<float> levels = read_raster(project.file(rasters + "Hazard_level.asc"));
        for (const std::string id : {"a", "b"}) {
            const std::vector<std::size_t> cells = id == "a"
                                                       ? cells_within(levels.frame, 1060, 2000, 1100, 2100)
                                                       : cells_within(levels.frame, 1040, 2030, 1070, 2070);
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
    EXPECT_GT(hit, 50);
}

}  // namespace
}  // namespace coupling::hazard_cells_test
