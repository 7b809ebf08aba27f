#include "coupling/results/geopackage/layer_look.hpp"

#include <algorithm>
#include <array>

#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::geopackage {
namespace {

constexpr Colour brown{0x8c, 0x51, 0x0a};
constexpr Colour dark_green{0x00, 0x44, 0x1b};
constexpr Colour pale_green{0xa1, 0xd9, 0x9b};
constexpr Colour blue{0x05, 0x30, 0x61};
constexpr Colour ink{0x20, 0x20, 0x20};
constexpr Colour grey{0x96, 0x96, 0x96};

/// What is known of a layer by its name.
struct NamedLook {
    const char* layer;
    const char* title;  ///< a text of the pages
    Colour colour;
    const char* energy_column;
    bool shown;
};

constexpr std::array named_looks{NamedLook{"targets", "Targets", ink, "", true},
                                 NamedLook{"target_levels", "Targets by hazard level", grey, "", false},
                                 NamedLook{"hazard_zones", "Hazard zones", grey, "", false},
                                 NamedLook{"sources", "Release sources", brown, "", true},
                                 NamedLook{"trajectories", "Trajectories", ink, "energy_max_kj", true},
                                 NamedLook{"deposits", "Stopped rocks", ink, "max_energy_kj", false},
                                 NamedLook{"deposit", "Deposit of the rock mass", grey, "", false},
                                 NamedLook{"arrivals", "Arrivals at targets", ink, "energy_kj", false},
                                 NamedLook{"trees", "Trees by energy taken", pale_green, "energy_kj", true},
                                 NamedLook{"tree_hits", "Tree hits", grey, "", false},
                                 NamedLook{"removed_trees", "Trees that rocks removed", blue, "", false},
                                 NamedLook{"logs", "Lying logs", brown, "", true},
                                 NamedLook{"log_hits", "Hits on lying logs", brown, "", false},
                                 NamedLook{"nets", "Nets", blue, "", true},
                                 NamedLook{"net_crossings", "Rocks at nets", ink, "energy_kj", false},
                                 NamedLook{"works", "Works", blue, "", true}};

bool has_column(const Plan& plan, std::string_view name) {
    return std::any_of(plan.columns.begin(), plan.columns.end(),
                       [&](const Column& column) { return column.name == name; });
}

const NamedLook* named_look(const std::string& layer) {
    const auto* const named = std::find_if(named_looks.begin(), named_looks.end(),
                                           [&](const NamedLook& each) { return layer == each.layer; });
    return named == named_looks.end() ? nullptr : named;
}

}  // namespace

std::string words_of(const std::string& sentence) {
    std::string words = report::message_text(sentence);
    if (words.ends_with('.')) {
        words.pop_back();
    }
    return words;
}

std::string layer_title(const Plan& plan) {
    constexpr std::string_view compared_zones = "hazard_zones_";
    if (plan.name.starts_with(compared_zones)) {
        return report::page_text("Hazard zones by rule {rule}, for comparison",
                                 {{"rule", plan.name.substr(compared_zones.size())}});
    }
    const NamedLook* const named = named_look(plan.name);
    return named == nullptr ? words_of(plan.sentence) : report::page_text(named->title);
}

LayerLook look_of(const Plan& plan) {
    LayerLook look;
    const NamedLook* const named = named_look(plan.name);
    if (named != nullptr) {
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
