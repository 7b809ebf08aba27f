#include "coupling/inputs/reading/reading.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "config/text/coordinates.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/files/files_beside.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/reading/stands_of_today.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/scenario/terrain_settings.hpp"
#include "coupling/inputs/scenario/tree_settings.hpp"
#include "coupling/inputs/systems/same_system.hpp"
#include "coupling/inputs/systems/transform_layer.hpp"
#include "coupling/inputs/tables/prepare.hpp"

namespace coupling {

using config::joined;

Reading::Reading(const Scenario& scenario, config::Warnings& warnings)
    : scenario_{scenario}, settings_{scenario}, warnings_{warnings} {}

const RunSettings& Reading::run() const {
    return scenario_.run;
}

const TerrainSettings& Reading::terrain() const {
    return scenario_.terrain;
}

const ProfileSettings& Reading::profile() const {
    return scenario_.profile;
}

const TreeSettings& Reading::trees() const {
    return scenario_.trees;
}

const ReleaseSettings& Reading::release() const {
    return scenario_.release;
}

const TargetSettings& Reading::targets() const {
    return scenario_.targets;
}

const ObservedSettings& Reading::observed() const {
    return scenario_.observed;
}

const NetSettings& Reading::nets() const {
    return scenario_.nets;
}

const WorkSettings& Reading::works() const {
    return scenario_.works;
}

const HazardSettings& Reading::hazard() const {
    return scenario_.hazard;
}

const OutputSettings& Reading::output() const {
    return scenario_.output;
}

const ForestSettings& Reading::forest() const {
    return scenario_.forest;
}

const rockfall::Parameters& Reading::rockfall() const {
    return scenario_.rockfall;
}

void Reading::warn(config::Place place, std::string found, std::string expected, std::string advice,
                   config::Effect effect) {
    config::Problem problem{config::ExitCode::data, std::move(place), std::move(found), std::move(expected),
                            std::move(advice)};
    if (run().strict_inputs) {
        problems_.add(std::move(problem));
    } else {
        problem.place = settings_.shown(std::move(problem.place));
        warnings_.add(config::to_string(problem), effect);
    }
}

void Reading::take(const config::Warnings& found, const std::string& opening) {
    for (std::size_t i = 0; i < found.warnings().size(); ++i) {
        warn(joined(opening, found.warnings()[i]), found.effects()[i]);
    }
    for (const std::string& sentence : found.notes()) {
        note(joined(opening, sentence));
    }
}

namespace {

/// "release.rocks, release.shape"; of many keys the sections: "settings of [climate], [forest]".
std::string keys_or_sections(const std::vector<std::string>& keys) {
    constexpr std::size_t many = 4;
    std::string text;
    for (const std::string& key : keys) {
        const std::string name =
            keys.size() <= many ? key : joined("[", std::string_view{key}.substr(0, key.rfind('.')), "]");
        if (keys.size() <= many || text.find(name) == std::string::npos) {
            text += (text.empty() ? "" : ", ") + name;
        }
    }
    return keys.size() <= many ? text : joined("settings of ", text);
}

}  // namespace

void Reading::note_settings() {
    for (config::Renaming renaming : settings_.options->renamings()) {
        renaming.place = settings_.shown(std::move(renaming.place));
        note(config::to_string(renaming));
    }
    const bool has_stands = has_stands_of_today(run(), trees(), forest());
    const auto is_undrawn = [&](const std::string& key) {
        return std::any_of(scenario_.undrawn.begin(), scenario_.undrawn.end(),
                           [&](const Undrawn& undrawn) { return undrawn.is_all && undrawn.key == key; });
    };
    for (config::IdleSettings& idle : settings_.options->idle()) {
        if (has_stands) {
            std::erase_if(idle.keys, describes_stands_of_today);
        }
        if (!trees().canopy.empty()) {
            std::erase(idle.keys, "trees.species");
            std::erase(idle.keys, "trees.species_areas");
        }
        if (idle.keys.empty()) {
            continue;
        }
        if (std::erase_if(idle.keys, is_undrawn) > 0 && idle.keys.empty()) {
            continue;  // that nothing is drawn in it is noted by itself
        }
        const char* have = idle.keys.size() == 1 ? " has" : " have";
        note(joined(keys_or_sections(idle.keys), have, " no effect", idle.value.empty() ? " without " : ": ",
                    idle.other, idle.value.empty() ? "" : " is ", idle.value));
    }
}

FileBytes Reading::open_at(const config::Place& place, const std::string& role, const std::string& name,
                           std::string_view expected) {
    FileBytes bytes = open_file(settings_.resolve(name), place, expected);
    inputs_.push_back({role, shown(name), bytes.hash(), bytes.stored_bytes()});
    return bytes;
}

FileBytes Reading::open(const std::string& key, const std::string& role, const std::string& name,
                        std::string_view expected) {
    return open_at(settings_.options->place_of(key), role, name, expected);
}

config::Table Reading::table(const std::string& key, const std::string& role, const std::string& name,
                             const std::string& id_opening) {
    return table_at(settings_.options->place_of(key), role, name, id_opening);
}

/// Files beside a file are opened as they are asked for, and recorded: what they say matters too.
formats::BytesBeside Reading::beside(const std::string& role, const std::string& file) {
    return [this, role, file](const std::string& ending) -> std::string_view {
        const std::string name = name_beside(file, ending);
        if (!path_exists(settings_.resolve(name))) {
            return {};
        }
        FileBytes bytes = open_file(settings_.resolve(name), {shown(name)}, "a readable file");
        if (bytes.stored_bytes() == 0) {
            return {};  // as SQLite leaves them behind
        }
        open_.push_back(std::move(bytes));
        // The projection of the terrain has had this name ever since.
        const std::string of = ending == ".prj" && role == "dem" ? "projection" : joined(role, " ", ending);
        inputs_.push_back({of, shown(name), open_.back().hash(), open_.back().stored_bytes()});
        return open_.back().text();
    };
}

std::string Reading::name_beside(const std::string& file, const std::string& ending) const {
    const std::filesystem::path found = path_beside(settings_.resolve(file), ending);
    return std::filesystem::path{file}.replace_filename(found.filename()).string();
}

bool Reading::has_input(const std::string& role) const {
    return std::any_of(inputs_.begin(), inputs_.end(),
                       [&](const InputFile& input) { return input.role == role; });
}

void Reading::take_system(const std::string& role, const std::string& name, std::string text,
                          std::string given) {
    systems_.push_back({role, shown(name), std::move(text), std::move(given)});
}

void Reading::take_findings(const tables::Findings& findings) {
    for (const std::string& sentence : findings.notes) {
        note(sentence);
    }
    for (const config::Problem& warning : findings.warnings) {
        warn(warning.place, warning.found, warning.expected, warning.advice, config::Effect::part);
    }
    for (const config::Problem& error : findings.errors) {
        problems_.add(error);
    }
}

void Reading::check_files_of_settings() {
    for (const config::ParameterRow& row : settings_.options->rows()) {
        if (row.key == "calibrate.sites") {
            continue;  // other scenarios: `bannwald calibrate` alone reads them, and says what is wrong
        }
        for (const std::string& name : files_in(row)) {
            const config::Place place = settings_.options->place_of(row.key);
            const auto& known = problems_.list();
            const bool is_known =
                std::any_of(known.begin(), known.end(), [&](const config::Problem& problem) {
                    return problem.place.line == place.line && problem.place.column == place.column &&
                           problem.code == config::ExitCode::file;
                });
            const std::string advice = advice_on_missing(name);
            if (!is_known && !path_exists(settings_.resolve(formats::split_layer_name(name).file))) {
                problems_.add(config::ExitCode::file, place,
                              joined(row.key, ", which names no file: ", config::in_quotes(name)),
                              "a file that is there, as this setting names it",
                              advice.empty() ? "correct the name, or remove the line" : advice);
            }
        }
    }
}

namespace {

/// The use of a table without the columns that only another role of the same file reads, such as the records
/// of stands beside their polygons.
config::ColumnUse own_part(const config::ColumnUse& use,
                           std::span<const std::shared_ptr<const config::ColumnUse>> all) {
    config::ColumnUse own = use;
    std::erase_if(own.columns, [&](const config::ColumnUse::Column& column) {
        return !column.is_read && std::any_of(all.begin(), all.end(), [&](const auto& other) {
            return other->file == use.file &&
                   std::any_of(other->columns.begin(), other->columns.end(),
                               [&](const auto& same) { return same.is_read && same.found == column.found; });
        });
    });
    return own;
}

}  // namespace

void Reading::finish() {
    check_files_of_settings();
    for (const auto& use : uses_) {
        take_findings(tables::findings_of_use(own_part(*use, uses_)));
    }
    uses_.clear();
    problems_.throw_if_any();
}

namespace {

/// Layers that a GIS wrote without shapes, where shapes are what is wanted.
void refuse_layer_without_shapes(const config::Table& table, const std::string& role) {
    if (!tables::is_of_shapes(role)) {
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

bool Reading::is_of_terrain(const NamedSystem& system) {
    return (system.role == "dem" || system.role == "terrain") && !system.text.empty() &&
           plausible::read_projection(system.text);
}

std::string Reading::system_of_terrain() const {
    const auto found = std::find_if(systems_.begin(), systems_.end(), is_of_terrain);
    return found == systems_.end() ? std::string{} : found->text;
}

std::string Reading::given_system_of(const std::string& role, const std::string& name) const {
    const std::string file = shown(name);
    const auto found = std::find_if(systems_.begin(), systems_.end(), [&](const NamedSystem& system) {
        return system.role == role && system.file == file;
    });
    return found == systems_.end() ? std::string{} : found->given;
}

void Reading::transform(formats::Layer& layer) {
    // Into that of the terrain alone: two layers of which none is the terrain's are refused.
    const auto first = std::find_if(systems_.begin(), systems_.end(), is_of_terrain);
    if (first == systems_.end() ||
        plausible::compare_systems(first->text, layer.projection) != plausible::Sameness::other) {
        return;
    }
    const systems::Transformed done = systems::transform_layer(layer, first->text, first->file);
    note(done.note);
    if (!done.warning.empty()) {
        warn({layer.table.file()}, done.warning, "a transformation that is accurate to 5 m",
             "transform the layer in a GIS with the grid of the survey office (QGIS: Reproject layer)");
    }
}

config::Table Reading::table_at(const config::Place& place, const std::string& role, const std::string& name,
                                const std::string& id_opening) {
    const formats::LayerName wanted = formats::split_layer_name(name);
    const FileBytes bytes = open_at(place, role, wanted.file, "a table or layer");
    formats::ReadLayer read =
        formats::read_layer_file(bytes.text(), wanted.layer, shown(name), beside(role, wanted.file));
    open_.clear();
    config::Table& table = read.layer.table;
    const std::string given_system = read.layer.projection;
    if (!read.remark.empty()) {
        note(joined(table.file(), ": ", read.remark));
    }
    if (read.has_shapes_of_its_own) {
        refuse_layer_without_shapes(table, role);
        if (table.has("wkt")) {
            transform(read.layer);
        }
    }
    take_findings(tables::prepare(table, role, read.has_shapes_of_its_own, id_opening));
    uses_.push_back(table.use());
    if (read.has_shapes_of_its_own && table.has("wkt")) {
        if (read.layer.projection.empty()) {
            note(joined(table.file(), ": names no coordinate system; taken as that of the terrain"));
        }
        take_system(role, name, std::move(read.layer.projection), given_system);
    }
    return std::move(table);
}

grids::GridFiles Reading::grid_files(const std::string& role) {
    // Each tile is an input of its own, which a comparison of runs tells from others by its role.
    const auto role_of = [this, role](const std::string& name, bool is_tile) {
        return is_tile ? joined(role, " ", shown(name)) : role;
    };
    return {.path = [this](const std::string& name) { return settings_.resolve(name); },
            .shown = [this](const std::string& name) { return shown(name); },
            .open =
                [this, role_of](const std::string& name, const config::Place& asked_at, bool is_tile) {
                    return open_at(asked_at, role_of(name, is_tile), name, "a grid (GeoTIFF or ESRI ASCII)");
                },
            .beside = [this, role_of](const std::string& name,
                                      bool is_tile) { return beside(role_of(name, is_tile), name); }};
}

config::Raster<double> Reading::grid(const std::string& key, const std::string& role,
                                     const std::string& name) {
    const bool is_on_dem = role == "dem" || role == "surface" || role == "source";
    const std::vector<double>& extent_m = terrain().extent_m;
    std::optional<grids::MapWindow> window;
    if (is_on_dem && extent_m.size() == 4) {
        window = {extent_m[0], extent_m[1], extent_m[2], extent_m[3]};
    } else if (role == "canopy" && extent_m.size() == 4) {
        constexpr double crown_m = 30.0;  // crowns at the border of the part stay whole
        window = {extent_m[0] - crown_m, extent_m[1] - crown_m, extent_m[2] + crown_m, extent_m[3] + crown_m};
    }
    const bool are_heights = role == "dem";
    const std::vector<std::string> names = are_heights ? list_of_files(name) : std::vector{name};
    grids::ReadGrid read = grids::read_grid(
        names, settings_.options->place_of(key),
        are_heights ? grids::GridValues::heights : grids::GridValues::codes, window, grid_files(role));
    open_.clear();
    take_findings({std::move(read.notes), std::move(read.warnings), {}});
    take_system(role, names.front(), std::move(read.projection));
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
                     "one coordinate system: these two differ by less than a metre", "",
                     config::Effect::detail);
                break;
            case plausible::Sameness::other:
                is_one = false;
                refuse({system.file}, joined("coordinates in ", plausible::name_of_system(system.text)),
                       joined("those of ", first->file, ", ", plausible::name_of_system(first->text)),
                       "transform one of them (QGIS: Warp; gdalwarp -t_srs): grids are never resampled here");
        }
    }
    systems_checked_ = systems_.size();
    return is_one;
}

void Reading::use_part_of(const std::string& role, const std::string& part, const std::string& hash) {
    for (InputFile& input : inputs_) {
        if (input.role == role) {
            input.role = joined(role, ", ", part);
            input.hash = hash;
        }
    }
}

std::string Reading::text_beside(const std::string& role, const std::string& name) {
    if (!path_exists(settings_.resolve(name))) {
        return {};
    }
    const FileBytes bytes = open_file(settings_.resolve(name), {shown(name)}, "a readable text file");
    inputs_.push_back({role, shown(name), bytes.hash(), bytes.stored_bytes()});
    return std::string{bytes.text()};
}

}  // namespace coupling
