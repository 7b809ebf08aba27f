#include "rockfall/obstacles/stem_index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rockfall/obstacles/tree_energy.hpp"

namespace rockfall {
StemIndex::StemIndex(std::span<const Stem> stems, const Terrain& terrain, double largest_rock_radius_m,
                     bool with_taper)
    : with_taper_{with_taper} {
    stems_.reserve(stems.size());
    for (std::uint32_t i = 0; i < stems.size(); ++i) {
        const Stem& stem = stems[i];
        const double x_m = stem.x_m - terrain.origin_m().x();
        const double y_m = stem.y_m - terrain.origin_m().y();
        const std::optional<double> ground_m = terrain.height_m(x_m, y_m);
        if (!ground_m) {
            outside_.push_back(i);
        }
        // A stem without ground keeps its number but has no size, so that nothing can meet it.
        const double top_m =
            stem.broken_at_m > 0.0 ? std::min(stem.broken_at_m, stem.height_m) : stem.height_m;
        stems_.push_back(
            {x_m, y_m, ground_m.value_or(0.0), ground_m ? stem.height_m : 0.0, ground_m ? top_m : 0.0,
             ground_m ? 0.005 * stem.dbh_cm : 0.0,
             ground_m ? stem.strength * largest_energy_j(stem.dbh_cm, stem.fracture_energy) : 0.0});
    }
    const double widest_m = with_taper ? taper_at_ground : 1.0;
    std::vector<PlanBox> boxes;
    boxes.reserve(stems_.size());
    for (const PlacedStem& stem : stems_) {
        constexpr PlanBox nowhere{1.0, 1.0, 0.0, 0.0};
        boxes.push_back(stem.height_m > 0.0 ? PlanBox{stem.x_m, stem.y_m, stem.x_m, stem.y_m}.widened(
                                                  largest_rock_radius_m + widest_m * stem.breast_radius_m)
                                            : nowhere);
    }
    bins_ = PlanBins{boxes};
}

/// A straight path in plan with the heights along it.
struct StemIndex::Path {
    PlanLine plan;
    double plan_speed_mps;
    double until_s;
    double rock_radius_m;
    double z_m;  // height of the underside at the start
    double rising_mps;
    double falling_mps2;
    std::span<const std::uint32_t> ignored;
    std::span<const std::uint8_t> gone;

    [[nodiscard]] bool passes_over(std::uint32_t stem) const {
        return std::find(ignored.begin(), ignored.end(), stem) != ignored.end() ||
               (!gone.empty() && gone[stem] != 0);
    }
    [[nodiscard]] double underside_m(double time_s) const {
        return z_m + time_s * (rising_mps - 0.5 * falling_mps2 * time_s);
    }
};

void StemIndex::look_into(std::span<const std::uint32_t> numbers, const Path& path, StemHit& first) const {
    const double widest = with_taper_ ? taper_at_ground : 1.0;
    for (const std::uint32_t i : numbers) {
        const PlacedStem& stem = stems_[i];
        const double rx = stem.x_m - path.plan.x_m;
        const double ry = stem.y_m - path.plan.y_m;
        const double offset_m = path.plan.direction_x * ry - path.plan.direction_y * rx;
        const double widest_reach_m = path.rock_radius_m + widest * stem.breast_radius_m;
        const double squared_offset = offset_m * offset_m;
        if (squared_offset >= widest_reach_m * widest_reach_m) {
            continue;
        }
        const double abeam_m = path.plan.direction_x * rx + path.plan.direction_y * ry;
        if (abeam_m <= 0.0 || path.passes_over(i)) {
            continue;  // the axis lies behind: the rock moves away
        }
        // The radius depends on the height of the hit and the height on where the circle begins: begin with
        // the widest circle and shrink once to the radius at that height.
        double reach_m = widest_reach_m;
        double time_s =
            std::max(0.0, abeam_m - std::sqrt(reach_m * reach_m - squared_offset)) / path.plan_speed_mps;
        double height_m = path.underside_m(time_s) + path.rock_radius_m - stem.ground_m;
        if (with_taper_) {
            reach_m = path.rock_radius_m +
                      stem.breast_radius_m * taper(std::min(height_m, stem.top_m), stem.height_m);
            if (squared_offset >= reach_m * reach_m) {
                continue;
            }
            time_s =
                std::max(0.0, abeam_m - std::sqrt(reach_m * reach_m - squared_offset)) / path.plan_speed_mps;
            height_m = path.underside_m(time_s) + path.rock_radius_m - stem.ground_m;
        }
        const bool below_top = height_m - path.rock_radius_m < stem.top_m;
        if (below_top && time_s <= path.until_s &&
            (time_s < first.time_s || (time_s == first.time_s && i < first.stem))) {
            first = {i, time_s, offset_m, reach_m, std::max(height_m, 0.0)};
        }
    }
}

std::optional<StemHit> StemIndex::search(const Path& path) const {
    StemHit first{no_stem, std::numeric_limits<double>::infinity(), 0.0, 0.0, 0.0};
    bins_.walk(path.plan, [&](std::span<const std::uint32_t> numbers) {
        look_into(numbers, path, first);
        return first.time_s * path.plan_speed_mps;
    });
    if (first.stem == no_stem) {
        return std::nullopt;
    }
    return first;
}

std::optional<StemHit> StemIndex::first_hit(const Flight& flight, double until_s, double rock_radius_m,
                                            std::span<const std::uint32_t> ignored,
                                            std::span<const std::uint8_t> gone) const {
    const double plan_speed_mps = flight.velocity_mps.head<2>().norm();
    constexpr double vertical_mps = 1e-6;  // such a rock has no path in plan that could meet a stem
    if (stems_.empty() || plan_speed_mps < vertical_mps) {
        return std::nullopt;
    }
    return search({{flight.start_m.x(), flight.start_m.y(), flight.velocity_mps.x() / plan_speed_mps,
                    flight.velocity_mps.y() / plan_speed_mps, plan_speed_mps * until_s},
                   plan_speed_mps,
                   until_s,
                   rock_radius_m,
                   flight.start_m.z(),
                   flight.velocity_mps.z(),
                   config::gravity_mps2,
                   ignored,
                   gone});
}

ClearPlace StemIndex::clear_place(const Eigen::Vector2d& centre_m, double rock_radius_m) const {
    const auto bin = bins_.bin_at(centre_m.x(), centre_m.y());
    if (!bin) {
        return {};
    }
    const double widest = with_taper_ ? taper_at_ground : 1.0;
    constexpr double spare_m = 1e-3;
    double radius_m = std::numeric_limits<double>::infinity();
    for (const std::uint32_t number : bin->numbers) {
        const PlacedStem& stem = stems_[number];
        const double dx = stem.x_m - centre_m.x();
        const double dy = stem.y_m - centre_m.y();
        const double reach_m = rock_radius_m + spare_m + widest * stem.breast_radius_m;
        radius_m = std::min(radius_m, std::sqrt(dx * dx + dy * dy) - reach_m);
    }
    return {bin->inside, centre_m, radius_m > 0.0 ? radius_m * radius_m : -1.0};
}

std::optional<StemHit> StemIndex::first_hit_rolling(const Eigen::Vector3d& start_m,
                                                    const Eigen::Vector3d& velocity_mps, double until_s,
                                                    double rock_radius_m,
                                                    std::span<const std::uint32_t> ignored,
                                                    std::span<const std::uint8_t> gone) const {
    const double plan_speed_mps = velocity_mps.head<2>().norm();
    constexpr double standing_mps = 1e-9;
    if (stems_.empty() || plan_speed_mps < standing_mps) {
        return std::nullopt;
    }
    return search({{start_m.x(), start_m.y(), velocity_mps.x() / plan_speed_mps,
                    velocity_mps.y() / plan_speed_mps, plan_speed_mps * until_s},
                   plan_speed_mps,
                   until_s,
                   rock_radius_m,
                   start_m.z(),
                   velocity_mps.z(),
                   0.0,
                   ignored,
                   gone});
}

}  // namespace rockfall
