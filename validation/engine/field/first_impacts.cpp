#include "validation/engine/field/first_impacts.hpp"

#include <cmath>

#include "config/text/joined.hpp"
#include "config/units/angle.hpp"
#include "coupling/inputs/observed/distribution.hpp"

namespace coupling::validation {
namespace {

using config::joined;

struct RatioName {
    const char* figure;
    const char* label;
};
constexpr RatioName normal_name{"first_normal_ratio", "normal restitution"};
constexpr RatioName tangential_name{"first_tangential_ratio", "tangential restitution"};

/// Below this speed along the face a ratio means nothing.
constexpr double least_along_mps = 0.5;

void name_ratio(const RatioName& ratio, const std::string& state, const std::string& meaning,
                Comparison& comparison) {
    const auto add = [&](const char* part, const char* in_words) {
        comparison.figures.push_back({joined(ratio.figure, part, ":", state),
                                      joined(ratio.label, in_words, ", first impact, ", meaning), "-"});
    };
    add("_mean", "");
    add("_p10", ", 10 %");
    add("_p90", ", 90 %");
}

void take_ratio(const RatioName& ratio, const std::string& state, const std::vector<double>& values,
                Outcome& outcome) {
    if (values.empty()) {
        return;
    }
    constexpr double low_share = 0.1;
    constexpr double high_share = 0.9;
    const observed::Distribution distribution{values};
    outcome.values[joined(ratio.figure, "_mean:", state)] = distribution.mean();
    outcome.values[joined(ratio.figure, "_p10:", state)] = distribution.quantile(low_share);
    outcome.values[joined(ratio.figure, "_p90:", state)] = distribution.quantile(high_share);
}

}  // namespace

FirstImpacts first_impacts_of(std::span<const rockfall::RockImpacts> rocks, rockfall::Cover cover) {
    FirstImpacts first;
    for (const rockfall::RockImpacts& rock : rocks) {
        if (rock.cover != cover || rock.impacts.empty()) {
            continue;
        }
        const rockfall::GroundImpact& impact = rock.impacts.front();
        const rockfall::Speeds& in = impact.before;
        if (!(in.normal_mps > 0.0)) {
            continue;
        }
        first.normal_ratios.push_back(impact.after.normal_mps / in.normal_mps);
        if (in.along_mps >= least_along_mps) {
            first.tangential_ratios.push_back(impact.after.along_mps / in.along_mps);
        }
        first.angles_in_deg.push_back(
            config::Angle::from_radians(std::atan2(in.normal_mps, in.along_mps)).in_degrees());
        first.speeds_in_mps.push_back(in.whole_mps());
    }
    return first;
}

void name_first_impacts(const std::string& state, const std::string& meaning, Comparison& comparison) {
    name_ratio(normal_name, state, meaning, comparison);
    name_ratio(tangential_name, state, meaning, comparison);
    comparison.figures.push_back(
        {joined("first_angle_in_deg:", state), joined("angle to the face, first impact, ", meaning), "deg"});
    comparison.figures.push_back(
        {joined("first_speed_in_mps:", state), joined("speed before the first impact, ", meaning), "m/s"});
}

void take_first_impacts(const std::string& state, const FirstImpacts& impacts, Outcome& outcome) {
    take_ratio(normal_name, state, impacts.normal_ratios, outcome);
    take_ratio(tangential_name, state, impacts.tangential_ratios, outcome);
    if (!impacts.angles_in_deg.empty()) {
        outcome.values[joined("first_angle_in_deg:", state)] =
            observed::Distribution{impacts.angles_in_deg}.mean();
        outcome.values[joined("first_speed_in_mps:", state)] =
            observed::Distribution{impacts.speeds_in_mps}.mean();
    }
}

}  // namespace coupling::validation
