#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "forest/light/light.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// Light of the season by height on every patch, metre by metre.
///
/// Cells of 5 m know one light for all leaves in them: in a stand of 8 m all trees would be equal. Where
/// leaves lie within a layer is known from the trees of the patch. A cell's light is that under half of its
/// leaves; in between light falls off with the leaves overhead as Beer and Lambert have it. Heights of the
/// same layer so differ, and the mean of a layer stays what the light model says.
class LightProfiles {
public:
    static constexpr std::size_t metres = static_cast<std::size_t>(canopy_height_m);

    LightProfiles(const Stand& stand, const SpeciesTable& species, const LightSite& site,
                  const Canopy& canopy, const LightField& field);

    /// Light relative to the open at a height above the ground [0, 1].
    [[nodiscard]] double at(PatchId patch, double height_m) const;
    /// The light of the cell there.
    [[nodiscard]] double in_cell(PatchId patch, double height_m) const;
    /// Height below which there is less light than `wanted`; 0 if there is enough at the ground.
    [[nodiscard]] double shaded_below_m(PatchId patch, double wanted) const;

private:
    using Profile = std::array<float, metres + 1>;  ///< at 0, 1, 2 ... m
    std::vector<Profile> fine_;
    std::vector<std::array<float, canopy_layers>> coarse_;
};

/// Light of a crown whose height within the layers is known, relative to that of the cells it is in.
double within_layers(const LightProfiles& profiles, const Tree& tree, CrownShape shape);

}  // namespace forest
