#include "coupling/inputs/formats/layer_name.hpp"

#include <filesystem>
#include <string_view>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/reading.hpp"

namespace coupling::formats {
namespace {

[[noreturn]] void refuse_part(const std::string& name, std::string_view part) {
    config::fail(
        config::ExitCode::settings, {name}, config::joined("the part ", config::in_quotes(part), " behind |"),
        "file|layer",
        "leave it out; save the features of a filter as a layer of their own (QGIS: Save features as)");
}

}  // namespace

LayerName split_layer_name(const std::string& name) {
    const std::size_t bar = name.find('|');
    if (bar == std::string::npos) {
        return {name, ""};
    }
    LayerName found{name.substr(0, bar), ""};
    std::string_view rest = std::string_view{name}.substr(bar + 1);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('|'), rest.size());
        const std::string_view part = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        constexpr std::string_view of_qgis = "layername=";
        const std::size_t equals = part.find('=');
        const std::string key = config::in_lower_case(part.substr(0, std::min(equals, part.size())));
        const bool is_other_key = equals != std::string_view::npos &&
                                  (key == "subset" || key == "layerid" || key == "geometrytype" ||
                                   key == "option" || key == "uniquegeometrytype" || key == "authcfg");
        if (!found.layer.empty() || is_other_key) {
            refuse_part(name, part);
        }
        found.layer = part.starts_with(of_qgis) ? part.substr(of_qgis.size()) : part;
    }
    // QGIS writes the name of the file itself for formats that hold one layer.
    const std::filesystem::path path{found.file};
    if (found.layer == path.stem().string() && config::in_lower_case(path.extension().string()) == ".shp") {
        found.layer.clear();
    }
    return found;
}

}  // namespace coupling::formats
