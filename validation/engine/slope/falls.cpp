#include "validation/engine/slope/falls.hpp"

#include <omp.h>

#include <algorithm>
#include <mutex>
#include <span>
#include <stdexcept>

#include "config/text/joined.hpp"
#include "coupling/run/first_error.hpp"
#include "coupling/run/interrupt.hpp"
#include "validation/engine/slope/artificial_stand.hpp"

namespace coupling::validation {
namespace {

using config::joined;

/// Rocks of one ensemble that fall through one stand, one after the other.
struct Batch {
    std::size_t ensemble = 0;  ///< 0: the large one; 1 + i: series i
    std::size_t stand = 0;
    std::uint64_t first_rock = 0;
    std::uint32_t rocks = 0;
};

/// Cuts the large ensemble into equal shares of the stands and these into pieces. Depends on numbers of rocks
/// alone, never on threads.
std::vector<Batch> plan_batches(const Recipe& recipe, std::size_t stands) {
    constexpr std::uint64_t most_rocks = 250;
    std::vector<Batch> batches;
    for (std::size_t stand = 0; stand < stands; ++stand) {
        const std::uint64_t last = recipe.rocks * (stand + 1) / stands;
        for (std::uint64_t first = recipe.rocks * stand / stands; first < last; first += most_rocks) {
            batches.push_back(
                {0, stand, first, static_cast<std::uint32_t>(std::min(most_rocks, last - first))});
        }
    }
    for (std::size_t i = 0; i < recipe.series; ++i) {
        batches.push_back({i + 1, i % stands, 0, static_cast<std::uint32_t>(recipe.rocks_per_series)});
    }
    return batches;
}

std::size_t stands_of(const Recipe& recipe) {
    return recipe.has_stand() ? static_cast<std::size_t>(recipe.stands) : 1;
}

/// One cell over all of the terrain: no map is wanted.
config::GridFrame whole_terrain(const RebuiltSlope& slope) {
    const double side_m = slope.width_m + 2.0 * margin_m;
    const Eigen::Vector2d corner_m = slope.on_terrain(slope.upper_m() - 2.0 * margin_m, -side_m);
    return {1, 1, corner_m.x(), corner_m.y(), slope.lower_m() - slope.upper_m() + 4.0 * margin_m, 2 * side_m};
}

/// Everything that the batches share.
class Experiment {
public:
    Experiment(const Recipe& recipe, const RebuiltSlope& slope, const FallRequest& request)
        : recipe_{recipe}, slope_{slope}, request_{request}, length_{slope.profile} {
        for (const Station& station : recipe.stations) {
            lines_.push_back(slope.line_at(station.name, station.distance_m));
        }
        lines_.push_back(slope.line_at("lower end", slope.lower_m()));
        plant_stands();
    }

    Ensembles run() {
        const std::vector<Batch> batches = plan_batches(recipe_, stands_.size());
        std::vector<Falls> forest(batches.size());
        std::vector<Falls> open(request_.open_too ? batches.size() : 0);
        FirstError error;
        const auto count = static_cast<std::int64_t>(batches.size());
#pragma omp parallel for schedule(dynamic, 1) num_threads(request_.threads)
        for (std::int64_t i = 0; i < count; ++i) {
            const auto b = static_cast<std::size_t>(i);
            error.guard([&] {
                if (InterruptGuard::requested()) {
                    throw Interrupted{};
                }
                forest[b] = fall(batches[b], rockfall::Cover::forest);
                if (request_.open_too) {
                    open[b] = fall(batches[b], rockfall::Cover::bare);
                }
                if (request_.fallen) {
                    const std::lock_guard lock{telling_};
                    request_.fallen(batches[b].rocks);
                }
            });
        }
        error.rethrow();
        return put_together(batches, forest, open);
    }

private:
    void plant_stands() {
        stands_.resize(stands_of(recipe_));
        if (!recipe_.has_stand()) {
            return;
        }
        const ArtificialStands drawn{
            recipe_,
            {std::max(recipe_.stand_from_m, slope_.upper_m() - margin_m),
             std::min(recipe_.stand_to_m, slope_.lower_m() + margin_m), recipe_.width_m}};
        const rockfall::Terrain& terrain = slope_.slope.terrain;
        FirstError error;
        const auto count = static_cast<std::int64_t>(stands_.size());
#pragma omp parallel for schedule(dynamic, 1) num_threads(request_.threads)
        for (std::int64_t k = 0; k < count; ++k) {
            error.guard([&] {
                const auto stems = stems_of(drawn.draw(static_cast<std::uint32_t>(k)));
                stands_[static_cast<std::size_t>(k)] = {stems, terrain, 0.5 * recipe_.diameter_m,
                                                        recipe_.rockfall.fall.tree.taper};
            });
        }
        error.rethrow();
    }

    Falls fall(const Batch& batch, rockfall::Cover cover) {
        rockfall::ReleaseSource source;
        source.kind = rockfall::ReleaseSource::Kind::line;
        source.first_m = source.last_m = slope_.on_terrain(slope_.upper_m(), 0.0);
        source.first_rock = batch.first_rock;
        source.rocks = batch.rocks;
        const rockfall::Assessment assessment{.slope = slope_.slope,
                                              .stems = stands_[batch.stand],
                                              .sources = {&source, 1},
                                              .targets = lines_,
                                              .start = start_law(recipe_),
                                              .law = recipe_.rockfall.fall,
                                              .map_frame = whole_terrain(slope_),
                                              .seed = recipe_.seed,
                                              .replicate = static_cast<std::uint32_t>(batch.ensemble)};
        Falls falls;
        falls.lines = lines_.size();
        const bool bare = cover == rockfall::Cover::bare || stands_[batch.stand].empty();
        std::vector<std::uint8_t> gone;
        if (!bare && recipe_.rockfall.fall.tree.remove_broken) {
            gone.assign(stands_[batch.stand].placed().size(), 0);
        }
        if (watch_falls(
                assessment, bare ? rockfall::Cover::bare : rockfall::Cover::forest, 1,
                [&](const WatchedFall& one) { falls.add(one, slope_, length_); },
                gone) == Ended::interrupted) {
            throw Interrupted{};
        }
        return falls;
    }

    [[nodiscard]] Ensembles put_together(const std::vector<Batch>& batches, const std::vector<Falls>& forest,
                                         const std::vector<Falls>& open) const {
        Ensembles all;
        all.series.resize(recipe_.series);
        all.open_series.resize(open.empty() ? 0 : recipe_.series);
        for (std::size_t b = 0; b < batches.size(); ++b) {
            const std::size_t e = batches[b].ensemble;
            (e == 0 ? all.large : all.series[e - 1]).append(forest[b]);
            if (!open.empty()) {
                (e == 0 ? all.open_large : all.open_series[e - 1]).append(open[b]);
            }
        }
        return all;
    }

    const Recipe& recipe_;
    const RebuiltSlope& slope_;
    const FallRequest& request_;
    SlopeLength length_;
    std::vector<rockfall::Target> lines_;
    std::vector<rockfall::StemIndex> stands_;
    std::mutex telling_;
};

}  // namespace

void JumpSums::add(double length_m, double height_m) {
    shortest_m = jumps == 0 ? length_m : std::min(shortest_m, length_m);
    longest_m = jumps == 0 ? length_m : std::max(longest_m, length_m);
    sum_m += length_m;
    squares_m2 += length_m * length_m;
    height_sum_m += height_m;
    highest_m = std::max(highest_m, height_m);
    ++jumps;
}

void JumpSums::add(const JumpSums& other) {
    if (other.jumps == 0) {
        return;
    }
    shortest_m = jumps == 0 ? other.shortest_m : std::min(shortest_m, other.shortest_m);
    longest_m = jumps == 0 ? other.longest_m : std::max(longest_m, other.longest_m);
    sum_m += other.sum_m;
    squares_m2 += other.squares_m2;
    height_sum_m += other.height_sum_m;
    highest_m = std::max(highest_m, other.highest_m);
    jumps += other.jumps;
}

void Falls::add(const WatchedFall& fall, const RebuiltSlope& slope, const SlopeLength& length) {
    if (!fall.started) {
        throw std::logic_error{"the start of a case lies outside its terrain"};
    }
    const Eigen::Vector2d origin_m = slope.slope.terrain.origin_m();
    const rockfall::RockRecord& record = fall.record;
    RockFacts facts;
    facts.reason = record.reason;
    facts.end_m = record.end_m.x() + origin_m.x();
    facts.max_speed_mps = record.max_speed_mps;
    facts.mean_speed_mps = record.mean_speed_mps();
    facts.impacts = record.ground_impacts;
    facts.tree_hits = record.tree_hits;
    facts.trees_broken = record.trees_broken;
    // The flight from a release above the ground is no jump: its height and length are the experimenter's.
    const std::size_t first = slope.released_in_flight && !fall.jumps.empty() ? 1 : 0;
    for (const rockfall::Jump& jump : std::span{fall.jumps}.subspan(first)) {
        if (jump.length_m() < rockfall::least_jump_m) {
            continue;
        }
        ++facts.jumps;
        facts.max_height_m = std::max(facts.max_height_m, jump.highest_m);
        facts.jump_height_sum_m += jump.highest_m;
        if (!jump.landed) {
            continue;
        }
        ++facts.landed_jumps;
        facts.jump_length_sum_m += jump.plan_length_m();
        const double end_m = std::max(0.0, length.at_m(jump.to_m.x() + origin_m.x()));
        const auto segment = static_cast<std::size_t>(end_m / jump_segment_m);
        if (segment >= segments.size()) {
            segments.resize(segment + 1);
        }
        segments[segment].add(jump.length_m(), jump.highest_m);
    }
    rocks.push_back(facts);
    for (rockfall::Arrival arrival : fall.arrivals) {
        arrival.y_m += static_cast<float>(origin_m.y());
        arrivals.push_back(arrival);
    }
    for (const rockfall::TreeHitRecord& hit : fall.tree_hits) {
        hit_heights_m.push_back(hit.height_m);
    }
}

void Falls::append(const Falls& other) {
    lines = other.lines;
    rocks.insert(rocks.end(), other.rocks.begin(), other.rocks.end());
    arrivals.insert(arrivals.end(), other.arrivals.begin(), other.arrivals.end());
    hit_heights_m.insert(hit_heights_m.end(), other.hit_heights_m.begin(), other.hit_heights_m.end());
    segments.resize(std::max(segments.size(), other.segments.size()));
    for (std::size_t k = 0; k < other.segments.size(); ++k) {
        segments[k].add(other.segments[k]);
    }
}

std::uint64_t rocks_of(const Recipe& recipe) {
    return recipe.rocks + recipe.series * recipe.rocks_per_series;
}

std::string extent_of(const Recipe& recipe) {
    return joined(std::to_string(recipe.rocks), " rocks, ", std::to_string(recipe.series), " series of ",
                  std::to_string(recipe.rocks_per_series));
}

Ensembles simulate_falls(const Recipe& recipe, const RebuiltSlope& slope, const FallRequest& request) {
    return Experiment{recipe, slope, request}.run();
}

}  // namespace coupling::validation
