#include "coupling/exchange/stopping_places.hpp"

#include <algorithm>
#include <cmath>

namespace coupling::exchange {
namespace {

/// Coordinates of arrivals are kept in single precision.
constexpr double slack_m = 0.01;

std::size_t band_of_distance(double distance_m) {
    return static_cast<std::size_t>(distance_m / distance_band_m);
}

/// The rows of a rock at the head of a list in rock order, which then begins after them.
template <class Row, class NumberOf>
std::span<const Row> take_rows(std::span<const Row>& rows, std::uint64_t rock, const NumberOf& number_of) {
    std::size_t count = 0;
    while (count < rows.size() && number_of(rows[count]) == rock) {
        ++count;
    }
    const std::span<const Row> taken = rows.first(count);
    rows = rows.subspan(count);
    return taken;
}

}  // namespace

void PlaceCounts::add(const PlaceCounts& other) {
    spared += other.spared;
    came += other.came;
    met += other.met;
    missed += other.missed;
    missed_arrived += other.missed_arrived;
}

StoppingPlaceCounter::StoppingPlaceCounter(std::span<const rockfall::TargetDistance> distances,
                                           const forest::PatchGrid& grid, const Eigen::Vector2d& origin_m,
                                           std::span<const rockfall::PlacedStem> stems)
    : distances_{distances}, grid_{grid}, origin_m_{origin_m}, stems_{stems} {
    places_.bands.resize(distances.size());
    places_.without_tree.resize(distances.size());
    places_.patches.resize(grid.size() + 1);
    visit_of_patch_.resize(grid.size() + 1);
}

void StoppingPlaceCounter::add(const rockfall::ChunkRows& rows, const BareYear& bare) {
    const auto forest = static_cast<std::size_t>(rockfall::Cover::forest);
    const auto first_of_pair = [](const auto& row) { return row.first; };
    std::span tree_hits{rows.tree_hits};
    std::span log_hits{rows.log_hits};
    std::span arrivals{rows.arrivals[forest]};
    for (const rockfall::RockRecord& fall : rows.rocks[forest]) {
        add_rock({fall, take_rows(tree_hits, fall.rock, first_of_pair),
                  take_rows(log_hits, fall.rock, first_of_pair),
                  take_rows(arrivals, fall.rock, [](const auto& row) { return row.rock; })},
                 bare);
    }
}

void StoppingPlaceCounter::add_rock(const RowsOfRock& rock, const BareYear& bare) {
    const Eigen::Vector2d start_m = rock.fall.start_m.head<2>();
    auto arrival = rock.arrivals.begin();
    bool known = false;
    for (std::size_t target = 0; target < distances_.size(); ++target) {
        const bool arrives = arrival != rock.arrivals.end() && arrival->target == target;
        const bool arrives_bare = bare.has_arrived(rock.fall.rock, target);
        if (!arrives && !arrives_bare) {
            continue;
        }
        if (!known) {
            find_meetings(rock);
            known = true;
        }
        Eigen::Vector2d end_m = rock.fall.end_m.head<2>();
        std::span<const Meeting> met{meetings_};
        if (arrives) {
            end_m = {arrival->arrival.x_m, arrival->arrival.y_m};
            const double way_m = (end_m - start_m).norm() + slack_m;
            const auto beyond = std::find_if(met.begin(), met.end(), [way_m](const Meeting& meeting) {
                return meeting.from_start_m > way_m;
            });
            met = met.first(static_cast<std::size_t>(beyond - met.begin()));
            ++arrival;
        }
        if (arrives != arrives_bare) {
            credit(target, met, arrives_bare ? 1 : -1);
        }
        if (arrives_bare) {
            count_bands(target, met, rock.fall, arrives);
            count_patches(met, start_m, end_m, arrives);
        }
    }
}

void StoppingPlaceCounter::find_meetings(const RowsOfRock& rock) {
    meetings_.clear();
    const Eigen::Vector2d start_m = rock.fall.start_m.head<2>();
    const auto add = [&](const Eigen::Vector2d& tree_m, const Eigen::Vector2d& rock_m) {
        meetings_.push_back({tree_m, rock_m, (rock_m - start_m).norm()});
    };
    bool held = false;
    for (const auto& [number, hit] : rock.tree_hits) {
        add({stems_[hit.stem].x_m, stems_[hit.stem].y_m}, hit.position_m.head<2>());
        held = held || hit.stopped;
    }
    const std::size_t stems = meetings_.size();
    for (const auto& [number, hit] : rock.log_hits) {
        add(hit.position_m.head<2>(), hit.position_m.head<2>());
        held = held || hit.outcome == rockfall::LogOutcome::stopped;
    }
    // Each list is in the order of the fall.
    std::inplace_merge(meetings_.begin(), meetings_.begin() + static_cast<std::ptrdiff_t>(stems),
                       meetings_.end(),
                       [](const Meeting& a, const Meeting& b) { return a.from_start_m < b.from_start_m; });
    const bool by_obstacle =
        rock.fall.reason == rockfall::StopReason::tree || rock.fall.reason == rockfall::StopReason::log;
    if (by_obstacle && !held) {
        const Eigen::Vector2d end_m = rock.fall.end_m.head<2>();
        add(end_m, end_m);
    }
}

void StoppingPlaceCounter::credit(std::size_t target, std::span<const Meeting> met, std::int32_t rocks) {
    if (met.empty()) {
        places_.without_tree[target] += rocks;
        places_.patches.back().spared += rocks;
        return;
    }
    const Eigen::Vector2d& last_m = met.back().tree_m;
    band(target, band_of_distance(distances_[target].from_m(last_m))).spared += rocks;
    places_.patches[patch_at(last_m)].spared += rocks;
}

void StoppingPlaceCounter::count_bands(std::size_t target, std::span<const Meeting> met,
                                       const rockfall::RockRecord& fall, bool arrives) {
    const rockfall::TargetDistance& distance = distances_[target];
    std::size_t last = arrives ? 0 : band_of_distance(distance.from_m(fall.end_m.head<2>()));
    bands_met_.clear();
    for (const Meeting& meeting : met) {
        bands_met_.push_back(band_of_distance(distance.from_m(meeting.tree_m)));
        last = std::min(last, bands_met_.back());
    }
    const std::size_t first = std::max(last, band_of_distance(distance.from_m(fall.start_m.head<2>())));
    for (std::size_t number = last; number <= first; ++number) {
        PlaceCounts& counts = band(target, number);
        ++counts.came;
        if (std::find(bands_met_.begin(), bands_met_.end(), number) != bands_met_.end()) {
            ++counts.met;
        } else if (arrives || number > last) {
            ++counts.missed;
            counts.missed_arrived += arrives ? 1 : 0;
        }
    }
}

void StoppingPlaceCounter::count_patches(std::span<const Meeting> met, const Eigen::Vector2d& start_m,
                                         const Eigen::Vector2d& end_m, bool arrives) {
    ++visit_;
    visited_.clear();
    Eigen::Vector2d from_m = start_m;
    for (const Meeting& meeting : met) {
        visit_between(from_m, meeting.rock_m);
        visit(patch_at(meeting.tree_m));
        from_m = meeting.rock_m;
    }
    visit_between(from_m, end_m);
    for (const std::uint32_t patch : visited_) {
        ++places_.patches[patch].came;
    }
    // What is left in `visited_` met no tree.
    for (const Meeting& meeting : met) {
        const auto patch = static_cast<std::uint32_t>(patch_at(meeting.tree_m));
        if (const auto found = std::find(visited_.begin(), visited_.end(), patch); found != visited_.end()) {
            ++places_.patches[patch].met;
            visited_.erase(found);
        }
    }
    const std::size_t at_end = arrives ? places_.patches.size() : patch_at(end_m);
    for (const std::uint32_t patch : visited_) {
        if (patch != at_end) {
            ++places_.patches[patch].missed;
            places_.patches[patch].missed_arrived += arrives ? 1 : 0;
        }
    }
}

void StoppingPlaceCounter::visit(std::size_t patch) {
    if (patch + 1 < visit_of_patch_.size() && visit_of_patch_[patch] != visit_) {
        visit_of_patch_[patch] = visit_;
        visited_.push_back(static_cast<std::uint32_t>(patch));
    }
}

void StoppingPlaceCounter::visit_between(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
    // From one crossing with a line of the grid to the next (Amanatides & Woo 1987).
    const Eigen::Vector2d along_m = to_m - from_m;
    const Eigen::Vector2d corner_m{grid_.frame().x_west_m, grid_.frame().y_south_m};
    const Eigen::Array2d begin = (from_m + origin_m_ - corner_m).array() / forest::patch_side_m;
    const Eigen::Array2d step = along_m.array() / forest::patch_side_m;
    std::array<double, 2> next{};   // share of the way at the next crossing
    std::array<double, 2> apart{};  // between two crossings
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const double to_line = step[axis] > 0.0 ? std::floor(begin[axis]) + 1.0 - begin[axis]
                                                : begin[axis] - std::floor(begin[axis]);
        const double size = std::abs(step[axis]);
        apart[i] = size > 0.0 ? 1.0 / size : std::numeric_limits<double>::infinity();
        next[i] = size > 0.0 ? to_line / size : std::numeric_limits<double>::infinity();
    }
    double here = 0.0;
    while (true) {
        const std::size_t axis = next[0] < next[1] ? 0 : 1;
        const double there = std::min(1.0, next[axis]);
        // The middle of a piece lies inside the patch that it crosses, its ends lie on the border.
        visit(patch_at(from_m + 0.5 * (here + there) * along_m));
        if (!(next[axis] < 1.0)) {
            return;
        }
        here = there;
        next[axis] += apart[axis];
    }
}

std::size_t StoppingPlaceCounter::patch_at(const Eigen::Vector2d& place_m) const {
    const auto patch = grid_.at(place_m.x() + origin_m_.x(), place_m.y() + origin_m_.y());
    return patch ? forest::index_of(*patch) : grid_.size();
}

PlaceCounts& StoppingPlaceCounter::band(std::size_t target, std::size_t number) {
    std::vector<PlaceCounts>& bands = places_.bands[target];
    if (number >= bands.size()) {
        bands.resize(number + 1);
    }
    return bands[number];
}

}  // namespace coupling::exchange
