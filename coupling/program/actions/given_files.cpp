#include "coupling/program/actions/given_files.hpp"

#include <system_error>
#include <utility>

#include "config/grid/ascii_grid.hpp"
#include "config/text/joined.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/grids/grid_file.hpp"
#include "coupling/inputs/tables/prepare.hpp"

namespace coupling {

using config::joined;

std::string name_from(const std::filesystem::path& folder, const std::string& name) {
    namespace fs = std::filesystem;
    const formats::LayerName layer = formats::split_layer_name(name);
    std::error_code ignored;
    const fs::path here = fs::weakly_canonical(fs::absolute(layer.file, ignored), ignored);
    const fs::path there = fs::weakly_canonical(fs::absolute(folder, ignored), ignored);
    const fs::path relative = here.lexically_relative(there);
    std::string file = relative.empty() ? here.string() : relative.generic_string();
    file.erase(file.find_last_not_of('/') + 1);
    return layer.layer.empty() ? file : joined(file, "|", layer.layer);
}

GivenFile::GivenFile(std::string name)
    : name_{std::move(name)},
      layer_{formats::split_layer_name(name_)},
      bytes_{open_file(layer_.file, {}, "a file of yours")},
      beside_{layer_.file} {}

bool GivenFile::is_grid() const {
    return formats::is_gis_raster(bytes_.text()) || config::most_grid_bytes(bytes_.text()).has_value();
}

formats::PlacedGrid GivenFile::grid() {
    return grids::read_grid_file(bytes_.text(), name_, beside_.bytes());
}

formats::ReadLayer GivenFile::layer() {
    return formats::read_layer_file(bytes_.text(), layer_.layer, name_, beside_.bytes());
}

std::string GivenFile::system_beside() {
    return std::string{config::trimmed(beside_.bytes()(".prj"))};
}

void prepare(formats::ReadLayer& read, const std::string& role) {
    config::Problems problems;
    for (const config::Problem& problem :
         tables::prepare(read.layer.table, role, read.has_shapes_of_its_own).errors) {
        problems.add(problem);
    }
    problems.throw_if_any();
}

grids::GridFiles HeightFiles::files() {
    return {.path = [](const std::string& name) { return std::filesystem::path{name}; },
            .shown = [](const std::string& name) { return name; },
            .open = [](const std::string& name, const config::Place& asked_at,
                       bool) { return open_file(name, asked_at, grids::grid_expected); },
            .beside = [this](const std::string& name,
                             bool) { return beside_.emplace_back(std::filesystem::path{name}).bytes(); }};
}

}  // namespace coupling
