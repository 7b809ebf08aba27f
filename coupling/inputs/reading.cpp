#include "coupling/inputs/reading.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "config/grid/ascii_grid.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/doubtful_columns.hpp"
#include "coupling/inputs/path_checks.hpp"

namespace coupling {

using config::joined;

void Reading::doubt(config::Place place, std::string found, std::string expected, std::string advice) {
    config::Problem problem{config::ExitCode::data, std::move(place), std::move(found), std::move(expected),
                            std::move(advice)};
    if (scenario_.strict_inputs) {
        problems_.add(std::move(problem));
    } else {
        warnings_.add(config::to_string(problem));
    }
}

void Reading::note_renamed_settings() {
    for (const config::Renaming& renaming : scenario_.options->renamings()) {
        note(config::to_string(renaming));
    }
}

FileBytes Reading::open_at(const config::Place& place, const std::string& role, const std::string& name,
                           std::string_view expected) {
    FileBytes bytes = open_file(scenario_.resolve(name), place, expected);
    inputs_.push_back({role, name, bytes.hash(), bytes.stored_bytes()});
    return bytes;
}

FileBytes Reading::open(const std::string& key, const std::string& role, const std::string& name,
                        std::string_view expected) {
    return open_at(scenario_.options->place_of(key), role, name, expected);
}

config::Table Reading::table(const std::string& key, const std::string& role, const std::string& name) {
    return table_at(scenario_.options->place_of(key), role, name);
}

config::Table Reading::table_at(const config::Place& place, const std::string& role,
                                const std::string& name) {
    const FileBytes bytes = open_at(place, role, name, "a CSV table");
    config::Table read = config::Table::read(bytes.text(), shown(name));
    for (const config::Problem& doubt_found : formula_doubts(read)) {
        doubt(doubt_found.place, doubt_found.found, doubt_found.expected);
    }
    return read;
}

config::Raster<double> Reading::grid(const std::string& key, const std::string& role,
                                     const std::string& name) {
    const FileBytes bytes = open(key, role, name, "an ESRI ASCII grid");
    return config::read_ascii_grid(bytes.text(), shown(name));
}

void Reading::heed_part(const std::string& role, const std::string& part, const std::string& hash) {
    for (InputFile& input : inputs_) {
        if (input.role == role) {
            input.role = joined(role, ", ", part);
            input.hash = hash;
        }
    }
}

std::string Reading::text_beside(const std::string& role, const std::string& name) {
    if (!path_exists(scenario_.resolve(name))) {
        return {};
    }
    const FileBytes bytes = open_file(scenario_.resolve(name), {shown(name)}, "a readable text file");
    inputs_.push_back({role, name, bytes.hash(), bytes.stored_bytes()});
    return std::string{bytes.text()};
}

namespace {

/// A length or coordinate to the millimetre, without trailing zeros.
std::string to_mm(double value_m) {
    return config::to_text(std::round(1000.0 * value_m) / 1000.0);
}

}  // namespace

bool has_value(const config::Table& table, std::size_t row, const std::string& column) {
    return table.has(column) && !table.text(row, column).empty();
}

std::string to_string(const config::GridFrame& frame) {
    std::string size = to_mm(frame.cell_width_m);
    if (frame.cell_width_m != frame.cell_height_m) {
        size += " x " + to_mm(frame.cell_height_m);
    }
    return std::to_string(frame.columns) + " x " + std::to_string(frame.rows) + " cells of " + size +
           " m, corner " + to_mm(frame.x_west_m) + ", " + to_mm(frame.y_south_m);
}

std::string cell_in_words(const config::GridFrame& frame, std::size_t index) {
    const config::Cell cell = frame.cell_of(index);
    return "row " + std::to_string(cell.row + 1) + ", column " + std::to_string(cell.column + 1) + " (x " +
           to_mm(frame.x_centre_m(cell.column)) + ", y " + to_mm(frame.y_centre_m(cell.row)) + ")";
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
