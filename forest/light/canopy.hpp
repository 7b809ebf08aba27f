#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "forest/light/ground.hpp"
#include "forest/light/layers.hpp"
#include "forest/stand/species.hpp"

namespace forest {

/// Extinction per leaf area along the ray [-], clumping of leaves in crowns and of crowns in columns
/// included: fitted to the light of a mapped mountain stand on three slopes (validation/forest_light) with
/// leaf areas from allometry, for columns of 10 and of 5 m. The finer the columns, the less clumping they
/// hide.
inline constexpr double effective_extinction = 0.372;
inline constexpr double effective_extinction_of_5m = 0.437;

/// A tree as light sees it.
struct LightTree {
    double x_m = 0.0;
    double y_m = 0.0;
    double crown_base_m = 0.0;                 ///< [0, height)
    double height_m = 0.0;                     ///< > 0; what stands above 60 m counts as the top layer
    double crown_radius_m = 0.0;               ///< >= 0
    double leaf_area_m2 = 0.0;                 ///< >= 0, one-sided, effective of columns of 10 m
    double extinction = effective_extinction;  ///< (0, 1] [-]
    CrownShape shape = CrownShape::paraboloid;
    bool deciduous = false;
};

/// The share of a tree's leaves in one cell of the canopy.
struct LeafShare {
    std::uint32_t cell = 0;  ///< column * canopy_layers + layer
    float share = 0.0F;      ///< of the tree's leaf area; those of a tree sum up to 1
};

/// Extinction-weighted leaf area per ground area below each height of every column, prefix sums over the
/// layers, made so that a ray needs no case: K is 0 at the ground, constant above the highest layer, and
/// falls steeply below the ground, where a ray that meets rising terrain ends.
///
///   node   0 ... 11   12    13   ...   24   25 ... 39
///   h   -60 ... -5     0     5   ...   60   65 ... 135 m
struct PrefixSums {
    static constexpr std::size_t nodes_below = canopy_layers;
    static constexpr std::size_t nodes = 40;
    static constexpr float soil_per_m = 50.0F;  ///< extinction below the ground: an opaque body

    std::vector<float> below;  ///< nodes of all padded columns [-]

    [[nodiscard]] const float* of(std::size_t padded_column) const {
        return below.data() + padded_column * nodes;
    }
};

/// The leaves of a forest in columns and layers, built once a year.
///
/// A crown is cut into four rings of equal area and each into four points; a point carries the leaves above
/// its ring, from the lower to the upper surface of the crown, to the column it lies in. Sums are taken in
/// whole numbers, so neither the order of the trees nor that of threads changes a bit.
class Canopy {
public:
    /// Trees outside the area are taken into the column at its border, on a torus to where they belong.
    Canopy(const PaddedGround& ground, std::span<const LightTree> trees);

    /// Leaf cells of a tree, in the order of columns and layers.
    [[nodiscard]] std::span<const LeafShare> cells_of(std::size_t tree) const {
        return {shares_.data() + first_share_[tree], shares_.data() + first_share_[tree + 1]};
    }
    [[nodiscard]] std::size_t trees() const { return first_share_.size() - 1; }

    [[nodiscard]] const PrefixSums& leaf_on() const { return leaf_on_; }
    /// Without the leaves of deciduous trees.
    [[nodiscard]] const PrefixSums& leaf_off() const { return leaf_off_; }

    /// Share of extinction that falls with the leaves [0, 1]; 0 without trees.
    [[nodiscard]] double deciduous_share() const { return deciduous_share_; }

    /// Upper end of the highest layer with leaves of a column and of the whole area, 0 without leaves [m].
    [[nodiscard]] std::size_t layers_used(std::size_t column) const { return layers_used_[column]; }
    [[nodiscard]] double top_m() const { return top_m_; }

private:
    std::vector<LeafShare> shares_;
    std::vector<std::size_t> first_share_{0};
    PrefixSums leaf_on_;
    PrefixSums leaf_off_;
    std::vector<std::uint8_t> layers_used_;
    double deciduous_share_ = 0.0;
    double top_m_ = 0.0;
};

}  // namespace forest
