#include "coupling/results/read_raster.hpp"

#include <algorithm>
#include <cmath>

#include "config/errors/input_error.hpp"
#include "config/grid/ascii_grid.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/file_bytes.hpp"

namespace coupling {

config::Raster<float> read_raster(const std::filesystem::path& file) {
    const FileBytes bytes = open_file(file, {.file = file.string()}, "a raster of the results");
    const config::Raster<double> read = config::read_ascii_grid(bytes.text(), file.string());
    config::Raster<float> raster{read.frame};
    // No figure of a run is larger [choice]; one that is comes from damage and would break every scale.
    constexpr double largest_value = 1e15;
    std::transform(read.values.begin(), read.values.end(), raster.values.begin(), [&](double value) {
        if (std::abs(value) > largest_value) {
            config::fail(config::ExitCode::data, {.file = file.string()},
                         "the value " + config::to_text(value), "a figure of a run, at most 1e15",
                         "run the scenario again: the raster is damaged");
        }
        return static_cast<float>(value);
    });
    return raster;
}

}  // namespace coupling
