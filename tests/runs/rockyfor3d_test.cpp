// A folder with the inputs of Rockyfor3D becomes a project that runs.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <regex>
#include <sstream>
#include <string>

#include "config/grid/ascii_grid.hpp"
#include "config/table/table.hpp"
#include "tests/runs/program.hpp"

namespace coupling::rockyfor3d_test {
namespace {

using config::Raster;

/// A window of 70 x 70 cells of the example `tyrol` as a user of Rockyfor3D has it, in the folder `rocky`.
class RockyFolder : public SampleProject {
public:
    RockyFolder() {
        EXPECT_EQ(call(*this, "init tyrol --quiet").code, 0);
        std::filesystem::create_directories(file("rocky"));
        const Raster<double> dem = window(grid_of("tyrol/dem.asc"));
        const Raster<double> surface = window(grid_of("tyrol/surface.asc"));
        const Raster<double> source = window(grid_of("tyrol/source.asc"));
        frame_ = dem.frame;
        save("dem.asc", dem);
        write("rocky/dem.prj", read("tyrol/dem.prj"));
        const auto from = [&](const Raster<double>& raster, const std::function<double(double)>& value) {
            Raster<double> made{frame_};
            for (std::size_t i = 0; i < made.values.size(); ++i) {
                made.values[i] = value(raster.values[i]);
            }
            return made;
        };
        const auto if_source = [&](double value) {
            return from(source, [value](double zone) { return zone > 0.0 ? value : 0.0; });
        };
        save("rockdensity.asc", if_source(2650.0));
        save("d1.asc", if_source(0.8));
        save("d2.asc", if_source(0.6));
        save("d3.asc", if_source(0.5));
        save("blshape.asc", if_source(1.0));
        save("soiltype.asc", from(surface, [](double code) {
                 return code == 1 ? 6.0 : code == 2 ? 4.0 : 1.0;
             }));
        save("rg70.asc", from(surface, [](double code) { return code == 2 ? 0.25 : 0.0; }));
        save("rg20.asc", from(surface, [](double code) { return code == 2 ? 0.5 : 0.05; }));
        save("rg10.asc", from(surface, [](double code) { return code == 2 ? 0.9 : 0.1; }));
        save("conif_percent.asc", Raster<double>{frame_, 60.0});
        write("rocky/net_energy.asc", "an old net\n");
    }

    void save(const std::string& name, const Raster<double>& raster) const {
        std::ostringstream text;
        config::write_ascii_grid(text, raster);
        write("rocky/" + name, text.str());
    }
    [[nodiscard]] const config::GridFrame& frame() const { return frame_; }

    void make_all_blocks_spheres_of(double diameter_m) const {
        const Raster<double> density = grid_of("rocky/rockdensity.asc");
        Raster<double> shape{frame_};
        Raster<double> axis{frame_};
        for (std::size_t i = 0; i < density.values.size(); ++i) {
            shape.values[i] = density.values[i] > 0.0 ? 3.0 : 0.0;
            axis.values[i] = density.values[i] > 0.0 ? diameter_m : 0.0;
        }
        save("blshape.asc", shape);
        for (const char* name : {"d1.asc", "d2.asc", "d3.asc"}) {
            save(name, axis);
        }
    }

    /// Statistical forest: 400 stems/ha in the northern half.
    void add_forest_rasters() const {
        Raster<double> stems{frame_};
        for (std::size_t i = 0; i < stems.values.size() / 2; ++i) {
            stems.values[i] = 400.0;
        }
        save("nrtrees.asc", stems);
        save("dbhmean.asc", Raster<double>{frame_, 30.0});
        save("dbhstd.asc", Raster<double>{frame_, 8.0});
    }
    /// The trees of the example in the window as a tree file.
    std::size_t add_tree_file() const {
        std::istringstream in{read("tyrol/trees.csv")};
        const config::Table trees = config::Table::read(in, "trees.csv");
        std::ostringstream out;
        std::size_t count = 0;
        for (std::size_t row = 0; row < trees.rows(); ++row) {
            const double x_m = std::stod(trees.text(row, "x_m"));
            const double y_m = std::stod(trees.text(row, "y_m"));
            if (frame_.covers(x_m, y_m)) {
                out << trees.text(row, "x_m") << '\t' << trees.text(row, "y_m") << '\t'
                    << trees.text(row, "dbh_cm") << '\n';
                ++count;
            }
        }
        write("rocky/treefile.txt", out.str());
        return count;
    }
    [[nodiscard]] Raster<double> grid_of(const std::string& name) const {
        return config::read_ascii_grid(read(name), name);
    }

private:
    static Raster<double> window(const Raster<double>& whole) {
        constexpr int size = 70;
        constexpr int first_column = 60;
        constexpr int first_row = 30;
        const config::GridFrame& f = whole.frame;
        Raster<double> part{{size, size, f.x_west_m + first_column * f.cell_width_m,
                             f.y_north_m() - (first_row + size) * f.cell_height_m, f.cell_width_m,
                             f.cell_height_m}};
        for (int row = 0; row < size; ++row) {
            for (int column = 0; column < size; ++column) {
                part.at({column, row}) = whole.at({first_column + column, first_row + row});
            }
        }
        return part;
    }

    config::GridFrame frame_;
};

config::Table table_of(const SampleProject& project, const std::string& name) {
    std::istringstream in{project.read(name)};
    return config::Table::read(in, name);
}

TEST(FromRockyfor3d, MakesAProjectThatRuns) {
    const RockyFolder project;
    const std::size_t trees = project.add_tree_file();
    ASSERT_GT(trees, 100U);
    const Outcome made = call(project, "init made --from-rockyfor3d rocky");
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(made.out, "made/scenario.ini\n");
    // What has no counterpart is said on the screen and in the project.
    EXPECT_NE(made.err.find("Not read, no counterpart: net_energy.asc"), std::string::npos) << made.err;
    EXPECT_NE(project.read("made/README.md").find("net_energy.asc"), std::string::npos);
    EXPECT_EQ(project.read("made/dem.prj"), project.read("tyrol/dem.prj"));

    const config::Table listed = table_of(project, "made/trees.csv");
    EXPECT_GT(listed.rows(), trees / 2);  // those below 5 cm are left out
    std::size_t conifers = 0;
    for (std::size_t row = 0; row < listed.rows(); ++row) {
        conifers += listed.text(row, "species") == "PIAB" ? 1U : 0U;
    }
    const double share = static_cast<double>(conifers) / static_cast<double>(listed.rows());
    EXPECT_NEAR(share, 0.6, 4.0 * std::sqrt(0.6 * 0.4 / static_cast<double>(listed.rows())));

    const Outcome check = call(project, "check made/scenario.ini");
    ASSERT_EQ(check.code, 0) << check.err;
    EXPECT_EQ(warnings_of_files(check), "");
    const Outcome run = call(project, "run made/scenario.ini --quiet --set release.rocks=500");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(std::filesystem::exists(project.file("made/out/rasters/forest/E_95.asc")));

    // The size of the spheres of the same volume as the blocks.
    const config::Table rocks = table_of(project, "made/out/tables/rocks.csv");
    const double diameter_m = std::cbrt(6.0 / 3.14159265358979 * 0.8 * 0.6 * 0.5);
    EXPECT_NEAR(std::stod(rocks.text(0, "diameter_m")), diameter_m, 0.005);  // sizes to the centimetre
}

TEST(FromRockyfor3d, DrawsAForestFromRastersTheSameEachTime) {
    const RockyFolder project;
    project.add_forest_rasters();
    ASSERT_EQ(call(project, "init made --from-rockyfor3d rocky --quiet").code, 0);
    ASSERT_EQ(call(project, "init again --from-rockyfor3d rocky --quiet").code, 0);
    EXPECT_EQ(project.read("made/trees.csv"), project.read("again/trees.csv"));
    const config::Table trees = table_of(project, "made/trees.csv");
    // 400 stems on each hectare of 34.5 x 69 cells: the terrain ends in the middle of the outer ones. Chance
    // is in whether the trees of these 140 cells stand on it.
    const double area_ha = 34.5 * 69.0 * project.frame().cell_area_m2() / 10'000.0;
    EXPECT_NEAR(static_cast<double>(trees.rows()), 400.0 * area_ha, 4.0 * std::sqrt(140.0 * 0.25 + 10.0));
    double sum_cm = 0.0;
    for (std::size_t row = 0; row < trees.rows(); ++row) {
        sum_cm += std::stod(trees.text(row, "dbh_cm"));
    }
    const auto count = static_cast<double>(trees.rows());
    EXPECT_NEAR(sum_cm / count, 30.0, 4.0 * 8.0 / std::sqrt(count) + 0.05);
    EXPECT_NE(project.read("made/README.md").find("artificial"), std::string::npos);
}

/// A product of 115 and 0.01 is 1.1500000000000001.
TEST(FromRockyfor3d, WritesLengthsWithoutFalseDigits) {
    const RockyFolder project;
    project.make_all_blocks_spheres_of(1.15);
    ASSERT_EQ(call(project, "init made --from-rockyfor3d rocky --quiet").code, 0);
    for (const char* file : {"scenario.ini", "README.md", "surface_types.csv"}) {
        const std::string text = project.read(std::string{"made/"} + file);
        EXPECT_FALSE(std::regex_search(text, std::regex{"[.][0-9]{5}"})) << file;
    }
    EXPECT_NE(project.read("made/scenario.ini").find("\ndiameter_m = 1.15\n"), std::string::npos);
}

TEST(FromRockyfor3d, TakesTheTreeFileBeforeRastersAndSaysSo) {
    const RockyFolder project;
    project.add_tree_file();
    project.add_forest_rasters();
    const Outcome made = call(project, "init made --from-rockyfor3d rocky");
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_NE(made.err.find("from treefile.txt, which goes before nrtrees.asc, dbhmean.asc"),
              std::string::npos)
        << made.err;
}

/// Found by changed inputs: such figures gave the gamma distribution a shape without end.
TEST(FromRockyfor3d, TakesDiametersThatHardlyScatter) {
    const RockyFolder project;
    project.add_forest_rasters();
    project.save("dbhstd.asc", Raster<double>{project.frame(), 5e-324});
    EXPECT_EQ(call(project, "init made --from-rockyfor3d rocky --quiet").code, 0);
}

/// pir3d asks every ground for a soil: soil type 0 and a roughness of 100 m have one.
TEST(FromRockyfor3d, GivesEachGroundWhatEveryModelAsksFor) {
    const RockyFolder project;
    Raster<double> soil = project.grid_of("rocky/soiltype.asc");
    Raster<double> rough = project.grid_of("rocky/rg70.asc");
    std::fill_n(soil.values.begin(), soil.values.size() / 4, 0.0);
    std::fill_n(rough.values.rbegin(), rough.values.size() / 4, 100.0);
    project.save("soiltype.asc", soil);
    project.save("rg70.asc", rough);
    const Outcome made = call(project, "init made --from-rockyfor3d rocky");
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_NE(made.err.find("stop every rock"), std::string::npos) << made.err;
    for (const char* motion : {"picus", "pir3d", "classical", "rigid"}) {
        const Outcome checked =
            call(project, std::string{"check made/scenario.ini --set rockfall.motion="} + motion);
        EXPECT_EQ(checked.code, 0) << motion << ": " << checked.err;
    }
}

}  // namespace
}  // namespace coupling::rockyfor3d_test
