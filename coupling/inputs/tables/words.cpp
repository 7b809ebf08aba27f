#include "coupling/inputs/tables/words.hpp"

#include <algorithm>

#include "config/text/coordinates.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling {

using config::joined;

bool has_value(const config::Table& table, std::size_t row, const std::string& column) {
    return table.has(column) && !table.text(row, column).empty();
}

std::string to_string(const config::GridFrame& frame) {
    std::string size = config::metres_in_words(frame.cell_width_m);
    if (frame.cell_width_m != frame.cell_height_m) {
        size += " x " + config::metres_in_words(frame.cell_height_m);
    }
    return joined(std::to_string(frame.columns), " x ", std::to_string(frame.rows), " cells of ", size,
                  " m, corner ", config::place_in_words(frame.x_west_m, frame.y_south_m));
}

std::string cell_in_words(const config::GridFrame& frame, std::size_t index) {
    const config::Cell cell = frame.cell_of(index);
    return joined("row ", std::to_string(cell.row + 1), ", column ", std::to_string(cell.column + 1), " (x ",
                  config::metres_in_words(frame.x_centre_m(cell.column)), ", y ",
                  config::metres_in_words(frame.y_centre_m(cell.row)), ")");
}

std::string counted(std::size_t count, std::string_view singular) {
    return std::to_string(count) + " " + std::string{singular} + (count == 1 ? "" : "s");
}

void add_first(config::Problems& problems, const config::Problems& of_file, const std::string& file) {
    constexpr std::size_t most = 20;
    const auto& list = of_file.list();
    for (std::size_t i = 0; i < std::min(most, list.size()); ++i) {
        problems.add(list[i]);
    }
    if (list.size() > most) {
        problems.add(config::ExitCode::data, {file},
                     std::to_string(list.size() - most) + " more such problems");
    }
}

}  // namespace coupling
