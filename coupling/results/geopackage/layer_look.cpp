#include "coupling/results/geopackage/layer_look.hpp"

#include <algorithm>
#include <array>

namespace coupling::geopackage {
namespace {

constexpr Colour brown{0x8c, 0x51, 0x0a};
constexpr Colour dark_green{0x00, 0x44, 0x1b};
constexpr Colour pale_green{0xa1, 0xd9, 0x9b};
constexpr Colour blue{0x05, 0x30, 0x61};
constexpr Colour ink{0x20, 0x20, 0x20};

/// What is known of a layer by its name.
struct NamedLook {
    const char* layer;
    Colour colour;
    const char* energy_column;
    bool shown;
};

constexpr std::array named_looks{NamedLook{"targets", ink, "", true},
                                 NamedLook{"sources", brown, "", true},
                                 NamedLook{"trajectories", ink, "energy_max_kj", true},
                                 NamedLook{"deposits", ink, "max_energy_kj", false},
                                 NamedLook{"arrivals", ink, "energy_kj", false},
                                 NamedLook{"trees", pale_green, "energy_kj", true},
                                 NamedLook{"logs", brown, "", true},
                                 NamedLook{"log_hits", brown, "", false},
                                 NamedLook{"nets", blue, "", true},
                                 NamedLook{"works", blue, "", true},
                                 NamedLook{"net_crossings", ink, "energy_kj", false},
                                 NamedLook{"removed_trees", blue, "", false}};

bool has_column(const Plan& plan, std::string_view name) {
    return std::any_of(plan.columns.begin(), plan.columns.end(),
                       [&](const Column& column) { return column.name == name; });
}

}  // namespace

LayerLook look_of(const Plan& plan) {
    LayerLook look;
    const auto* const named = std::find_if(named_looks.begin(), named_looks.end(),
                                           [&](const NamedLook& each) { return plan.name == each.layer; });
    if (named != named_looks.end()) {
        look.colour = named->colour;
        look.energy_column = named->energy_column;
        look.shown = named->shown;
    }
    if (plan.name == "trees" && has_column(plan, "regime")) {
        look.energy_column = "rock_energy_kj";
        look.shown = false;  // of many years
    }
    if (plan.name == "tree_hits") {
        look.class_column = "broken";
        look.classes = {{"no", "tree held", dark_green}, {"yes", "tree broken", ink}};
    } else if (!plan.drawn_by.empty()) {
        look.class_column = plan.drawn_by;
        look.classes = plan.classes;
    }
    return look;
}

}  // namespace coupling::geopackage
