#include "coupling/results/maps/read_raster.hpp"

#include "config/errors/input_error.hpp"
#include "config/grid/ascii_grid.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/files/file_bytes.hpp"

namespace coupling {

namespace {

/// No raster of a run comes near it: the largest are counts of rocks and energies in kJ [choice].
constexpr double largest_value = 1e12;

}  // namespace

config::Raster<float> read_raster(const std::filesystem::path& file) {
    const FileBytes bytes = open_file(file, {.file = file.string()}, "a raster of the results");
    const config::Raster<double> read = config::read_ascii_grid(bytes.text(), file.string());
    config::Raster<float> raster{read.frame};
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
        const double value = read.values[i];
        if (value < 0.0 || value > largest_value) {  // NaN: not known
            config::fail(config::ExitCode::data, {file.string()},
                         config::joined("the value ", config::to_text(value), " in row ",
                                        std::to_string(i / static_cast<std::size_t>(read.frame.columns) + 1),
                                        " of the cells"),
                         "values from 0 on, as a run writes them",
                         "put the raster back as it was, or run the scenario again with --overwrite");
        }
        raster.values[i] = static_cast<float>(value);
    }
    return raster;
}

}  // namespace coupling
