#include <map>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/assessments/today/report/shown_window.hpp"
#include "coupling/results/report/scene.hpp"
#include "coupling/results/report/species_colours.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "forest/stand/species.hpp"

namespace coupling::report {
namespace {

using config::joined;

constexpr std::size_t most_paths = 250;

/// Colour and shape of a code of the tree list: those of the forest model where it knows the species.
SceneSpecies species_of(const std::string& code, const forest::SpeciesTable& known) {
    const auto found = known.find(code);
    if (!found) {
        return {code, "#777777", false};
    }
    const forest::Species& species = known[*found];
    return {joined(species.latin_name, " (", code, ")"), colour_of_species(forest::index_of(*found)).on_light,
            species.conifer};
}

/// A stem that ends below its top, a dead one, or a living tree. Dead ones of a list are known by their wood,
/// which is no longer that of sound trees.
TreeState state_of(const rockfall::Stem& stem) {
    return stem.broken_at_m > 0.0 ? TreeState::broken
           : stem.strength < 1.0  ? TreeState::dead
                                  : TreeState::living;
}

void add_trees(const Site& site, Scene& scene) {
    const forest::SpeciesTable known = forest::SpeciesTable::shipped();
    std::map<std::string, std::uint8_t> places;
    SceneStand stand;
    for (const TreeRecord& tree : site.trees) {
        const auto [place, is_new] =
            places.try_emplace(tree.species, static_cast<std::uint8_t>(scene.species.size()));
        if (is_new) {
            scene.species.push_back(species_of(tree.species, known));
        }
        const rockfall::Stem& stem = tree.stem;
        const TreeState state = state_of(stem);
        stand.trees.push_back({.x_m = stem.x_m,
                               .y_m = stem.y_m,
                               .dbh_cm = stem.dbh_cm,
                               .height_m = state == TreeState::broken ? stem.broken_at_m : stem.height_m,
                               .species = place->second,
                               .state = state});
    }
    scene.stands.push_back(std::move(stand));
}

}  // namespace

std::string slope_view(const RunResults& results) {
    const config::Raster<double> heights = part_of(results.site.heights, shown_window(results));
    Scene scene{.heights = heights,
                .targets = results.site.targets,
                .origin_m = results.site.origin_m(),
                .picture = results.site.picture.get()};
    if (results.with_forest) {
        add_trees(results.site, scene);
    }
    for (const Cover cover : covers_of(results)) {
        std::vector<const rockfall::PathRecord*> paths;
        for (const rockfall::PathRecord& path : results.paths) {
            if (path.cover == cover && path.points.size() > 1) {
                paths.push_back(&path);
            }
        }
        const std::size_t step = paths.size() / most_paths + 1;
        for (std::size_t i = 0; i < paths.size(); i += step) {
            scene.paths.push_back(paths[i]);
        }
    }
    return scene_figure(scene, page_text("This view needs scripts and WebGL. The maps below show the same "
                                         "ground, paths and targets from above."));
}

}  // namespace coupling::report
