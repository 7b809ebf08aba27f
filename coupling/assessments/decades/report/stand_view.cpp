#include <algorithm>
#include <map>
#include <optional>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/results/report/scene.hpp"
#include "coupling/results/report/species_colours.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::Scene;
using report::SceneStand;

/// The trees of a member by year.
void add_stands(const RegimeView& regime, const std::string& name, Scene& scene) {
    std::map<std::int32_t, SceneStand> stands;
    for (const TreeRow& tree : regime.first->trees) {
        SceneStand& stand = stands[tree.year];
        stand.trees.push_back({.x_m = tree.x_m,
                               .y_m = tree.y_m,
                               .dbh_cm = static_cast<double>(tree.dbh_cm),
                               .height_m = static_cast<double>(tree.height_m),
                               .crown_base_m = static_cast<double>(tree.crown_base_m),
                               .crown_radius_m = static_cast<double>(tree.crown_radius_m),
                               .species = static_cast<std::uint8_t>(tree.species)});
    }
    for (const DeadWoodRow& piece : regime.first->dead_wood) {
        SceneStand& stand = stands[piece.year];
        if (piece.height_m > 0.0F) {
            stand.trees.push_back(
                {.x_m = piece.x_m,
                 .y_m = piece.y_m,
                 .dbh_cm = static_cast<double>(piece.thick_cm),
                 .height_m = static_cast<double>(piece.height_m),
                 .species = static_cast<std::uint8_t>(piece.species),
                 .state = piece.broken != 0 ? report::TreeState::broken : report::TreeState::dead});
        } else {
            stand.logs.push_back({piece.x_m, piece.y_m, static_cast<double>(piece.plan_m),
                                  static_cast<double>(piece.direction_rad)});
        }
    }
    std::optional<std::uint64_t> rock;
    for (const PathCornerRow& corner : regime.first->paths) {
        auto& paths = stands[corner.year].paths;
        if (paths.empty() || rock != corner.rock) {
            paths.emplace_back();
        }
        rock = corner.rock;
        paths.back().push_back({{corner.x_m, corner.y_m, corner.z_m}, 1000.0F * corner.energy_kj, 0.0F});
    }
    for (auto& [year, stand] : stands) {
        stand.year = year;
        stand.regime = name;
        const auto same =
            std::find_if(scene.stands.begin(), scene.stands.end(), [&](const SceneStand& other) {
                return !other.same_as && other.year == stand.year && other.trees == stand.trees &&
                       other.logs == stand.logs;
            });
        if (same != scene.stands.end()) {
            stand.same_as = static_cast<std::size_t>(same - scene.stands.begin());
            stand.trees.clear();
            stand.logs.clear();
            stand.paths.clear();
        }
        scene.stands.push_back(std::move(stand));
    }
}

}  // namespace

std::string view_of_years(const PageContent& content, const RunView& run) {
    if (content.site == nullptr || run.regimes.empty()) {
        return "";
    }
    Scene scene{
        .heights = content.site->heights,
        .targets = content.site->targets,
        .origin_m = content.site->targets.empty() ? Eigen::Vector2d{0.0, 0.0} : content.site->origin_m(),
        .picture = content.site->picture.get()};
    for (std::size_t s = 0; s < content.names.species.size(); ++s) {
        const forest::Species& species = content.names.species.all()[s];
        scene.species.push_back({joined(species.latin_name, " (", species.code, ")"),
                                 report::colour_of_species(s).on_light, species.conifer});
    }
    for (const RegimeView& regime : run.regimes) {
        add_stands(regime, run.regimes.size() > 1 ? regime.title() : "", scene);
    }
    if (scene.stands.empty()) {
        return "";
    }
    return report::scene_figure(scene, report::page_text("This view needs scripts and WebGL. The stand from "
                                                         "above and from the side is drawn further below."));
}

}  // namespace coupling::decades
