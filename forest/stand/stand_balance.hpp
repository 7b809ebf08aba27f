#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "forest/stand/tree.hpp"

namespace forest {

/// Why stems or saplings leave the stand.
enum class Cause : std::uint8_t {
    background,     ///< age and what no process here explains
    stress,         ///< years without growth
    self_thinning,  ///< more trees than the site can carry
    wind,
    snow,
    beetle,
    rock,   ///< broken or uprooted by a rock
    wound,  ///< late consequence of a wound
    felled,
    browsing,
    drought,  ///< soil drier than the species tolerates
};
inline constexpr std::size_t cause_count = 11;

constexpr std::size_t index_of(Cause cause) {
    return static_cast<std::size_t>(cause);
}

/// As it stands in tables, such as "self_thinning".
std::string_view name_of(Cause cause);

/// Gains and losses of a stand, in stems and dry above-ground mass. Trees and saplings are counted apart: a
/// sapling that becomes a tree leaves the saplings and enters the trees.
///
/// Mass is taken when it is known: what a year's production gave (`grown_kg`), other changes
/// (`shed_kg`: foliage lost or gained as the crown changes, and production that a full-grown tree cannot
/// place), what died (`lost_kg`).
struct StandBalance {
    std::array<std::uint64_t, origin_count> stems_in{};  ///< ingrowth and planted trees, by origin
    std::array<std::uint64_t, cause_count> stems_out{};
    double mass_in_kg = 0.0;
    double grown_kg = 0.0;
    double shed_kg = 0.0;
    std::array<double, cause_count> lost_kg{};

    // Dry wood of stems. A stem that dies leaves the living; what of it is followed enters the dead wood: not
    // that of trees below 7 cm, nor what people haul off at once.
    double stem_in_kg = 0.0;
    double stem_grown_kg = 0.0;
    std::array<double, cause_count> stem_lost_kg{};
    double dead_wood_in_kg = 0.0;
    double dead_wood_decayed_kg = 0.0;
    double dead_wood_to_soil_kg = 0.0;  ///< pieces too rotten to be followed, or that rolled off
    double dead_wood_taken_kg = 0.0;    ///< salvaged

    std::uint64_t saplings_in = 0;         ///< germinated, sprouted, planted
    std::uint64_t saplings_recruited = 0;  ///< became trees
    std::array<std::uint64_t, cause_count> saplings_out{};

    [[nodiscard]] std::uint64_t all_stems_in() const;
    [[nodiscard]] std::uint64_t all_stems_out() const;
    [[nodiscard]] double all_lost_kg() const;
    [[nodiscard]] double all_stem_lost_kg() const;
    /// All that left the dead wood.
    [[nodiscard]] double all_dead_wood_out_kg() const;
    [[nodiscard]] std::uint64_t all_saplings_out() const;

    StandBalance& operator+=(const StandBalance& other);
};

}  // namespace forest
