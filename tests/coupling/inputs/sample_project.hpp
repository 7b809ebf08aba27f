#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace coupling {

/// A small project in a folder of its own, deleted with this object: an even slope of 12 x 10 cells of 10 m
/// that falls eastward by 35 degrees, four sources in the west, three trees, a line at its foot.
class SampleProject {
public:
    SampleProject() {
        std::string name = (std::filesystem::temp_directory_path() / "bannwald-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) {
            throw std::runtime_error{"no temporary folder"};
        }
        folder_ = name;
        write("scenario.ini",
              "[terrain]\ndem = dem.asc\nsurface = surface.asc\nsurface_types = surface_types.csv\n"
              "[trees]\nfile = trees.csv\n"
              "[release]\nsource = source.asc\nrocks_per_source = 5\ndiameter_m = 0.5\n"
              "[targets]\nfile = targets.csv\n");
        write("dem.asc", header() + rows([](int column, int) { return std::to_string(400 - 7 * column); }));
        write("dem.prj", "PROJCS[\"Sample\"]\n");
        write("surface.asc", header() + rows([](int column, int) { return column < 3 ? "1" : "3"; }));
        write("surface_types.csv",
              "code,label,r_n,r_t,p_stop,soil\n1,rock,0.40,0.90,0.0005,sound_rock_step_2\n"
              "3,soil,0.30,0.80,0.01,vegetated_soil_step_1\n");
        write("source.asc", header() + rows([](int column, int row) {
                                return column == 2 && row >= 3 && row < 7 ? "1" : "0";
                            }));
        write("trees.csv",
              "tree_id,x_m,y_m,species,dbh_cm,height_m\n"
              "1,1060,2050,ABAL,32.5,25\n2,1070,2042,piab,20,18\n3,1080,2061,Fagus sylvatica,41,28\n");
        write("targets.csv",
              "target_id,name,wkt\nroad,road,\"LINESTRING (1105 2010, 1105 2090)\"\n"
              "house,house,\"POLYGON ((1090 2040, 1100 2040, 1100 2050, 1090 2050, 1090 2040))\"\n");
    }
    SampleProject(const SampleProject&) = delete;
    SampleProject& operator=(const SampleProject&) = delete;
    ~SampleProject() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    [[nodiscard]] std::filesystem::path file(const std::string& name) const { return folder_ / name; }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream out{folder_ / name, std::ios::binary};
        out << text;
        out.close();
        if (!out) {
            throw std::runtime_error{"cannot write " + (folder_ / name).string()};
        }
    }
    [[nodiscard]] std::string read(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream{folder_ / name, std::ios::binary}.rdbuf();
        return text.str();
    }
    /// Replaces the first `from` of a file. Throws if it is not there: a test that changes nothing tests
    /// nothing.
    void replace(const std::string& name, const std::string& from, const std::string& to) const {
        const std::string text = read(name);
        const std::size_t at = text.find(from);
        if (at == std::string::npos) {
            throw std::logic_error{name + " does not hold " + from};
        }
        write(name, text.substr(0, at) + to + text.substr(at + from.size()));
    }
    void remove(const std::string& name) const { std::filesystem::remove(folder_ / name); }

    static constexpr int columns = 12;
    static constexpr int grid_rows = 10;

    static std::string header() {
        return "ncols 12\nnrows 10\nxllcorner 1000\nyllcorner 2000\ncellsize 10\n";
    }
    /// The values of a grid, `value(column, row)` as text.
    template <class Value>
    static std::string rows(Value value) {
        std::ostringstream text;
        for (int row = 0; row < grid_rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                text << value(column, row) << ' ';
            }
            text << '\n';
        }
        return text.str();
    }

private:
    std::filesystem::path folder_;
};

}  // namespace coupling
