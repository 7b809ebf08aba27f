#include "coupling/inputs/drawing/undrawn.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/files_beside.hpp"
#include "coupling/inputs/formats/geopackage_layer.hpp"
#include "coupling/inputs/formats/layer_name.hpp"

namespace coupling {
namespace {

using config::joined;

std::vector<std::string> empty_layers_in(const Drawing& drawing) {
    if (!formats::split_layer_name(drawing.name).layer.empty()) {
        config::fail(config::ExitCode::settings, drawing.place,
                     joined("run.drawing = ", drawing.name, ", a layer of a GeoPackage"),
                     "the GeoPackage alone", "leave out | and what follows: other settings name its layers");
    }
    const std::filesystem::path file = drawing.path_of(drawing.name);
    const FileBytes bytes = open_file(file, drawing.place, "a GeoPackage to draw in");
    if (!formats::is_database(bytes.text())) {
        config::fail(config::ExitCode::data, {file.string()}, "a file that is no GeoPackage",
                     "the GeoPackage that is drawn in, as run.drawing",
                     "name the .gpkg, or remove the line run.drawing");
    }
    FilesBeside beside{file};
    const formats::BytesBeside bytes_beside = beside.bytes();
    return formats::empty_layers_of(bytes.text(), file.string(),
                                    {bytes_beside("-wal"), bytes_beside("-journal")});
}

}  // namespace

std::vector<Undrawn> take_out_undrawn(const Drawing& drawing, std::span<const LayerSetting> settings) {
    const std::vector<std::string> empty = empty_layers_in(drawing);
    const std::filesystem::path file = drawing.path_of(drawing.name);
    std::vector<Undrawn> undrawn;
    for (const LayerSetting& setting : settings) {
        Undrawn found{setting.key, {}, false};
        std::string kept;
        for (const std::string& name : setting.names) {
            const formats::LayerName layer = formats::split_layer_name(name);
            const bool is_empty = drawing.path_of(layer.file) == file &&
                                  std::find(empty.begin(), empty.end(), layer.layer) != empty.end();
            if (is_empty) {
                found.layers.push_back(layer.layer);
            } else {
                kept += joined(kept.empty() ? "" : ", ", name);
            }
        }
        if (!found.layers.empty()) {
            found.is_all = kept.empty();
            setting.value = std::move(kept);
            undrawn.push_back(std::move(found));
        }
    }
    return undrawn;
}

}  // namespace coupling
