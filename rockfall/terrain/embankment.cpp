#include "rockfall/terrain/embankment.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rockfall {
namespace {

using PlanPoint = Eigen::Vector2d;

double turn_in_plan(const PlanPoint& a, const PlanPoint& b) {
    return a.x() * b.y() - a.y() * b.x();
}

PlanPoint left_of(const PlanPoint& along) {
    return {-along.y(), along.x()};
}

/// A place on the axis, and where its section leads: to the left by `across` for each metre of distance from
/// the axis, which is longer than a metre at bends.
struct Station {
    PlanPoint place_m;
    PlanPoint across;
};

std::vector<Station> stations_of(const std::vector<PlanPoint>& axis_m) {
    std::vector<Station> stations;
    PlanPoint left_before = PlanPoint::Zero();
    for (std::size_t i = 0; i + 1 < axis_m.size(); ++i) {
        const PlanPoint way_m = axis_m[i + 1] - axis_m[i];
        const PlanPoint left = left_of(way_m.normalized());
        if (i > 0) {
            // Both faces keep their distance from the axis: the mitre of the two normals.
            const double fold = std::max(1e-6, 1.0 + left_before.dot(left));
            stations.back().across = (left_before + left) / fold;
        } else {
            stations.push_back({axis_m[i], left});
        }
        const double steps = std::ceil(way_m.norm() / section_step_m);
        for (double k = 1.0; k <= steps; ++k) {
            stations.push_back({axis_m[i] + k / steps * way_m, left});
        }
        left_before = left;
    }
    return stations;
}

/// Heights of the ground, found by walking from the last place.
class GroundBelowLine {
public:
    explicit GroundBelowLine(const Terrain& terrain) : terrain_{terrain} {}
    std::optional<double> height_m(const PlanPoint& place_m) {
        const auto found = hint_ == no_triangle ? terrain_.locate(place_m.x(), place_m.y())
                                                : terrain_.locate(place_m.x(), place_m.y(), hint_);
        if (!found) {
            return std::nullopt;
        }
        hint_ = *found;
        return terrain_.plane_of(*found).height_m(place_m.x(), place_m.y());
    }

private:
    const Terrain& terrain_;
    std::uint32_t hint_ = no_triangle;
};

/// How much higher the ground lies on the left side, in the mean; nothing without ground beside any station.
std::optional<double> rise_to_the_left_m(const std::vector<Station>& stations, double distance_m,
                                         GroundBelowLine& ground) {
    double sum_m = 0.0;
    std::size_t seen = 0;
    for (const Station& station : stations) {
        const auto left = ground.height_m(station.place_m + distance_m * station.across);
        const auto right = ground.height_m(station.place_m - distance_m * station.across);
        if (left && right) {
            sum_m += *left - *right;
            ++seen;
        }
    }
    return seen > 0 ? std::optional{sum_m / static_cast<double>(seen)} : std::nullopt;
}

/// One face at a station.
struct EarthFace {
    Station station;
    double side;    ///< 1: to the left, -1: to the right
    double edge_m;  ///< height of crown or floor
    double half_m;  ///< distance of its edge from the axis
    double sign;    ///< 1: a dam, -1: a ditch
    double tangent;

    [[nodiscard]] PlanPoint place_m(double distance_m) const {
        return station.place_m + side * distance_m * station.across;
    }
    [[nodiscard]] double height_m(double distance_m) const {
        return edge_m - sign * tangent * (distance_m - half_m);
    }
    /// Above the ground of a dam, below it of a ditch; nothing off the terrain.
    [[nodiscard]] std::optional<double> beyond_ground_m(double distance_m, GroundBelowLine& ground) const {
        const auto ground_m = ground.height_m(place_m(distance_m));
        return ground_m ? std::optional{sign * (height_m(distance_m) - *ground_m)} : std::nullopt;
    }
};

/// The distance at which a face meets the ground, or what is wrong with it.
std::pair<double, std::optional<EmbankmentProblem>> foot_of(const EarthFace& face, GroundBelowLine& ground) {
    constexpr double step_m = 0.25;
    const auto refused_at = [&](EmbankmentFault fault, double distance_m) {
        return std::pair{0.0,
                         std::optional{EmbankmentProblem{fault, face.place_m(distance_m), face.side > 0.0}}};
    };
    double inside_m = face.half_m;
    const auto at_edge = face.beyond_ground_m(inside_m, ground);
    if (!at_edge) {
        return refused_at(EmbankmentFault::off_terrain, inside_m);
    }
    if (*at_edge <= 0.0) {
        return refused_at(EmbankmentFault::edge_in_ground, inside_m);
    }
    for (double outside_m = inside_m + step_m; outside_m <= face.half_m + longest_face_m;
         outside_m += step_m) {
        const auto beyond = face.beyond_ground_m(outside_m, ground);
        if (!beyond) {
            // A face that draws away from the ground meets none on a larger terrain either.
            const bool comes_nearer = face.beyond_ground_m(inside_m, ground).value_or(0.0) < *at_edge;
            return comes_nearer ? refused_at(EmbankmentFault::off_terrain, outside_m)
                                : refused_at(EmbankmentFault::face_too_flat, face.half_m);
        }
        if (*beyond <= 0.0) {
            constexpr int halvings = 48;  // of 0.25 m: to the last bits
            for (int i = 0; i < halvings; ++i) {
                const double middle_m = 0.5 * (inside_m + outside_m);
                const auto there = face.beyond_ground_m(middle_m, ground);
                (there && *there > 0.0 ? inside_m : outside_m) = middle_m;
            }
            return {0.5 * (inside_m + outside_m), std::nullopt};
        }
        inside_m = outside_m;
    }
    return refused_at(EmbankmentFault::face_too_flat, face.half_m);
}

/// Area between a section and the straight line between its feet, across the axis.
double section_area(const CrossSection& section) {
    const PlanPoint across = (section[0] - section[3]).head<2>();
    const double width_m = across.norm();
    double twice = 0.0;
    std::array<PlanPoint, 4> flat;
    for (std::size_t i = 0; i < 4; ++i) {
        flat[i] = {(section[i] - section[3]).head<2>().dot(across) / width_m, section[i].z()};
    }
    for (std::size_t i = 0; i < 4; ++i) {
        twice += turn_in_plan(flat[i], flat[(i + 1) % 4]);
    }
    return 0.5 * std::abs(twice);
}

/// Twice the area of a quadrilateral, > 0 where its corners run counter-clockwise.
double twice_plan_area(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c, const PlanPoint& d) {
    return turn_in_plan(c - a, d - b);
}

/// Whether the strip between two sections is turned over anywhere: its faces cross there.
bool is_folded(const CrossSection& from, const CrossSection& to) {
    for (std::size_t i = 0; i + 1 < from.size(); ++i) {
        const PlanPoint a = from[i + 1].head<2>();
        const PlanPoint b = to[i + 1].head<2>();
        const PlanPoint c = to[i].head<2>();
        const PlanPoint d = from[i].head<2>();
        // Each of its corners turns left.
        if (turn_in_plan(b - a, c - b) <= 0.0 || turn_in_plan(c - b, d - c) <= 0.0 ||
            turn_in_plan(d - c, a - d) <= 0.0 || turn_in_plan(a - d, b - a) <= 0.0) {
            return true;
        }
    }
    return false;
}

void take_outline(PlacedEmbankment& placed) {
    std::vector<PlanPoint>& outline = placed.outline_m;
    double length_m = 0.0;
    const auto go_to = [&](const Eigen::Vector3d& corner) {
        if (!outline.empty()) {
            length_m += (corner.head<2>() - outline.back()).norm();
        }
        outline.emplace_back(corner.head<2>());
    };
    for (const CrossSection& section : placed.sections) {
        go_to(section.front());
    }
    placed.side_ends_m[0] = length_m;
    go_to(placed.sections.back().back());
    placed.side_ends_m[1] = length_m;
    for (std::size_t i = placed.sections.size() - 1; i-- > 0;) {
        go_to(placed.sections[i].back());
    }
    placed.side_ends_m[2] = length_m;
    go_to(placed.sections.front().front());
    placed.side_ends_m[3] = length_m;
}

void take_size(PlacedEmbankment& placed) {
    for (std::size_t i = 0; i + 1 < placed.sections.size(); ++i) {
        const CrossSection& from = placed.sections[i];
        const CrossSection& to = placed.sections[i + 1];
        const PlanPoint across = (from[0] - from[3]).head<2>().normalized();
        const PlanPoint way_m =
            (0.25 * (to[0] + to[1] + to[2] + to[3] - from[0] - from[1] - from[2] - from[3])).head<2>();
        placed.volume_m3 +=
            0.5 * (section_area(from) + section_area(to)) * std::abs(turn_in_plan(across, way_m));
        placed.area_m2 += 0.5 * std::abs(twice_plan_area(from[3].head<2>(), to[3].head<2>(), to[0].head<2>(),
                                                         from[0].head<2>()));
    }
}

/// The first place along the outline, or a margin beside it, that has no ground.
std::optional<PlanPoint> first_place_without_ground(const std::vector<CrossSection>& sections,
                                                    GroundBelowLine& ground) {
    for (const CrossSection& section : sections) {
        const PlanPoint across = (section[0] - section[3]).head<2>().normalized();
        for (const PlanPoint& place_m :
             {PlanPoint{section[0].head<2>() + 2.0 * embankment_margin_m * across},
              PlanPoint{section[3].head<2>() - 2.0 * embankment_margin_m * across}}) {
            if (!ground.height_m(place_m)) {
                return place_m;
            }
        }
    }
    for (const bool at_start : {true, false}) {
        const CrossSection& end = at_start ? sections.front() : sections.back();
        const PlanPoint across = (end[0] - end[3]).head<2>();
        const PlanPoint outward = (at_start ? 1.0 : -1.0) * left_of(across.normalized());
        const double steps = std::ceil(across.norm() / embankment_margin_m);
        for (double k = 0.0; k <= steps; ++k) {
            const PlanPoint place_m =
                end[3].head<2>() + k / steps * across + 2.0 * embankment_margin_m * outward;
            if (!ground.height_m(place_m)) {
                return place_m;
            }
        }
    }
    return std::nullopt;
}

/// The ground before an end, as a section; nothing off the terrain.
std::optional<CrossSection> ground_before(const CrossSection& end, bool at_start, GroundBelowLine& ground) {
    const PlanPoint outward = (at_start ? 1.0 : -1.0) * left_of((end[0] - end[3]).head<2>().normalized());
    CrossSection foot;
    for (std::size_t i = 0; i < foot.size(); ++i) {
        const PlanPoint place_m = end[i].head<2>() + end_lean_m * outward;
        const auto ground_m = ground.height_m(place_m);
        if (!ground_m) {
            return std::nullopt;
        }
        foot[i] = {place_m.x(), place_m.y(), *ground_m};
    }
    return foot;
}

EmbankmentResult refused(EmbankmentFault fault, const PlanPoint& place_m) {
    return {std::nullopt, EmbankmentProblem{fault, place_m}};
}

}  // namespace

EmbankmentResult place(const Embankment& embankment, const Terrain& terrain) {
    GroundBelowLine ground{terrain};
    std::vector<Station> stations = stations_of(embankment.axis_m);
    const double rise_m = embankment.rise_m;
    const auto leftwards = rise_to_the_left_m(stations, 0.5 * embankment.width_m + std::abs(rise_m), ground);
    if (!leftwards) {
        return refused(EmbankmentFault::off_terrain, stations.front().place_m);
    }
    constexpr double level_m = 0.01;
    if (std::abs(*leftwards) < level_m && embankment.uphill_tangent != embankment.downhill_tangent) {
        return refused(EmbankmentFault::no_uphill, stations.front().place_m);
    }
    if (*leftwards < 0.0) {  // the other way along the axis, uphill lies left
        std::vector<PlanPoint> back{embankment.axis_m.rbegin(), embankment.axis_m.rend()};
        stations = stations_of(back);
    }
    const double sign = rise_m > 0.0 ? 1.0 : -1.0;
    const double half_m = 0.5 * embankment.width_m;
    PlacedEmbankment placed;
    for (const Station& station : stations) {
        const auto ground_m = ground.height_m(station.place_m);
        if (!ground_m) {
            return refused(EmbankmentFault::off_terrain, station.place_m);
        }
        constexpr double longest_mitre = 2.0;  // a bend of 120 degrees
        if (station.across.norm() > longest_mitre) {
            return refused(EmbankmentFault::bend, station.place_m);
        }
        const double edge_m = *ground_m + rise_m;
        CrossSection section;
        for (const bool uphill : {true, false}) {
            const EarthFace face{station, uphill ? 1.0 : -1.0,
                                 edge_m,  half_m,
                                 sign,    uphill ? embankment.uphill_tangent : embankment.downhill_tangent};
            const auto [foot_m, problem] = foot_of(face, ground);
            if (problem) {
                return {std::nullopt, problem};
            }
            const PlanPoint foot = face.place_m(foot_m);
            const PlanPoint edge = face.place_m(half_m);
            section[uphill ? 0 : 3] = {foot.x(), foot.y(), ground.height_m(foot).value_or(edge_m)};
            section[uphill ? 1 : 2] = {edge.x(), edge.y(), edge_m};
        }
        if (!placed.sections.empty() && is_folded(placed.sections.back(), section)) {
            return refused(EmbankmentFault::bend, station.place_m);
        }
        placed.sections.push_back(section);
    }
    for (const bool at_start : {true, false}) {
        const CrossSection& end = at_start ? placed.sections.front() : placed.sections.back();
        const auto foot = ground_before(end, at_start, ground);
        if (!foot) {
            return refused(EmbankmentFault::off_terrain, end[0].head<2>());
        }
        placed.sections.insert(at_start ? placed.sections.begin() : placed.sections.end(), *foot);
    }
    if (const auto off = first_place_without_ground(placed.sections, ground)) {
        return refused(EmbankmentFault::off_terrain, *off);
    }
    take_outline(placed);
    take_size(placed);
    return {std::move(placed), std::nullopt};
}

}  // namespace rockfall
