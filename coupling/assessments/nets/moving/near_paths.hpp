#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/assessments/nets/figures/net_paths.hpp"
#include "coupling/assessments/nets/moving/area_around.hpp"
#include "coupling/inputs/nets/net_record.hpp"

namespace coupling::moving {

/// Bits of the kind of a piece as it is kept.
enum PieceBit : std::uint8_t {
    piece_flies = 1,
    piece_slides = 2,
    piece_turns = 4,        ///< a block with a rotation of its own
    piece_follows = 8,      ///< begins in plan, to the last bit, where the piece before it ends
    piece_keeps_speed = 16  ///< on the ground, with the speed at which the piece before it ends
};

/// Pieces of stored paths near nets, with all their bits and nothing twice.
struct KeptPaths {
    std::vector<double> bodies;          ///< diameter, radius, mass, inertia of each
    std::vector<std::uint8_t> covers;    ///< by path: index of the cover
    std::vector<std::uint32_t> body_of;  ///< by path
    std::vector<std::uint32_t> counts;   ///< of pieces, by path
    std::vector<std::uint8_t> kinds;     ///< PieceBit, by piece
    /// By piece: start in plan (unless it follows); of a flight height at the start, velocity, duration and
    /// spin; on the ground end in plan, square of the speed at the start (unless it is kept) and at the end,
    /// energies of rotation where it turns. Heights on the ground change nothing at nets.
    std::vector<double> numbers;
};

/// The ground near nets.
struct KeptGround {
    std::vector<double> x_m, y_m, z_m;
    std::vector<std::uint32_t> corners;  ///< three of each triangle
};

/// What a page needs to count the rocks at nets that are moved near their place.
struct NearPaths {
    double width_m = 0.0;           ///< around each net in which every line can be looked at
    std::uint64_t every = 1;        ///< one rock in so many is kept; 1: all
    std::vector<AreaAround> areas;  ///< by net
    std::array<std::uint64_t, rockfall::covers> rocks{};  ///< that fell, of those kept
    KeptGround ground;
    KeptPaths paths;
    std::vector<NetFigures> figures;  ///< of the nets where they stand, slope by slope, as `net try` counts
};

/// In base64.
inline constexpr std::size_t most_bytes_of_page = 8'000'000;

/// The widest of 60, 40, 25, 15 and 10 m whose paths fit into so many bytes; where none does, of 25 m (less
/// where the ground alone is too large) one rock in so many, evenly chosen by number. Nothing where not even
/// the ground of 10 m fits.
std::optional<NearPaths> paths_near(NetPathsReader& paths, std::span<const NetRecord> nets,
                                    std::size_t most_bytes = most_bytes_of_page);

}  // namespace coupling::moving
