// What `init --from-rockyfor3d` writes, `check` and `run` accept: over folders drawn at random, each valid by
// the rules of Rockyfor3D.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <random>
#include <sstream>
#include <string>

#include "config/grid/ascii_grid.hpp"
#include "tests/runs/program.hpp"

namespace coupling::rockyfor3d_folders_test {
namespace {

using config::Raster;

/// A folder `rocky` drawn from a seed. The same seed gives the same folder on any machine: the engine's
/// numbers are those of the standard, the few distributions are our own.
class DrawnFolder : public SampleProject {
public:
    explicit DrawnFolder(unsigned seed) : engine_{seed} {
        std::filesystem::create_directories(file("rocky"));
        frame_ = {between(14, 34),
                  between(12, 26),
                  odd_corner_m(),
                  odd_corner_m(),
                  pick({1.0, 2.0, 5.0, 2.5}),
                  0.0};
        frame_.cell_height_m = frame_.cell_width_m;
        draw_heights();
        draw_grounds();
        draw_blocks();
        draw_forest();
        draw_nets();
        if (chance(0.5)) {
            write("rocky/dem.prj",
                  "PROJCS[\"MGI / Austria GK West\",GEOGCS[\"MGI\",DATUM[\"MGI\",SPHEROID[\"Bessel "
                  "1841\",6377397.155,299.1528128]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0."
                  "0174532925199433]],"
                  "PROJECTION[\"Transverse_Mercator\"],UNIT[\"metre\",1]]\n");
        }
    }
    [[nodiscard]] const std::string& what() const { return what_; }

private:
    double uniform() { return static_cast<double>(engine_()) / 4294967296.0; }
    bool chance(double p) { return uniform() < p; }
    int between(int low, int high) { return low + static_cast<int>(uniform() * (high - low + 1)); }
    double pick(std::initializer_list<double> values) {
        return *(values.begin() + between(0, static_cast<int>(values.size()) - 1));
    }
    /// Corners as people have them: whole, or with the digits of a transformation.
    double odd_corner_m() {
        return std::round(uniform() * 9e5 * 1000.0) / (chance(0.5) ? 1000.0 : 1.0) / 1000.0;
    }

    void save(const std::string& name, const Raster<double>& raster) const {
        std::ostringstream text;
        config::write_ascii_grid(text, raster);
        write("rocky/" + name, text.str());
    }
    template <class Value>
    Raster<double> by_cell(Value value) {
        Raster<double> raster{frame_};
        for (std::size_t i = 0; i < raster.values.size(); ++i) {
            raster.values[i] = std::isnan(dem_.values[i]) && no_data_as_in_dem_ ? std::nan("") : value(i);
        }
        return raster;
    }

    /// A slope of 25 to 40 degrees in any direction, with low waves, and a rim of NODATA on some sides.
    void draw_heights() {
        const double heading = uniform() * 6.28;
        const double steep = std::tan(0.44 + 0.26 * uniform());
        const std::array<int, 4> rim{between(0, 2), between(0, 2), between(0, 2), between(0, 2)};
        dem_ = Raster<double>{frame_};
        for (std::size_t i = 0; i < frame_.size(); ++i) {
            const config::Cell cell = frame_.cell_of(i);
            const double x_m = cell.column * frame_.cell_width_m;
            const double y_m = cell.row * frame_.cell_height_m;
            dem_.values[i] = 1000.0 + steep * (x_m * std::cos(heading) + y_m * std::sin(heading)) +
                             0.05 * frame_.cell_width_m * std::sin(0.9 * cell.column + 0.7 * cell.row);
            if (cell.column < rim[0] || cell.row < rim[1] || cell.column >= frame_.columns - rim[2] ||
                cell.row >= frame_.rows - rim[3]) {
                dem_.values[i] = std::nan("");
            }
        }
        no_data_as_in_dem_ = chance(0.5);
        save("dem.asc", dem_);
    }

    /// Every soil type, with smooth and rough ground; 100 m stops all.
    void draw_grounds() {
        const int patch = between(2, 9);
        std::array<std::array<double, 4>, 16> kinds{};
        for (auto& kind : kinds) {
            kind = {static_cast<double>(between(0, 7)), pick({0.0, 0.0, 0.05, 0.25, 1.0}),
                    pick({0.0, 0.05, 0.5, 2.0}), pick({0.0, 0.05, 0.1, 0.9})};
            kind[1] = chance(0.05) ? 100.0 : kind[1];
        }
        const auto layer = [&](std::size_t number) {
            return by_cell([&](std::size_t i) {
                const config::Cell cell = frame_.cell_of(i);
                return kinds[static_cast<std::size_t>(cell.column / patch + 3 * (cell.row / patch)) %
                             kinds.size()][number];
            });
        };
        save("soiltype.asc", layer(0));
        save("rg70.asc", layer(1));
        save("rg20.asc", layer(2));
        save("rg10.asc", layer(3));
    }

    void draw_blocks() {
        const int kinds = between(1, 4);
        std::array<std::array<double, 5>, 4> blocks{};
        for (auto& block : blocks) {
            block = {static_cast<double>(between(1, 4)), 0.1 + 2.0 * uniform(), 0.1 + 2.0 * uniform(),
                     0.1 + 2.0 * uniform(), std::round(2000.0 + 1300.0 * uniform())};
            what_ += " blshape " + std::to_string(static_cast<int>(block[0]));
        }
        std::vector<int> kind(frame_.size(), -1);
        for (int k = 0; k < 6; ++k) {
            const config::Cell cell{between(3, frame_.columns - 4), between(3, frame_.rows - 4)};
            kind[frame_.index(cell)] = between(0, kinds - 1);
        }
        if (chance(0.3)) {
            kind[frame_.index({0, frame_.rows / 2})] = 0;  // in the rim that neither program uses
        }
        kind[frame_.index({frame_.columns / 2, frame_.rows / 2})] = 0;
        const auto layer = [&](std::size_t number) {
            return by_cell([&](std::size_t i) {
                return kind[i] < 0 ? 0.0 : blocks[static_cast<std::size_t>(kind[i])][number];
            });
        };
        save("blshape.asc", layer(0));
        save("d1.asc", layer(1));
        save("d2.asc", layer(2));
        save("d3.asc", layer(3));
        save("rockdensity.asc", layer(4));
    }

    void draw_forest() {
        const int kind = between(0, 2);
        what_ += ", forest " + std::to_string(kind);
        if (kind == 1) {
            const std::string apart = chance(0.5) ? "\t" : " ";
            std::ostringstream trees;
            trees.precision(12);
            for (int k = 0; k < 60; ++k) {
                trees << frame_.x_west_m + (3.0 + uniform() * (frame_.columns - 6)) * frame_.cell_width_m
                      << apart
                      << frame_.y_south_m + (3.0 + uniform() * (frame_.rows - 6)) * frame_.cell_height_m
                      << apart << std::round(60.0 + 400.0 * uniform()) / 10.0 << '\n';
            }
            write("rocky/treefile.txt", trees.str());
        } else if (kind == 2) {
            save("nrtrees.asc", by_cell([&](std::size_t) { return chance(0.8) ? 400.0 : 0.0; }));
            save("dbhmean.asc", by_cell([&](std::size_t) { return 30.0; }));
            save("dbhstd.asc", by_cell([&](std::size_t) { return 8.0; }));
        }
        if (kind > 0 && chance(0.5)) {
            save("conif_percent.asc", by_cell([&](std::size_t) { return std::round(100.0 * uniform()); }));
        }
    }

    /// Lines and odd patches of nets, as far as the border.
    void draw_nets() {
        if (chance(0.4)) {
            return;
        }
        std::vector<int> number(frame_.size(), 0);
        const int nets = between(1, 3);
        for (int net = 1; net <= nets; ++net) {
            config::Cell at{between(0, frame_.columns - 1), between(0, frame_.rows - 1)};
            const config::Cell step{between(-1, 1), between(-1, 1)};
            for (int k = between(1, 12); k > 0 && frame_.contains(at); --k) {
                number[frame_.index(at)] = net;
                at = {at.column + step.column + (chance(0.2) ? 1 : 0), at.row + step.row};
            }
        }
        what_ += ", nets";
        save("net_number.asc", by_cell([&](std::size_t i) { return static_cast<double>(number[i]); }));
        save("net_energy.asc",
             by_cell([&](std::size_t i) { return number[i] > 0 ? 500.0 * number[i] : 0.0; }));
        save("net_height.asc", by_cell([&](std::size_t i) { return number[i] > 0 ? 2.0 + number[i] : 0.0; }));
    }

    std::mt19937 engine_;
    config::GridFrame frame_;
    Raster<double> dem_;
    bool no_data_as_in_dem_ = false;
    std::string what_;
};

class AnyFolder : public ::testing::TestWithParam<unsigned> {};

TEST_P(AnyFolder, BecomesAProjectThatIsCheckedAndRuns) {
    const DrawnFolder project{GetParam()};
    const Outcome made = call(project, "init made --from-rockyfor3d rocky");
    ASSERT_EQ(made.code, 0) << project.what() << '\n' << made.err;
    EXPECT_EQ(made.err.find("no counterpart: net"), std::string::npos) << made.err;
    const Outcome check = call(project, "check made/scenario.ini");
    EXPECT_EQ(check.code, 0) << project.what() << '\n' << check.err;
    const Outcome run = call(project, "run made/scenario.ini --quiet --set release.rocks=30");
    EXPECT_EQ(run.code, 0) << project.what() << '\n' << run.err;
    // The shapes themselves; few rocks, as a smooth slope keeps them long.
    const Outcome rigid =
        call(project,
             "run made/scenario.ini --quiet --out rigid --set release.rocks=4 --set rockfall.motion=rigid");
    EXPECT_EQ(rigid.code, 0) << project.what() << '\n' << rigid.err;
}

INSTANTIATE_TEST_SUITE_P(FromRockyfor3d, AnyFolder, ::testing::Range(1U, 25U));

}  // namespace
}  // namespace coupling::rockyfor3d_folders_test
