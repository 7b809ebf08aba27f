#include "rockfall/obstacles/stem_index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rockfall {
namespace {

constexpr double bin_size_m = 5.0;

/// Cells that a circle's bounding box touches.
struct CellRange {
    config::Cell first;
    config::Cell last;
};

CellRange cells_touched(const config::GridFrame& frame, double x_m, double y_m, double reach_m) {
    const config::Cell north_west = frame.cell_at(x_m - reach_m, y_m + reach_m);
    const config::Cell south_east = frame.cell_at(x_m + reach_m, y_m - reach_m);
    return {{std::max(0, north_west.column), std::max(0, north_west.row)},
            {std::min(frame.columns - 1, south_east.column), std::min(frame.rows - 1, south_east.row)}};
}

config::GridFrame bins_over(std::span<const PlacedStem> stems, double reach_m) {
    double west = std::numeric_limits<double>::max();
    double south = west;
    double east = -west;
    double north = -west;
    for (const PlacedStem& stem : stems) {
        west = std::min(west, stem.x_m - reach_m);
        east = std::max(east, stem.x_m + reach_m);
        south = std::min(south, stem.y_m - reach_m);
        north = std::max(north, stem.y_m + reach_m);
    }
    return {static_cast<int>((east - west) / bin_size_m) + 1,
            static_cast<int>((north - south) / bin_size_m) + 1,
            west,
            south,
            bin_size_m,
            bin_size_m};
}

}  // namespace

StemIndex::StemIndex(std::span<const Stem> stems, const Terrain& terrain, double largest_rock_radius_m,
                     bool with_taper)
    : with_taper_{with_taper} {
    stems_.reserve(stems.size());
    double thickest_m = 0.0;
    for (std::uint32_t i = 0; i < stems.size(); ++i) {
        const Stem& stem = stems[i];
        const double x_m = stem.x_m - terrain.origin_m().x();
        const double y_m = stem.y_m - terrain.origin_m().y();
        const std::optional<double> ground_m = terrain.height_m(x_m, y_m);
        if (!ground_m) {
            outside_.push_back(i);
        }
        // A stem without ground keeps its number but has no size, so that nothing can meet it.
        stems_.push_back({x_m, y_m, ground_m.value_or(0.0), ground_m ? stem.height_m : 0.0,
                          ground_m ? 0.005 * stem.dbh_cm : 0.0,
                          ground_m ? largest_energy_j(stem.dbh_cm, stem.fracture_energy) : 0.0});
        thickest_m = std::max(thickest_m, stems_.back().breast_radius_m);
    }
    if (stems_.empty()) {
        return;
    }
    const double widest_m = with_taper ? taper_at_ground : 1.0;
    bins_ = bins_over(stems_, largest_rock_radius_m + widest_m * thickest_m);
    bin_start_.assign(bins_.size() + 1, 0);
    const auto each_touched_bin = [&](const PlacedStem& stem, auto&& visit) {
        const CellRange range =
            cells_touched(bins_, stem.x_m, stem.y_m, largest_rock_radius_m + widest_m * stem.breast_radius_m);
        for (int row = range.first.row; row <= range.last.row; ++row) {
            for (int column = range.first.column; column <= range.last.column; ++column) {
                visit(bins_.index({column, row}));
            }
        }
    };
    for (const PlacedStem& stem : stems_) {
        if (stem.height_m > 0.0) {
            each_touched_bin(stem, [&](std::size_t bin) { ++bin_start_[bin + 1]; });
        }
    }
    for (std::size_t bin = 0; bin < bins_.size(); ++bin) {
        bin_start_[bin + 1] += bin_start_[bin];
    }
    bin_stems_.resize(bin_start_.back());
    std::vector<std::uint32_t> next(bin_start_.begin(), bin_start_.end() - 1);
    for (std::uint32_t i = 0; i < stems_.size(); ++i) {
        if (stems_[i].height_m > 0.0) {
            each_touched_bin(stems_[i], [&](std::size_t bin) { bin_stems_[next[bin]++] = i; });
        }
    }
}

/// A straight path in plan with the heights along it.
struct StemIndex::Path {
    double x_m, y_m;                  // start
    double direction_x, direction_y;  // unit vector in plan
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

void StemIndex::look_into(std::size_t bin, const Path& path, StemHit& first) const {
    const double widest = with_taper_ ? taper_at_ground : 1.0;
    for (std::uint32_t k = bin_start_[bin]; k < bin_start_[bin + 1]; ++k) {
        const std::uint32_t i = bin_stems_[k];
        const PlacedStem& stem = stems_[i];
        const double rx = stem.x_m - path.x_m;
        const double ry = stem.y_m - path.y_m;
        const double offset_m = path.direction_x * ry - path.direction_y * rx;
        const double widest_reach_m = path.rock_radius_m + widest * stem.breast_radius_m;
        const double squared_offset = offset_m * offset_m;
        if (squared_offset >= widest_reach_m * widest_reach_m) {
            continue;
        }
        const double abeam_m = path.direction_x * rx + path.direction_y * ry;
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
            reach_m = path.rock_radius_m + stem.breast_radius_m * taper(height_m, stem.height_m);
            if (squared_offset >= reach_m * reach_m) {
                continue;
            }
            time_s =
                std::max(0.0, abeam_m - std::sqrt(reach_m * reach_m - squared_offset)) / path.plan_speed_mps;
            height_m = path.underside_m(time_s) + path.rock_radius_m - stem.ground_m;
        }
        const bool below_top = height_m - path.rock_radius_m < stem.height_m;
        if (below_top && time_s <= path.until_s &&
            (time_s < first.time_s || (time_s == first.time_s && i < first.stem))) {
            first = {i, time_s, offset_m, reach_m, std::max(height_m, 0.0)};
        }
    }
}

std::optional<StemHit> StemIndex::search(const Path& path) const {
    StemHit first{no_stem, std::numeric_limits<double>::infinity(), 0.0, 0.0, 0.0};
    constexpr double never = std::numeric_limits<double>::infinity();
    constexpr double bins_per_m = 1.0 / bin_size_m;
    // Place in units of bins, from the north-western corner: columns to the east, rows to the south.
    const double column = (path.x_m - bins_.x_west_m) * bins_per_m;
    const double row = (bins_.y_north_m() - path.y_m) * bins_per_m;
    config::Cell cell{static_cast<int>(std::floor(column)), static_cast<int>(std::floor(row))};
    const int step_column = path.direction_x >= 0.0 ? 1 : -1;
    const int step_row = path.direction_y >= 0.0 ? -1 : 1;
    // Distance along the path from one bin border to the next, and to the first one.
    const double per_column_m = path.direction_x != 0.0 ? bin_size_m / std::abs(path.direction_x) : never;
    const double per_row_m = path.direction_y != 0.0 ? bin_size_m / std::abs(path.direction_y) : never;
    const double into_column = step_column > 0 ? cell.column + 1 - column : column - cell.column;
    const double into_row = step_row > 0 ? cell.row + 1 - row : row - cell.row;
    double to_column_m = path.direction_x != 0.0 ? into_column * per_column_m : never;
    double to_row_m = path.direction_y != 0.0 ? into_row * per_row_m : never;
    const double length_m = path.plan_speed_mps * path.until_s;
    while (true) {
        if (bins_.contains(cell)) {
            look_into(bins_.index(cell), path, first);
        }
        const double next_border_m = std::min(to_column_m, to_row_m);
        // A hit before the border of this bin cannot be undercut by stems of a later one.
        if (next_border_m >= length_m || first.time_s * path.plan_speed_mps <= next_border_m) {
            break;
        }
        if (to_column_m <= to_row_m) {
            cell.column += step_column;
            to_column_m += per_column_m;
        } else {
            cell.row += step_row;
            to_row_m += per_row_m;
        }
    }
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
    return search({flight.start_m.x(), flight.start_m.y(), flight.velocity_mps.x() / plan_speed_mps,
                   flight.velocity_mps.y() / plan_speed_mps, plan_speed_mps, until_s, rock_radius_m,
                   flight.start_m.z(), flight.velocity_mps.z(), config::gravity_mps2, ignored, gone});
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
    return search({start_m.x(), start_m.y(), velocity_mps.x() / plan_speed_mps,
                   velocity_mps.y() / plan_speed_mps, plan_speed_mps, until_s, rock_radius_m, start_m.z(),
                   velocity_mps.z(), 0.0, ignored, gone});
}

}  // namespace rockfall
