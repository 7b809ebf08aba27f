#include "coupling/assessments/calibrate/model/seen_of.hpp"

#include <algorithm>
#include <cmath>

namespace coupling::calibrate {
namespace {

double value_of(const rockfall::Arrival& arrival, Seen seen) {
    switch (seen) {
        case Seen::speed:
            return static_cast<double>(arrival.speed_mps);
        case Seen::height:
            return static_cast<double>(arrival.height_m);
        case Seen::energy:
            return 1e-3 * static_cast<double>(arrival.energy_j);
        default:
            return 1e-3 * static_cast<double>(arrival.translational_j);
    }
}

/// Rocks whose stops somebody could have found.
std::vector<const SetRocks::End*> found_ends(const SetRocks& rocks, const Observation& observation,
                                             const Search& search) {
    std::vector<const SetRocks::End*> found;
    for (const SetRocks::End& end : rocks.ends) {
        const bool from_zone =
            observation.zones.empty() ||
            std::binary_search(observation.zones.begin(), observation.zones.end(), end.zone);
        if (from_zone && !end.left_terrain &&
            static_cast<double>(end.diameter_m) >= search.least_diameter_m &&
            is_looked_at(end.end_m, search)) {
            found.push_back(&end);
        }
    }
    return found;
}

Sample ends_of(const SetRocks& rocks, const Observation& observation, const Search& search) {
    Sample sample{.is_plane = observation.is_plane()};
    for (const SetRocks::End* end : found_ends(rocks, observation, search)) {
        if (sample.is_plane) {
            sample.points.push_back(end->end_m);
        } else {
            sample.points.emplace_back(observation.sources ? observation.sources->at(end->end_m)
                                                           : (end->end_m - end->start_m).norm(),
                                       0.0);
        }
    }
    return sample;
}

/// Whether each stop lies within the outline.
Sample shares_within(const SetRocks& rocks, const Observation& observation, const Search& search) {
    Sample sample;
    for (const SetRocks::End* end : found_ends(rocks, observation, search)) {
        sample.points.emplace_back(observation.outline->holds(end->end_m) ? 1.0 : 0.0, 0.0);
    }
    return sample;
}

/// Reaches of outlines around as many stops as were seen, each of other rocks.
Sample reaches_of(const SetRocks& rocks, const Observation& observation, const Search& search) {
    std::vector<double> distances;
    for (const SetRocks::End* end : found_ends(rocks, observation, search)) {
        distances.push_back(observation.outline->sources.at(end->end_m));
    }
    return sample_of_values(observation.outline->reaches_around(distances));
}

/// Of hits on stems that were searched.
Sample searched_hits(const SetRocks& rocks, const Observation& observation) {
    Sample sample{.is_plane = observation.is_plane()};
    for (const SetRocks::Hit& hit : rocks.hits) {
        if (const auto tree = observation.trees->find(hit.stem_m)) {
            sample.points.push_back(sample.is_plane
                                        ? hit.stem_m
                                        : Eigen::Vector2d{observation.trees->trees()[*tree].dbh_cm, 0.0});
        }
    }
    return sample;
}

/// Wounds of each searched stem, if as many rocks had fallen as were seen: of the hits of more rocks every
/// so many.
Sample scars_of_stems(const SetRocks& rocks, const Observation& observation) {
    std::vector<double> scars(observation.trees->trees().size(), 0.0);
    const double kept = std::min(1.0, static_cast<double>(observation.rocks) /
                                          static_cast<double>(std::max<std::size_t>(1, rocks.ends.size())));
    double number = 0.0;
    for (const SetRocks::Hit& hit : rocks.hits) {
        if (const auto tree = observation.trees->find(hit.stem_m)) {
            scars[*tree] += std::floor((number + 1.0) * kept) - std::floor(number * kept);
            number += 1.0;
        }
    }
    return sample_of_values(scars);
}

Sample jumps_of(const SetRocks& rocks, const Observation& observation) {
    Sample sample;
    for (const SetRocks::Jump& jump : rocks.jumps) {
        const bool on_ground =
            observation.grounds.empty() ||
            std::binary_search(observation.grounds.begin(), observation.grounds.end(), jump.ground);
        if (on_ground && static_cast<double>(jump.length_m) >= observation.least_jump_m) {
            sample.points.emplace_back(static_cast<double>(jump.length_m), 0.0);
        }
    }
    return sample;
}

Sample passages_of(const SetRocks& rocks, const Observation& observation) {
    Sample sample;
    for (const SetRocks::Passage& passage : rocks.passages) {
        if (passage.target == observation.target) {
            sample.points.emplace_back(value_of(passage.arrival, observation.seen), 0.0);
        }
    }
    return sample;
}

Sample passing_of(const SetRocks& rocks, const Observation& observation) {
    const auto passed = static_cast<std::size_t>(std::count_if(
        rocks.passages.begin(), rocks.passages.end(),
        [&](const SetRocks::Passage& passage) { return passage.target == observation.target; }));
    Sample sample;
    for (std::size_t i = 0; i < rocks.ends.size(); ++i) {
        sample.points.emplace_back(i < passed ? 1.0 : 0.0, 0.0);
    }
    return sample;
}

}  // namespace

Sample seen_of(const SetRocks& rocks, const Observation& observation, const Search& search) {
    switch (observation.seen) {
        case Seen::stops:
        case Seen::run_out:
            return ends_of(rocks, observation, search);
        case Seen::scar_heights:
        case Seen::scar_places: {
            Sample sample{.is_plane = observation.is_plane()};
            for (const SetRocks::Hit& hit : rocks.hits) {
                if (static_cast<double>(hit.dbh_cm) >= search.least_scar_dbh_cm) {
                    sample.points.push_back(sample.is_plane
                                                ? hit.stem_m
                                                : Eigen::Vector2d{static_cast<double>(hit.height_m), 0.0});
                }
            }
            return sample;
        }
        case Seen::passing:
            return passing_of(rocks, observation);
        case Seen::tree_dbh:
        case Seen::tree_places:
            return searched_hits(rocks, observation);
        case Seen::tree_scars:
            return scars_of_stems(rocks, observation);
        case Seen::outline_share:
            return shares_within(rocks, observation, search);
        case Seen::outline_reach:
            return reaches_of(rocks, observation, search);
        case Seen::jumps:
            return jumps_of(rocks, observation);
        default:
            return passages_of(rocks, observation);
    }
}

}  // namespace coupling::calibrate
