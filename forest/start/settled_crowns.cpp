#include "forest/start/settled_crowns.hpp"

#include <vector>

#include "forest/light/layer_light.hpp"
#include "forest/stand/allometry.hpp"
#include "forest/stand/crown.hpp"

namespace forest {

void settle_crowns(std::span<Tree> trees, const SpeciesTable& species, double area_m2) {
    constexpr int rounds = 20;
    constexpr double rise_m = 0.3;  // and 0.3 m of branches lost: 12 m in all, in steps that light can follow
    for (int round = 0; round < rounds; ++round) {
        const std::vector<LayerLight> light = layer_light(trees, species, area_m2);
        for (std::size_t i = 0; i < trees.size(); ++i) {
            Tree& tree = trees[i];
            const Species& kind = species[tree.species];
            tree.crown = next_crown(kind, tree.crown,
                                    {.dbh_cm = tree.dbh_cm,
                                     .height_m = tree.height_m,
                                     .height_growth_m = rise_m,
                                     .light_ratio = light[i].light_ratio,
                                     .shaded_below_m = light[i].shaded_below_m});
        }
    }
    for (Tree& tree : trees) {
        const PartMasses masses =
            part_masses(species[tree.species].allometry, tree.dbh_cm, tree.height_m, tree.crown.completeness);
        tree.above_ground_kg = masses.above_ground_kg();
        tree.stem_kg = masses.stem_kg;
    }
}

}  // namespace forest
