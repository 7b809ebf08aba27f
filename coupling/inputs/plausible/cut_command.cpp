#include "coupling/inputs/plausible/cut_command.hpp"

#include <cmath>
#include <filesystem>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/shell_word.hpp"
#include "coupling/inputs/formats/layer_name.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/systems/same_system.hpp"

namespace coupling::plausible {
namespace {

using config::joined;

std::string to_millimetres(double value_m) {
    constexpr double per_m = 1000.0;
    return config::to_text(std::round(per_m * value_m) / per_m);
}

}  // namespace

std::string cut_command(const Reading& reading, const std::string& role, const std::string& name,
                        const Extent& terrain) {
    const std::string layer_system = reading.given_system_of(role, name);
    const std::string terrain_system = reading.system_of_terrain();
    const Sameness sameness = compare_systems(terrain_system, layer_system);
    const std::optional<int> code = code_of_system(terrain_system);
    std::string cut;
    if (sameness == Sameness::same || sameness == Sameness::nearly) {
        cut = "-clipsrc";
    } else if (sameness == Sameness::other && code) {
        cut = joined("-t_srs EPSG:", std::to_string(*code), " -clipdst");
    } else {
        return "";
    }
    const formats::LayerName wanted = formats::split_layer_name(name);
    const std::filesystem::path file = reading.settings().resolve(wanted.file);
    std::filesystem::path out = file;
    out.replace_filename((wanted.layer.empty() ? file.stem().string() : wanted.layer) + "_cut.gpkg");
    return joined("ogr2ogr ", cut, " ", to_millimetres(terrain.west_m), " ", to_millimetres(terrain.south_m),
                  " ", to_millimetres(terrain.east_m), " ", to_millimetres(terrain.north_m), " ",
                  config::shell_word(out.string()), " ", config::shell_word(file.string()),
                  wanted.layer.empty() ? "" : " " + config::shell_word(wanted.layer));
}

std::string cut_command_of_first(const Reading& reading, const std::string& role, const std::string& setting,
                                 const Extent& terrain) {
    const std::vector<NamedTable> names = tables_in(setting);
    return names.empty() ? std::string{} : cut_command(reading, role, names.front().name, terrain);
}

}  // namespace coupling::plausible
