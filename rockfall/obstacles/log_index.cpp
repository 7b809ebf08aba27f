#include "rockfall/obstacles/log_index.hpp"

#include <algorithm>
#include <cmath>

#include "config/units/constants.hpp"
#include "rockfall/obstacles/tree_energy.hpp"

namespace rockfall {
namespace {

constexpr double longest_piece_m = 2.0;
/// So near a rock touches a log. Steps towards a log end here, so they need not become ever smaller.
constexpr double touching_m = 1e-3;
/// Motion closer to the tangent than this [rad] is none towards a log.
constexpr double grazing = 1e-6;
/// A rock that touches a log without moving towards it is looked at again after this way.
constexpr double look_again_m = 1e-2;

/// A piece between two shares of the length of a log; nothing without ground below all of it.
std::optional<LogPiece> piece_of(const Log& log, std::uint32_t number, const Terrain& terrain,
                                 double first_share, double last_share, double loose_share) {
    const Eigen::Vector2d one = Eigen::Vector2d{log.x1_m, log.y1_m} - terrain.origin_m();
    const Eigen::Vector2d other = Eigen::Vector2d{log.x2_m, log.y2_m} - terrain.origin_m();
    const Eigen::Vector2d first = one + first_share * (other - one);
    const Eigen::Vector2d last = one + last_share * (other - one);
    const Eigen::Vector2d middle = 0.5 * (first + last);
    const auto first_ground_m = terrain.height_m(first.x(), first.y());
    const auto last_ground_m = terrain.height_m(last.x(), last.y());
    const auto triangle = terrain.locate(middle.x(), middle.y());
    if (!first_ground_m || !last_ground_m || !triangle) {
        return std::nullopt;
    }
    const double diameter_cm =
        log.diameter1_cm + 0.5 * (first_share + last_share) * (log.diameter2_cm - log.diameter1_cm);
    const double radius_m = 0.005 * diameter_cm;
    const Eigen::Vector3d normal = terrain.plane_of(*triangle).normal();
    const Eigen::Vector3d up = (log.clearance_m + radius_m) * normal;
    const Eigen::Vector3d begin = Eigen::Vector3d{first.x(), first.y(), *first_ground_m} + up;
    const Eigen::Vector3d end = Eigen::Vector3d{last.x(), last.y(), *last_ground_m} + up;
    const double energy_j = log.strength * (log.supported ? 1.0 : loose_share) *
                            largest_energy_j(diameter_cm, log.fracture_energy);
    return LogPiece{begin, end - begin, normal, radius_m, energy_j, number};
}

PlanBox box_around(const LogPiece& piece, double rock_radius_m) {
    const Eigen::Vector3d last = piece.first_m + piece.along;
    // The centre of the rock lies beside the point that moves by as much as the ground is tilted.
    const double beside_m = rock_radius_m * piece.normal.head<2>().norm();
    return PlanBox{std::min(piece.first_m.x(), last.x()), std::min(piece.first_m.y(), last.y()),
                   std::max(piece.first_m.x(), last.x()), std::max(piece.first_m.y(), last.y())}
        .widened(piece.radius_m + rock_radius_m + beside_m + touching_m);
}

bool is_among(std::uint32_t log, std::span<const std::uint32_t> logs) {
    return std::find(logs.begin(), logs.end(), log) != logs.end();
}

struct Window {
    double begin_s;
    double end_s;
};

}  // namespace

/// A path straight in plan, a parabola or a line in height.
struct LogIndex::Path {
    Eigen::Vector3d start_m;
    Eigen::Vector3d velocity_mps;
    double falling_mps2;
    PlanLine plan;
    double plan_speed_mps;
    double until_s;
    double rock_radius_m;
    std::span<const std::uint32_t> ignored;
    std::span<const std::uint8_t> gone;

    [[nodiscard]] Eigen::Vector3d position_m(double time_s) const {
        Eigen::Vector3d place_m = start_m + time_s * velocity_mps;
        place_m.z() -= 0.5 * falling_mps2 * time_s * time_s;
        return place_m;
    }
    [[nodiscard]] Eigen::Vector3d velocity_at(double time_s) const {
        return {velocity_mps.x(), velocity_mps.y(), velocity_mps.z() - falling_mps2 * time_s};
    }

    /// When, seen in plan, the rock may be near enough to a piece; empty if never before `latest_s`.
    [[nodiscard]] std::optional<Window> near(const LogPiece& piece, const Eigen::Vector3d& to_centre_m,
                                             double reach_m, double latest_s) const;
    /// When in the window it first touches the piece while it moves towards it.
    [[nodiscard]] std::optional<LogHit> touch(const LogPiece& piece, const Eigen::Vector3d& to_centre_m,
                                              double reach_m, const Window& window) const;
    [[nodiscard]] std::optional<LogHit> meets(const LogPiece& piece, double latest_s) const;
};

std::optional<Window> LogIndex::Path::near(const LogPiece& piece, const Eigen::Vector3d& to_centre_m,
                                           double reach_m, double latest_s) const {
    const double rx = piece.first_m.x() - start_m.x() - to_centre_m.x();
    const double ry = piece.first_m.y() - start_m.y() - to_centre_m.y();
    // Both ends of the axis seen along the path: how far ahead, how far to the left.
    const double ahead0 = plan.direction_x * rx + plan.direction_y * ry;
    const double aside0 = plan.direction_x * ry - plan.direction_y * rx;
    const double ahead_more = plan.direction_x * piece.along.x() + plan.direction_y * piece.along.y();
    const double aside_more = plan.direction_x * piece.along.y() - plan.direction_y * piece.along.x();
    const double aside1 = aside0 + aside_more;
    if (std::min(aside0, aside1) > reach_m || std::max(aside0, aside1) < -reach_m) {
        return std::nullopt;
    }
    // The part of the axis that lies beside the path no further than the reach.
    double from = 0.0;
    double to = 1.0;
    if (aside_more != 0.0) {
        const double left = (reach_m - aside0) / aside_more;
        const double right = (-reach_m - aside0) / aside_more;
        from = std::max(0.0, std::min(left, right));
        to = std::min(1.0, std::max(left, right));
    }
    const double ahead_from = ahead0 + from * ahead_more;
    const double ahead_to = ahead0 + to * ahead_more;
    const Window window{std::max(0.0, (std::min(ahead_from, ahead_to) - reach_m) / plan_speed_mps),
                        std::min(latest_s, (std::max(ahead_from, ahead_to) + reach_m) / plan_speed_mps)};
    return window.begin_s <= window.end_s ? std::optional{window} : std::nullopt;
}

std::optional<LogHit> LogIndex::Path::touch(const LogPiece& piece, const Eigen::Vector3d& to_centre_m,
                                            double reach_m, const Window& window) const {
    // Within the window the rock is nowhere faster than at one of its ends: it cannot touch the piece before
    // it has covered the gap at that speed.
    const double fastest_mps = std::sqrt(
        std::max(velocity_at(window.begin_s).squaredNorm(), velocity_at(window.end_s).squaredNorm()));
    double time_s = window.begin_s;
    while (time_s <= window.end_s) {
        const Eigen::Vector3d centre_m = position_m(time_s) + to_centre_m;
        const Eigen::Vector3d off_m = centre_m - piece.nearest_to(centre_m);
        const double distance_m = off_m.norm();
        const double gap_m = distance_m - reach_m;
        if (gap_m > touching_m) {
            time_s += gap_m / fastest_mps;
        } else if (distance_m > 0.0 && velocity_at(time_s).dot(off_m) < -grazing * fastest_mps * distance_m) {
            return LogHit{piece.log, 0, time_s, off_m / distance_m};
        } else {
            time_s += look_again_m / fastest_mps;
        }
    }
    return std::nullopt;
}

std::optional<LogHit> LogIndex::Path::meets(const LogPiece& piece, double latest_s) const {
    const Eigen::Vector3d to_centre_m = rock_radius_m * piece.normal;
    const double reach_m = rock_radius_m + piece.radius_m;
    const std::optional<Window> window = near(piece, to_centre_m, reach_m + touching_m, latest_s);
    if (!window) {
        return std::nullopt;
    }
    // The height of the rock is concave in time: it is lowest at one end of the window.
    const double lowest_m = std::min(position_m(window->begin_s).z(), position_m(window->end_s).z());
    const double highest_of_log_m = piece.first_m.z() + std::max(0.0, piece.along.z());
    if (lowest_m + to_centre_m.z() > highest_of_log_m + reach_m + touching_m) {
        return std::nullopt;
    }
    return touch(piece, to_centre_m, reach_m, *window);
}

LogIndex::LogIndex(std::span<const Log> logs, const Terrain& terrain, double largest_rock_radius_m,
                   double loose_share)
    : count_{logs.size()} {
    for (std::uint32_t number = 0; number < logs.size(); ++number) {
        const Log& log = logs[number];
        first_piece_.push_back(static_cast<std::uint32_t>(pieces_.size()));
        const double length_m = std::sqrt((log.x2_m - log.x1_m) * (log.x2_m - log.x1_m) +
                                          (log.y2_m - log.y1_m) * (log.y2_m - log.y1_m));
        const int pieces = log.strength > 0.0 ? static_cast<int>(std::ceil(length_m / longest_piece_m)) : 0;
        for (int k = 0; k < pieces; ++k) {
            const auto piece = piece_of(log, number, terrain, static_cast<double>(k) / pieces,
                                        static_cast<double>(k + 1) / pieces, loose_share);
            if (piece) {
                pieces_.push_back(*piece);
            }
        }
    }
    first_piece_.push_back(static_cast<std::uint32_t>(pieces_.size()));
    std::vector<PlanBox> boxes;
    boxes.reserve(pieces_.size());
    for (const LogPiece& piece : pieces_) {
        boxes.push_back(box_around(piece, largest_rock_radius_m));
    }
    bins_ = PlanBins{boxes};
}

std::optional<LogHit> LogIndex::search(const Path& path) const {
    std::optional<LogHit> first;
    bins_.walk(path.plan, [&](std::span<const std::uint32_t> numbers) {
        for (const std::uint32_t number : numbers) {
            const LogPiece& piece = pieces_[number];
            if (is_among(piece.log, path.ignored) || (!path.gone.empty() && path.gone[piece.log] != 0)) {
                continue;
            }
            auto hit = path.meets(piece, first ? first->time_s : path.until_s);
            if (hit && (!first || hit->time_s < first->time_s ||
                        (hit->time_s == first->time_s && number < first->piece))) {
                hit->piece = number;
                first = hit;
            }
        }
        return first ? first->time_s * path.plan_speed_mps : std::numeric_limits<double>::infinity();
    });
    return first;
}

std::optional<LogHit> LogIndex::first_hit(const Flight& flight, double until_s, double rock_radius_m,
                                          std::span<const std::uint32_t> ignored,
                                          std::span<const std::uint8_t> gone) const {
    const Eigen::Vector2d plan_mps = flight.velocity_mps.head<2>();
    const double plan_speed_mps = plan_mps.norm();
    constexpr double vertical_mps = 1e-6;  // such a rock has no path in plan that could meet a log
    if (pieces_.empty() || plan_speed_mps < vertical_mps) {
        return std::nullopt;
    }
    return search({flight.start_m,
                   flight.velocity_mps,
                   config::gravity_mps2,
                   {flight.start_m.x(), flight.start_m.y(), plan_mps.x() / plan_speed_mps,
                    plan_mps.y() / plan_speed_mps, plan_speed_mps * until_s},
                   plan_speed_mps,
                   until_s,
                   rock_radius_m,
                   ignored,
                   gone});
}

std::optional<LogHit> LogIndex::first_hit_rolling(const Eigen::Vector3d& start_m,
                                                  const Eigen::Vector3d& velocity_mps, double until_s,
                                                  double rock_radius_m,
                                                  std::span<const std::uint32_t> ignored,
                                                  std::span<const std::uint8_t> gone) const {
    const Eigen::Vector2d plan_mps = velocity_mps.head<2>();
    const double plan_speed_mps = plan_mps.norm();
    constexpr double standing_mps = 1e-9;
    if (pieces_.empty() || plan_speed_mps < standing_mps) {
        return std::nullopt;
    }
    return search({start_m,
                   velocity_mps,
                   0.0,
                   {start_m.x(), start_m.y(), plan_mps.x() / plan_speed_mps, plan_mps.y() / plan_speed_mps,
                    plan_speed_mps * until_s},
                   plan_speed_mps,
                   until_s,
                   rock_radius_m,
                   ignored,
                   gone});
}

bool LogIndex::is_left(std::uint32_t log, const Eigen::Vector3d& position_m, double rock_radius_m) const {
    for (std::uint32_t number = first_piece_[log]; number < first_piece_[log + 1]; ++number) {
        const LogPiece& piece = pieces_[number];
        const Eigen::Vector3d centre_m = position_m + rock_radius_m * piece.normal;
        const double clear_m = rock_radius_m + piece.radius_m + 0.01;
        if ((centre_m - piece.nearest_to(centre_m)).squaredNorm() <= clear_m * clear_m) {
            return false;
        }
    }
    return true;
}

}  // namespace rockfall
