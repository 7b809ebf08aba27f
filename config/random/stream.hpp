#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstdint>

namespace config {

/// What a random number is for. Each purpose of each rock or tree has numbers of its own, so that
/// one more draw here moves nothing there.
enum class Purpose : std::uint8_t {
    release = 1,         ///< start point, size and direction of a rock
    ground_impact = 2,   ///< noise, jump angle, deviation and stop at one ground contact
    tree_impact = 3,     ///< deviation at one tree hit
    rolling = 4,         ///< stop and deviation on one stretch of rolling
    stand = 5,           ///< positions of artificial trees
    sampling = 6,        ///< which rocks a sample shows
    relief = 7,          ///< height of one node of a synthetic relief
    facet = 8,           ///< facet of rough ground at one ground contact
    block_shape = 9,     ///< shape, sides and attitude of a rock that is no sphere
    rock_losses = 10,    ///< elongation of a rock, and what it loses at contacts beside it
    roughness = 11,      ///< bumps of the ground below the cells of the terrain, as one rock meets them
    block = 20,          ///< size and place of one block of a virtual surface
    rock_throw = 21,     ///< start of one throw at a virtual surface
    tree_place = 40,     ///< where a tree stands that leaves a group of young ones
    tree_death = 41,     ///< whether a tree dies this year: of age, of stress
    tree_rank = 42,      ///< scatter of a tree's place in the order of self-thinning
    starting_tree = 43,  ///< size and place of one tree of a starting stand
    group_centre = 44,   ///< centre of one group of young trees of a starting stand
    weather = 45,        ///< which year of the climate stands for a simulated one
    seed_year = 46,      ///< whether a species bears a full crop this year
    establishment = 47,  ///< seedlings of one patch and year
    sapling = 48,        ///< browsing and death of the young trees of one patch and year
    young_place = 49,    ///< where on its patch a young tree comes to stand
    dead_wood = 50,      ///< breakage and fall of one snag, rolling of one log
    wounding = 51,       ///< what a hit does to a tree, and whether it dies of old wounds
    treatment = 52,      ///< choices within one intervention on one tree
    wind = 53,           ///< a year's storm, and what it does to a tree
    snow = 54,           ///< whether snow falls wet in a year, and what it does to a tree
    beetle = 55,         ///< waking and flights of the bark beetles of one patch
    tree_kind = 56,      ///< how a tree grows for life beside others of its species, size and place
    unseen_tree = 57,    ///< of a tree that a scan or a record may lack: whether, and where it stands
    real_rock = 70,      ///< whether a simulated rock is one of those that really fall in a year
    rock_stratum = 71,   ///< to which stratum each of the rocks that follow one another belongs
    parameter = 72,      ///< a parameter that is not known, drawn for each stratum of rocks
    test = 255,
};

/// Whose random numbers: the identity that keys a stream.
struct StreamKey {
    std::uint64_t seed = 0;
    std::uint32_t replicate = 0;
    std::uint16_t year = 0;
    std::uint64_t id = 0;  ///< rock or tree, below 2^48
};

/// Four independent uniform numbers of one event.
using FourUniforms = std::array<double, 4>;

/// Counter-based random numbers: a pure function of identity, purpose and draw number.
///
/// The counter of Philox4x32-10 (Salmon et al. 2011) holds the identity itself, bit by bit, so two
/// identities never share a number; the key holds the seed. Nothing depends on threads, on order or
/// on how many draws others made.
class RandomStream {
public:
    RandomStream(const StreamKey& key, Purpose purpose)
        : key_{{static_cast<std::uint32_t>(key.seed), static_cast<std::uint32_t>(key.seed >> 32)}},
          purpose_{static_cast<std::uint32_t>(purpose) << 24},
          id_low_{static_cast<std::uint32_t>(key.id)},
          id_high_year_{(static_cast<std::uint32_t>(key.id >> 32) << 16) | key.year},
          replicate_{key.replicate} {}

    /// Four uniforms on [0, 1) of event number `event` (below 2^24), whatever was drawn before.
    [[nodiscard]] FourUniforms uniforms_of(std::uint32_t event) const {
        const Philox::ctr_type bits =
            Philox{}({{purpose_ | (event & 0xFFFFFFU), id_low_, id_high_year_, replicate_}}, key_);
        constexpr double to_unit = 1.0 / 4294967296.0;
        return {bits[0] * to_unit, bits[1] * to_unit, bits[2] * to_unit, bits[3] * to_unit};
    }

    /// The next uniform on [0, 1), event after event, 53 bits.
    double uniform() {
        const Philox::ctr_type bits =
            Philox{}({{purpose_ | (next_++ & 0xFFFFFFU), id_low_, id_high_year_, replicate_}}, key_);
        const std::uint64_t wide = (static_cast<std::uint64_t>(bits[0]) << 32) | bits[1];
        return static_cast<double>(wide >> 11) * 0x1.0p-53;
    }

private:
    using Philox = r123::Philox4x32;
    Philox::key_type key_;
    std::uint32_t purpose_;
    std::uint32_t id_low_;
    std::uint32_t id_high_year_;
    std::uint32_t replicate_;
    std::uint32_t next_ = 0;
};

}  // namespace config
