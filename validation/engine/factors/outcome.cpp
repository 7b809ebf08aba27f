#include "validation/engine/factors/outcome.hpp"

#include <algorithm>
#include <cmath>

namespace coupling::validation {

namespace {

using Figures = std::map<std::string, double>;

/// Figures of a forest with those of the bare slope where that fell too.
Figures with_open(const Falls& falls, const Falls* open, const FigureFrame& frame) {
    Figures figures = figures_of(falls, frame);
    if (open != nullptr) {
        add_open(figures, figures_of(*open, frame));
    }
    return figures;
}

/// Enters mean and deviation over the series that have the figure.
void add_series(Value& value, const std::vector<double>& of_series) {
    const auto count = static_cast<double>(of_series.size());
    if (of_series.empty()) {
        return;
    }
    double sum = 0.0;
    for (const double v : of_series) {
        sum += v;
    }
    value.series = sum / count;
    if (of_series.size() > 1) {
        double squares = 0.0;
        for (const double v : of_series) {
            squares += (v - *value.series) * (v - *value.series);
        }
        value.deviation = std::sqrt(squares / (count - 1.0));
    }
}

/// Share of rocks that get further than each distance from the start.
std::vector<double> passing(const Falls& falls, double start_m, const std::vector<double>& distances_m) {
    std::vector<double> ends_m;
    for (const RockFacts& rock : falls.rocks) {
        ends_m.push_back(rock.end_m - start_m);
    }
    std::sort(ends_m.begin(), ends_m.end());
    std::vector<double> shares;
    for (const double distance_m : distances_m) {
        const auto beyond = ends_m.end() - std::upper_bound(ends_m.begin(), ends_m.end(), distance_m);
        shares.push_back(static_cast<double>(beyond) / static_cast<double>(ends_m.size()));
    }
    return shares;
}

void add_run_out(VariantOutcome& outcome, const Ensembles& ensembles, const FigureFrame& frame,
                 double length_m) {
    constexpr double step_m = 5.0;
    std::vector<double> distances_m;
    for (double distance_m = 0.0; distance_m < length_m; distance_m += step_m) {
        distances_m.push_back(distance_m);
    }
    distances_m.push_back(length_m);
    const std::vector<double> all = passing(ensembles.large, frame.start_m, distances_m);
    std::vector<std::vector<double>> series;
    for (const Falls& falls : ensembles.series) {
        series.push_back(passing(falls, frame.start_m, distances_m));
    }
    for (std::size_t k = 0; k < distances_m.size(); ++k) {
        outcome.run_out.push_back({distances_m[k], all[k]});
        if (series.empty()) {
            continue;
        }
        std::vector<double> shares;
        for (const std::vector<double>& one : series) {
            shares.push_back(one[k]);
        }
        outcome.run_out_low.push_back({distances_m[k], quantile(shares, 0.05)});
        outcome.run_out_high.push_back({distances_m[k], quantile(shares, 0.95)});
    }
}

std::vector<double> shares_by_hits(const Falls& falls) {
    std::vector<double> shares;
    for (const RockFacts& rock : falls.rocks) {
        shares.resize(std::max<std::size_t>(shares.size(), rock.tree_hits + 1));
        shares[rock.tree_hits] += 1.0 / static_cast<double>(falls.rocks.size());
    }
    return shares;
}

void add_hits(VariantOutcome& outcome, const Ensembles& ensembles) {
    constexpr double bin_m = 0.5;
    const Falls& falls = ensembles.large;
    outcome.tree_hits = shares_by_hits(falls);
    std::vector<std::vector<double>> series;
    for (const Falls& one : ensembles.series) {
        series.push_back(shares_by_hits(one));
    }
    for (std::size_t hits = 0; hits < outcome.tree_hits.size() && !series.empty(); ++hits) {
        std::vector<double> shares;
        for (const std::vector<double>& one : series) {
            shares.push_back(hits < one.size() ? one[hits] : 0.0);
        }
        outcome.tree_hits_low.push_back(quantile(shares, 0.05));
        outcome.tree_hits_high.push_back(quantile(shares, 0.95));
    }
    for (const float height_m : falls.hit_heights_m) {
        const auto bin = static_cast<std::size_t>(std::max(0.0, static_cast<double>(height_m)) / bin_m);
        outcome.hit_heights.resize(std::max(outcome.hit_heights.size(), bin + 1));
        outcome.hit_heights[bin] += 1.0 / static_cast<double>(falls.hit_heights_m.size());
    }
}

/// `whole_m`: slope length of the profile, of which the upper half is distinguished from the lower.
void add_jumps(VariantOutcome& outcome, const Falls& falls, double whole_m) {
    for (std::size_t k = 0; k < falls.segments.size(); ++k) {
        const JumpSums& sums = falls.segments[k];
        if (sums.jumps == 0) {
            continue;
        }
        const auto jumps = static_cast<double>(sums.jumps);
        SegmentJumps segment;
        segment.from_m = static_cast<double>(k) * jump_segment_m;
        segment.to_m = segment.from_m + jump_segment_m;
        segment.jumps = sums.jumps;
        segment.shortest_m = sums.shortest_m;
        segment.mean_m = sums.sum_m / jumps;
        segment.longest_m = sums.longest_m;
        const double squares_m2 = std::max(0.0, sums.squares_m2 - jumps * segment.mean_m * segment.mean_m);
        segment.deviation_m = sums.jumps > 1 ? std::sqrt(squares_m2 / (jumps - 1.0)) : std::nan("");
        segment.mean_height_m = sums.height_sum_m / jumps;
        segment.highest_m = sums.highest_m;
        segment.upper = segment.from_m + 0.5 * jump_segment_m < 0.5 * whole_m;
        outcome.jumps.push_back(segment);
    }
}

}  // namespace

FigureFrame frame_of(const Recipe& recipe, const RebuiltSlope& slope, const std::vector<Section>& sections) {
    FigureFrame frame;
    frame.start_m = slope.upper_m();
    frame.slope_length_m = SlopeLength{slope.profile}.at_m(slope.lower_m());
    frame.radius_m = 0.5 * recipe.diameter_m;
    frame.sections = sections;
    for (const Station& station : recipe.stations) {
        frame.stations.push_back(station.name);
    }
    return frame;
}

Values values_of(const Ensembles& ensembles, const FigureFrame& frame) {
    const bool open = !ensembles.open_large.rocks.empty();
    Values values;
    for (const auto& [name, value] :
         with_open(ensembles.large, open ? &ensembles.open_large : nullptr, frame)) {
        values[name].value = value;
    }
    std::map<std::string, std::vector<double>> of_series;
    for (std::size_t i = 0; i < ensembles.series.size(); ++i) {
        for (const auto& [name, value] :
             with_open(ensembles.series[i], open ? &ensembles.open_series[i] : nullptr, frame)) {
            if (std::isfinite(value)) {
                of_series[name].push_back(value);
            }
        }
    }
    for (const auto& [name, list] : of_series) {
        add_series(values[name], list);
    }
    return values;
}

VariantOutcome outcome_of(const Ensembles& ensembles, const FigureFrame& frame, const RebuiltSlope& slope,
                          bool with_stand) {
    VariantOutcome outcome;
    outcome.values = values_of(ensembles, frame);
    add_run_out(outcome, ensembles, frame, slope.lower_m() - slope.upper_m());
    if (with_stand) {
        add_hits(outcome, ensembles);
    }
    add_jumps(outcome, ensembles.large, frame.slope_length_m);
    return outcome;
}

}  // namespace coupling::validation
