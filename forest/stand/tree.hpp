#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "forest/stand/patch.hpp"
#include "forest/stand/species.hpp"

namespace forest {

/// Identity of a tree, never used twice; below 2^48. Keys the tree's random numbers.
enum class TreeId : std::uint64_t {};

/// The name as a number, for the keys of random streams and for tables.
constexpr std::uint64_t number_of(TreeId id) {
    return static_cast<std::uint64_t>(id);
}

/// Origin of a tree.
enum class Origin : std::uint8_t { given, seed, sprout, planted };
inline constexpr std::size_t origin_count = 4;

/// Marks that others set and read; growth does not look at them.
struct TreeFlags {
    bool crop_tree = false;  ///< to be favoured by thinning
    bool seed_tree = false;  ///< to be left standing in regeneration cuts
    bool marked = false;     ///< to be felled at the next entry
    bool infested = false;   ///< by bark beetles
    friend bool operator==(const TreeFlags&, const TreeFlags&) = default;
};

/// The foliage of a tree and the room it takes. Follows from diameter and height (forest/stand/crown.hpp),
/// but the base remembers: it never comes down.
struct TreeCrown {
    double base_m = 0.0;        ///< [0, height), height of the lowest living branches
    double radius_m = 0.0;      ///< >= 0
    double completeness = 1.0;  ///< [0, 1.1], foliage relative to a tree with a crown of usual length
    double leaf_area_m2 = 0.0;  ///< >= 0, projected, effective of 10 m cells (below the true one)
    friend bool operator==(const TreeCrown&, const TreeCrown&) = default;
};

/// Decay inside a stem, as a cylinder around the wound it began at.
struct Rot {
    std::int32_t since_year = 0;  ///< calendar year; meaningful where depth_cm > 0
    float from_m = 0.0F;          ///< height above ground of the lower end
    float to_m = 0.0F;            ///< and of the upper one
    float depth_cm = 0.0F;        ///< radius of decayed wood, 0 = sound
    friend bool operator==(const Rot&, const Rot&) = default;
};

/// A scar. A tree has any number of them; Stand keeps them beside the trees.
struct Wound {
    TreeId tree{};
    std::int32_t year = 0;    ///< calendar year of the injury
    float height_m = 0.0F;    ///< of its centre above the ground
    float width_cm = 0.0F;    ///< along the circumference, what is still open
    float area_cm2 = 0.0F;    ///< what is still open
    float energy_use = 0.0F;  ///< energy of the hit divided by what the stem takes [-]
    friend bool operator==(const Wound&, const Wound&) = default;
};

/// A tree above 1 cm diameter or, below 5 cm, a group of equal trees on one spot (`stems` of them).
///
/// Every quantity is of one stem. Position x, y on the map; the ground height is that of the slope there.
struct Tree {
    TreeId id{};
    double x_m = 0.0;
    double y_m = 0.0;
    PatchId patch{};  ///< patch under (x_m, y_m); kept by Stand
    SpeciesId species{};
    Origin origin = Origin::given;
    TreeFlags flags{};
    std::uint32_t stems = 1;  ///< >= 1; 1 from 5 cm diameter on

    double dbh_cm = 0.0;     ///< over bark at 1.3 m, > 0
    double height_m = 0.0;   ///< > 1.3
    double age_years = 0.0;  ///< >= 0
    TreeCrown crown{};

    double light_ratio = 1.0;               ///< [0, 1], light of the last season; 1 = no neighbour shades it
    double vitality = 1.0;                  ///< [0, 1], production is proportional to its square root
    std::array<double, 3> increments_cm{};  ///< diameter growth of the last three years, latest first
    std::uint16_t stress_years = 0;         ///< bad years in a row
    Rot rot{};

    // Dry masses, kept in step by forest/growth.hpp.
    double above_ground_kg = 0.0;  ///< of stem, branches and foliage
    double stem_kg = 0.0;          ///< of the stem alone: what dead wood is made of
};

}  // namespace forest
