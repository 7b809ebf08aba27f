#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace rockfall {

class Terrain;

/// A part of the rim of a terrain: a side of its outline, or a hole. Hole k is first_hole + k.
enum class RimPart : std::uint32_t { north, east, south, west, first_hole };

inline constexpr std::uint32_t rim_sides = 4;

constexpr RimPart hole_part(std::uint32_t hole) {
    return static_cast<RimPart>(rim_sides + hole);
}
constexpr bool is_hole(RimPart part) {
    return static_cast<std::uint32_t>(part) >= rim_sides;
}
/// Requires a hole.
constexpr std::uint32_t hole_of(RimPart part) {
    return static_cast<std::uint32_t>(part) - rim_sides;
}

/// Ground that is missing inside the outline of a terrain.
struct Hole {
    Eigen::Vector2d centre_m;  ///< of the area of the hole, in coordinates of the terrain
    double area_m2;
};

/// The edges of a terrain beyond which there is no triangle, closed to loops.
///
/// A loop that runs counter-clockwise is an outline, one that runs clockwise a hole. Where a hole touches the
/// outline in a corner, it is a part of the outline. The side of an edge of the outline is that to which its
/// outward normal points: the direction in which ground is missing there. This holds for any shape of outline
/// and turns and mirrors with the terrain.
class Rim {
public:
    Rim() = default;
    explicit Rim(const Terrain& terrain);

    [[nodiscard]] std::span<const Hole> holes() const { return holes_; }

    /// The part over which a rock left: that of the rim edge nearest to its end, looked for from the last
    /// triangle below it. `from_m`: where it started; where the normal points between two sides, the
    /// direction from there to the end decides. Slow compared with a step of a walk: for the end of a fall.
    [[nodiscard]] RimPart part_at(const Terrain& terrain, std::uint32_t triangle,
                                  const Eigen::Vector2d& end_m, const Eigen::Vector2d& from_m) const;

private:
    struct Edge {
        std::uint64_t key;  ///< 3 * triangle + number of the edge; edges_ rises by it
        Eigen::Vector2d from_m;
        Eigen::Vector2d to_m;
        std::uint32_t hole;  ///< no_hole: of an outline
    };
    static constexpr std::uint32_t no_hole = 0xFFFFFFFFU;

    void close_loops(const Terrain& terrain);
    [[nodiscard]] std::size_t place_of(std::uint64_t key) const;
    [[nodiscard]] const Edge* nearest_around(const Terrain& terrain, std::uint32_t triangle,
                                             const Eigen::Vector2d& place_m) const;
    [[nodiscard]] const Edge* nearest_of_all(const Eigen::Vector2d& place_m) const;

    std::vector<Edge> edges_;
    std::vector<Hole> holes_;
};

}  // namespace rockfall
