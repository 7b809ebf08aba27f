#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// A dam or a ditch as somebody draws it: a trapezoid across its axis, along the ground below the axis.
///
/// Its crown (or floor) is level across the axis and lies `rise_m` above the ground at the axis; on each side
/// a plane face leads from its edge to the ground. Ends are upright.
struct Embankment {
    std::vector<Eigen::Vector2d> axis_m;  ///< in coordinates of the terrain, two or more, no two alike
    double rise_m = 0.0;                  ///< > 0: a dam; < 0: a ditch
    double width_m = 0.0;                 ///< of crown or floor in plan, > 0
    double uphill_tangent = 0.0;          ///< of the slope of the faces, > 0 [-]
    double downhill_tangent = 0.0;
};

/// Across the axis: edge of the ground uphill, edges of crown or floor, edge of the ground downhill.
using CrossSection = std::array<Eigen::Vector3d, 4>;

/// An embankment on its ground.
struct PlacedEmbankment {
    /// The first and the last one lie on the ground, `end_lean_m` beyond the ends of the axis.
    std::vector<CrossSection> sections;      ///< at most a metre apart along the axis, the uphill side left
    std::vector<Eigen::Vector2d> outline_m;  ///< closed: uphill edge, far end, downhill edge, near end
    std::array<double, 4> side_ends_m{};     ///< along the outline: where each of these ends
    double volume_m3 = 0.0;  ///< between the sections and the straight ground between its edges
    double area_m2 = 0.0;    ///< of the outline
};

/// Why an embankment cannot stand where it is drawn.
enum class EmbankmentFault : std::uint8_t {
    off_terrain,     ///< there is no ground below it, or the terrain ends beside it
    no_uphill,       ///< faces differ, and the ground is as high on both sides
    edge_in_ground,  ///< the uphill edge of a crown lies below the ground, or that of a floor above it
    face_too_flat,   ///< a face meets no ground: the slope is about as steep
    bend,            ///< the axis bends so much that faces cross
};

struct EmbankmentProblem {
    EmbankmentFault fault;
    Eigen::Vector2d place_m;  ///< in coordinates of the terrain
    bool uphill = false;      ///< the side of the fault
};

struct EmbankmentResult {
    std::optional<PlacedEmbankment> placed;
    std::optional<EmbankmentProblem> problem;  ///< of one that is not placed
};

/// An upright end leans by this much from its foot to its top: a terrain has one height at each place.
inline constexpr double end_lean_m = 0.05;
/// Distance of cross-sections along the axis at most.
inline constexpr double section_step_m = 1.0;
/// A face that meets no ground within this distance of its crown never does [choice].
inline constexpr double longest_face_m = 60.0;
/// So far beside its edges the ground is meshed again, and must exist.
inline constexpr double embankment_margin_m = 0.3;

/// Finds the ground on both sides. The uphill side is that with the higher ground, a crown width and its
/// rise away from the axis, in the mean of all sections.
EmbankmentResult place(const Embankment& embankment, const Terrain& terrain);

/// The terrain with an embankment: the ground inside the outline is replaced by crown and faces, whose edges
/// become edges of the mesh; triangles within `embankment_margin_m` of it are meshed again, all others stay
/// as they are to the last bit.
///
/// `surface` of the new faces as in Triangle; 0: as the ground below. Limit: between its edges and the next
/// vertices of the terrain the ground is interpolated again, so that there, within a triangle of the outline,
/// it may differ by what the ground is curved over a triangle.
Terrain with_embankment(const Terrain& terrain, const PlacedEmbankment& placed, std::uint32_t surface);

}  // namespace rockfall
