#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rockfall/release/release.hpp"

namespace rockfall {

/// Energies [J] from which on rocks are counted exactly, at targets and in cells: limits of the energy
/// classes of guidelines (30, 300 kJ) and of the usual classes of nets (100, 1000 kJ). A float holds each of
/// them exactly.
inline constexpr std::array<float, 4> counted_energies_j{30e3F, 100e3F, 300e3F, 1000e3F};

/// How many rocks pass a cell each time that every start of the sources releases one rock: sources with the
/// same start share it, and a rock of theirs counts as 1 divided by all of them. So starts with many and with
/// few simulated rocks count the same. Kept as whole numbers of `one_release`: they add up the same in any
/// order.
struct CellReleases {
    /// Rocks are counted from each of these largest energies in the cell on [J]: all, and
    /// `counted_energies_j`.
    static constexpr std::array<float, 1 + counted_energies_j.size()> from_j = [] {
        std::array<float, 1 + counted_energies_j.size()> energies_j{};
        std::copy(counted_energies_j.begin(), counted_energies_j.end(), energies_j.begin() + 1);
        return energies_j;
    }();
    /// The weight of one rock of a start that has no other. Room for 65 536 starts.
    static constexpr std::uint64_t one_release = std::uint64_t{1} << 48U;

    std::array<std::uint64_t, from_j.size()> weights{};  ///< by `from_j`

    void add(std::uint64_t weight, float energy_j);
    void add(const CellReleases& other);
    /// Rocks from an energy of `from_j` on.
    [[nodiscard]] double per_release(std::size_t from) const {
        return static_cast<double>(weights[from]) / static_cast<double>(one_release);
    }
};

/// The weight of each rock of a source, by source; 0 for sources without rocks.
std::vector<std::uint64_t> release_weights(std::span<const ReleaseSource> sources);

}  // namespace rockfall
