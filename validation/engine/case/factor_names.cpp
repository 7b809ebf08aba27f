#include "validation/engine/case/factor_names.hpp"

#include <map>

#include "config/text/joined.hpp"

namespace coupling::validation {
namespace {

using config::joined;

std::string without_unit(const std::string& name) {
    return name.substr(0, name.rfind(", "));
}

}  // namespace

std::string factor_name(const std::string& key) {
    static const std::map<std::string, std::string> names{
        {"stand.stems_per_ha", "stems/ha"},
        {"stand.dbh_mean_cm", "mean DBH, cm"},
        {"stand.basal_area_m2pha", "basal area, m²/ha"},
        {"stand.from_m", "upper end of the forest, m"},
        {"stand.to_m", "lower end of the forest, m"},
        {"rock.diameter_m", "rock diameter, m"},
        {"protection_effect", "protection effect"},
        {"energy_kept_share", "share of energy kept from the foot"},
        {"residual_energy_kj", "mean energy of rocks that arrive, kJ"},
        {"hits_per_rock", "tree hits per rock"},
        {"free_path_m", "way between tree hits, m"}};
    const auto found = names.find(key);
    return found == names.end() ? key : found->second;
}

std::string factor_at(const std::string& key, const std::string& value) {
    const std::string name = factor_name(key);
    const std::size_t comma = name.rfind(", ");
    return comma == std::string::npos
               ? joined(value, " ", name)
               : joined(name.substr(0, comma), " ", value, " ", name.substr(comma + 2));
}

std::string direction_name(const DirectionRow& row) {
    return joined(without_unit(factor_name(row.figure)), row.rises ? " rises with " : " falls with ",
                  without_unit(factor_name(row.setting)));
}

}  // namespace coupling::validation
