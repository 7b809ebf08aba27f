// The cells that a footprint passes.

#include <algorithm>
#include <cmath>

#include "rockfall/tally/footprint.hpp"

namespace rockfall {

void Footprint::begin_cells() {
    if (++present_rock_ == 0) {  // the counter came round: old marks would look new
        std::fill(slots_.begin(), slots_.end(), CellSlot{});
        present_rock_ = 1;
    }
    maxima_.clear();
    visits_.clear();
    slot_here_ = no_slot;
}

void Footprint::finish_cells() {
    visits_.reserve(maxima_.size());
    for (const CellMaxima& m : maxima_) {
        visits_.push_back({m.cell, static_cast<float>(m.energy_j),
                           static_cast<float>(std::sqrt(m.squared_speed)), static_cast<float>(m.height_m),
                           static_cast<float>(m.energy_line_slope), m.tree_impacts});
    }
}

// Apart, so that the loops over cells keep their numbers in registers.
[[gnu::noinline]] Footprint::CellMaxima& Footprint::enter_cell(std::size_t cell) {
    slots_[cell] = {present_rock_, static_cast<std::uint32_t>(maxima_.size())};
    CellMaxima& entered = maxima_.emplace_back();
    entered.cell = static_cast<std::uint32_t>(cell);
    return entered;
}

inline void Footprint::stand_in(const config::Cell& cell) {
    cell_here_ = {frame_, cell};
    slot_here_ = no_slot;
}

inline void Footprint::raise(CellMaxima& maxima, double energy_j, double squared_speed, double height_m,
                             double x_m, double y_m, double ground_m) const {
    maxima.energy_j = std::max(maxima.energy_j, energy_j);
    maxima.squared_speed = std::max(maxima.squared_speed, squared_speed);
    maxima.height_m = std::max(maxima.height_m, height_m);
    const double dx = x_m - record_.start_m.x();
    const double dy = y_m - record_.start_m.y();
    const double squared_distance = dx * dx + dy * dy;
    if (squared_distance > 0.0) {
        const double slope = (record_.start_m.z() - ground_m) / std::sqrt(squared_distance);
        maxima.energy_line_slope = std::min(maxima.energy_line_slope, slope);
    }
}

double Footprint::walk_cells(const Rock& rock, const Flight& flight, double until_s, GroundBelow& ground,
                             double rotation_j) {
    const double x_m = flight.start_m.x(), y_m = flight.start_m.y();
    const double vx_mps = flight.velocity_mps.x(), vy_mps = flight.velocity_mps.y();
    // Where most ways stay in a cell and begin where another ended, the cell is known.
    const bool is_known = cell_here_.has(x_m, y_m);
    const bool stays = is_known && cell_here_.has(x_m + until_s * vx_mps, y_m + until_s * vy_mps);
    CellSteps steps =
        stays ? CellSteps{cell_here_.cell}
              : CellSteps{frame_, is_known ? cell_here_.cell : frame_.cell_at(x_m, y_m), x_m, y_m, vx_mps,
                          vy_mps};
    const Triangle* const triangles = terrain_.triangles().data();
    double time_s = 0.0;
    double squared_speed = flight.squared_speed_at(0.0);
    double highest_of_flight_m = 0.0;
    while (true) {
        const double cell_end_s = std::min(steps.end(), until_s);
        double highest_normal_m = 0.0;
        while (true) {
            const double piece_end_s = ground.last() ? cell_end_s : std::min(ground.end_s(), cell_end_s);
            const double height_m = ground.highest_m(time_s, piece_end_s);
            highest_of_flight_m = std::max(highest_of_flight_m, height_m);
            highest_normal_m = std::max(
                highest_normal_m, height_m * static_cast<double>(triangles[ground.triangle()].normal_z));
            time_s = piece_end_s;
            if (piece_end_s >= cell_end_s) {
                break;
            }
            ground.next();
        }
        const double squared_speed_end = flight.squared_speed_at(cell_end_s);
        if (frame_.contains(steps.cell())) {
            // The square of the speed is convex in time: its maximum lies at an end.
            const double largest = std::max(squared_speed, squared_speed_end);
            raise(maxima_of(frame_.index(steps.cell())), 0.5 * rock.mass_kg * largest + rotation_j, largest,
                  highest_normal_m, x_m + cell_end_s * vx_mps, y_m + cell_end_s * vy_mps,
                  ground.at(cell_end_s));
        }
        if (cell_end_s >= until_s) {
            if (!stays) {
                stand_in(steps.cell());
            }
            return highest_of_flight_m;
        }
        squared_speed = squared_speed_end;
        steps.next();
    }
}

void Footprint::walk_cells(const Rock& rock, const RollingPiece& piece, const Eigen::Vector3d& end_m,
                           double begin2, double end2, double begin_j, double end_j) {
    // Share of the way takes the place of time; the squared speed changes evenly along the way.
    const Eigen::Vector3d move = end_m - piece.start_m;
    const double turns_j = piece.own_start.rotation_j;
    const double gains_j = piece.own_end.rotation_j - turns_j;
    const auto raise_until = [&](CellMaxima& maxima, double share, double cell_end) {
        const double largest2 = begin2 + (end2 - begin2) * (end2 > begin2 ? cell_end : share);
        const double at_largest = end_j > begin_j ? cell_end : share;
        const double squared_speed = begin2 + (end2 - begin2) * at_largest;
        const double largest_j =
            0.5 * rock.mass_kg * squared_speed +
            rotation_on_ground_j(rock, piece.slides, turns_j + at_largest * gains_j, squared_speed);
        const Eigen::Vector3d at = piece.start_m + cell_end * move;
        raise(maxima, largest_j, largest2, 0.0, at.x(), at.y(), at.z());
    };
    if (cell_here_.has(piece.start_m.x(), piece.start_m.y()) && cell_here_.has(end_m.x(), end_m.y())) {
        if (slot_here_ == no_slot && frame_.contains(cell_here_.cell)) {
            const std::size_t cell = frame_.index(cell_here_.cell);
            maxima_of(cell);
            slot_here_ = slots_[cell].slot;
        }
        if (slot_here_ != no_slot) {
            raise_until(maxima_[slot_here_], 0.0, 1.0);
        }
        return;
    }
    CellSteps steps{frame_, piece.start_m.x(), piece.start_m.y(), move.x(), move.y()};
    double share = 0.0;
    while (true) {
        const double cell_end = std::min(steps.end(), 1.0);
        if (frame_.contains(steps.cell())) {
            raise_until(maxima_of(frame_.index(steps.cell())), share, cell_end);
        }
        if (cell_end >= 1.0) {
            break;
        }
        share = cell_end;
        steps.next();
    }
    stand_in(steps.cell());
}

}  // namespace rockfall
