#include "coupling/results/read_raster.hpp"

#include <algorithm>

#include "config/grid/ascii_grid.hpp"
#include "coupling/inputs/file_bytes.hpp"

namespace coupling {

config::Raster<float> read_raster(const std::filesystem::path& file) {
    const FileBytes bytes = open_file(file, {.file = file.string()}, "a raster of the results");
    const config::Raster<double> read = config::read_ascii_grid(bytes.text(), file.string());
    config::Raster<float> raster{read.frame};
    std::transform(read.values.begin(), read.values.end(), raster.values.begin(),
                   [](double value) { return static_cast<float>(value); });
    return raster;
}

}  // namespace coupling
