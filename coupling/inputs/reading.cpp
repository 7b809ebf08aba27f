#include "coupling/inputs/reading.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/doubtful_columns.hpp"
#include "coupling/inputs/formats/column_names.hpp"
#include "coupling/inputs/path_checks.hpp"
#include "coupling/inputs/plausible/same_system.hpp"

namespace coupling {

using config::joined;

void Reading::warn(config::Place place, std::string found, std::string expected, std::string advice,
                   config::Effect effect) {
    config::Problem problem{config::ExitCode::data, std::move(place), std::move(found), std::move(expected),
                            std::move(advice)};
    if (scenario_.strict_inputs) {
        problems_.add(std::move(problem));
    } else {
        problem.place = scenario_.shown(std::move(problem.place));
        warnings_.add(config::to_string(problem), effect);
    }
}

void Reading::note_renamed_settings() {
    for (config::Renaming renaming : scenario_.options->renamings()) {
        renaming.place = scenario_.shown(std::move(renaming.place));
        note(config::to_string(renaming));
    }
}

FileBytes Reading::open_at(const config::Place& place, const std::string& role, const std::string& name,
                           std::string_view expected) {
    FileBytes bytes = open_file(scenario_.resolve(name), place, expected);
    inputs_.push_back({role, shown(name), bytes.hash(), bytes.stored_bytes()});
    return bytes;
}

FileBytes Reading::open(const std::string& key, const std::string& role, const std::string& name,
                        std::string_view expected) {
    return open_at(scenario_.options->place_of(key), role, name, expected);
}

config::Table Reading::table(const std::string& key, const std::string& role, const std::string& name) {
    return table_at(scenario_.options->place_of(key), role, name);
}

/// Files beside a file are opened as they are asked for, and recorded: what they say matters too.
formats::BytesBeside Reading::beside(const std::string& role, const std::string& file) {
    return [this, role, file](const std::string& ending) -> std::string_view {
        std::filesystem::path path{file};
        if (path.extension() == ".gz") {
            path.replace_extension();
        }
        std::string wanted = ending;
        const std::string own = path.extension().string();
        if (own.size() > 1 && std::isupper(static_cast<unsigned char>(own[1])) != 0) {
            std::transform(wanted.begin(), wanted.end(), wanted.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
        }
        const std::string name = path.replace_extension(wanted).string();
        if (!path_exists(scenario_.resolve(name))) {
            return {};
        }
        open_.push_back(open_file(scenario_.resolve(name), {shown(name)}, "a readable file"));
        // The projection of the terrain has had this name ever since.
        const std::string of = ending == ".prj" && role == "dem" ? "projection" : joined(role, " ", ending);
        inputs_.push_back({of, shown(name), open_.back().hash(), open_.back().stored_bytes()});
        return open_.back().text();
    };
}

bool Reading::has_input(const std::string& role) const {
    return std::any_of(inputs_.begin(), inputs_.end(),
                       [&](const InputFile& input) { return input.role == role; });
}

void Reading::take_system(const std::string& role, const std::string& name, std::string text) {
    systems_.push_back({role, shown(name), std::move(text)});
}

void Reading::take_names(config::Table& table, const std::string& role, bool has_own_shapes) {
    for (const formats::NamedColumn& column : formats::name_columns(table, role)) {
        note(joined(table.file(), ": column ", config::in_quotes(column.found), " is taken as ",
                    column.taken_as));
    }
    if (role == "trees" || role == "logs") {
        const std::size_t moved = formats::take_coordinates(table, role, has_own_shapes);
        if (moved > 0) {
            warn({table.file()},
                 joined(counted(moved, "row"), " whose attributes name another place than the shape"),
                 "one place for each: the shape counts", "delete the columns of coordinates if they are old");
        }
    }
    const std::string id = role == "targets" ? "target_id" : role == "nets" ? "name" : "";
    if (has_own_shapes && !id.empty() && !table.has(id) && table.has("wkt")) {
        std::vector<std::string> numbers;
        for (std::size_t row = 0; row < table.rows(); ++row) {
            numbers.push_back(std::to_string(table.place(row, "wkt").line));
        }
        table.add_column(id, std::move(numbers), "wkt");
        note(joined(table.file(), ": no column for ", id, ": numbers of the features are taken"));
    }
}

namespace {

/// Layers that a GIS wrote without shapes, where shapes are what is wanted.
void refuse_layer_without_shapes(const config::Table& table, const std::string& role) {
    constexpr std::array of_shapes{"targets",       "nets",      "stands",
                                   "source_shapes", "tree_area", "surface_polygons"};
    if (std::find(of_shapes.begin(), of_shapes.end(), role) == of_shapes.end()) {
        return;
    }
    bool any = table.rows() == 0 && table.has("wkt");
    for (std::size_t row = 0; table.has("wkt") && row < table.rows() && !any; ++row) {
        any = !table.text(row, "wkt").empty();
    }
    if (!any) {
        config::fail(config::ExitCode::data, {table.file()}, "a layer without geometry",
                     "a layer of points, lines or polygons",
                     "name another layer, or export this one again with its geometry");
    }
}

}  // namespace

config::Table Reading::table_at(const config::Place& place, const std::string& role,
                                const std::string& name) {
    const formats::LayerName wanted = formats::split_layer_name(name);
    const FileBytes bytes = open_at(place, role, wanted.file, "a table or layer");
    formats::ReadLayer read =
        formats::read_layer_file(bytes.text(), wanted.layer, shown(name), beside(role, wanted.file));
    open_.clear();
    config::Table& table = read.layer.table;
    if (!read.remark.empty()) {
        note(joined(table.file(), ": ", read.remark));
    }
    if (read.has_shapes_of_its_own) {
        refuse_layer_without_shapes(table, role);
    }
    take_names(table, role, read.has_shapes_of_its_own);
    if (read.has_shapes_of_its_own && table.has("wkt")) {
        if (read.layer.projection.empty()) {
            note(joined(table.file(), ": names no coordinate system; taken as that of the terrain"));
        }
        take_system(role, name, std::move(read.layer.projection));
    }
    for (const config::Problem& doubt_found : formula_doubts(table)) {
        warn(doubt_found.place, doubt_found.found, doubt_found.expected);
    }
    return std::move(table);
}

config::Raster<double> Reading::grid(const std::string& key, const std::string& role,
                                     const std::string& name) {
    const FileBytes bytes = open(key, role, name, "a grid (GeoTIFF or ESRI ASCII)");
    formats::PlacedGrid read = formats::read_grid_file(bytes.text(), shown(name), beside(role, name));
    open_.clear();
    take_system(role, name, std::move(read.projection));
    return std::move(read.raster);
}

std::string Reading::system_of(const std::string& role) const {
    const auto found = std::find_if(systems_.begin(), systems_.end(),
                                    [&](const NamedSystem& system) { return system.role == role; });
    return found == systems_.end() ? std::string{} : found->text;
}

bool Reading::check_systems() {
    const auto first = std::find_if(systems_.begin(), systems_.end(), [](const NamedSystem& system) {
        return !system.text.empty() && plausible::read_projection(system.text);
    });
    bool is_one = true;
    for (std::size_t i = systems_checked_; first != systems_.end() && i < systems_.size(); ++i) {
        const NamedSystem& system = systems_[i];
        switch (plausible::compare_systems(first->text, system.text)) {
            case plausible::Sameness::same:
            case plausible::Sameness::silent:
                break;
            case plausible::Sameness::unknown:
                warn({system.file},
                     joined("a coordinate system that cannot be compared with that of ", first->file),
                     "one coordinate system in all files");
                break;
            case plausible::Sameness::nearly:
                warn({system.file},
                     joined("coordinates in ", plausible::name_of_system(system.text), " beside ",
                            plausible::name_of_system(first->text), " of ", first->file),
                     "one coordinate system: these two differ by less than a metre");
                break;
            case plausible::Sameness::other:
                is_one = false;
                refuse({system.file}, joined("coordinates in ", plausible::name_of_system(system.text)),
                       joined("those of ", first->file, ", ", plausible::name_of_system(first->text)),
                       "transform one of them (QGIS: Reproject layer, Warp): nothing is reprojected here");
        }
    }
    systems_checked_ = systems_.size();
    return is_one;
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
    inputs_.push_back({role, shown(name), bytes.hash(), bytes.stored_bytes()});
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
