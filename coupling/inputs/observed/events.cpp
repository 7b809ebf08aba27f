#include "coupling/inputs/observed/events.hpp"

#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/inputs/observed/distribution.hpp"

namespace coupling::observed {
namespace {

using config::joined;

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

SampleFigures figures_of_sample(const Distribution& sample) {
    SampleFigures figures;
    figures.count = sample.count();
    figures.mean = sample.mean();
    figures.deviation = sample.deviation();
    for (std::size_t i = 0; i < quantile_shares.size(); ++i) {
        figures.quantiles[i] = sample.quantile(quantile_shares[i]);
    }
    figures.largest = sample.quantile(1.0);
    return figures;
}

/// Nothing where either side has no value.
std::optional<EventComparison> compare_samples(EventComparison head, std::vector<double> seen,
                                               std::vector<double> simulated) {
    if (seen.empty() || simulated.empty()) {
        return std::nullopt;
    }
    const Distribution of_seen{std::move(seen)};
    const Distribution of_simulated{std::move(simulated)};
    head.observed = figures_of_sample(of_seen);
    head.simulated = figures_of_sample(of_simulated);
    head.largest_distance = largest_distance(of_seen, of_simulated);
    head.distance_by_chance = distance_by_chance(of_seen.count(), of_simulated.count());
    head.energy_distance = energy_distance(of_seen, of_simulated);
    return head;
}

SampleFigures share_of_rocks(std::size_t count, std::uint64_t rocks) {
    SampleFigures figures;
    figures.count = count;
    figures.mean = static_cast<double>(count) / static_cast<double>(rocks);
    figures.deviation = not_known;
    figures.quantiles.fill(not_known);
    figures.largest = not_known;
    return figures;
}

/// The groups of a list, "" for all first; no others where all bear one name.
template <class Event>
std::vector<std::string> groups_in(std::span<const Event> events) {
    std::set<std::string> names;
    for (const Event& event : events) {
        names.insert(event.group);
    }
    std::vector<std::string> groups{""};
    if (names.size() > 1) {
        names.erase("");
        groups.insert(groups.end(), names.begin(), names.end());
    }
    return groups;
}

struct PassageQuantity {
    const char* name;
    const char* unit;
    std::optional<double> ObservedPassage::*seen;
    double SimulatedPassage::*simulated;
};
constexpr std::array passage_quantities{
    PassageQuantity{"speed_mps", "m/s", &ObservedPassage::speed_mps, &SimulatedPassage::speed_mps},
    PassageQuantity{"height_m", "m", &ObservedPassage::height_m, &SimulatedPassage::height_m},
    PassageQuantity{"energy_kj", "kJ", &ObservedPassage::energy_kj, &SimulatedPassage::energy_kj},
    PassageQuantity{"translational_kj", "kJ", &ObservedPassage::translational_kj,
                    &SimulatedPassage::translational_kj},
};

void compare_at_target(std::uint32_t target, const std::string& name, const ObservedEvents& observed,
                       std::span<const SimulatedPassage> simulated, std::uint64_t rocks,
                       std::vector<EventComparison>& comparisons) {
    std::vector<ObservedPassage> here;
    for (const ObservedPassage& passage : observed.passages) {
        if (passage.target == target) {
            here.push_back(passage);
        }
    }
    if (here.empty()) {
        return;
    }
    std::vector<SimulatedPassage> there;
    for (const SimulatedPassage& passage : simulated) {
        if (passage.target == target) {
            there.push_back(passage);
        }
    }
    EventComparison head{.kind = EventComparison::Kind::passage, .place = name};
    if (observed.rocks > 0 && rocks > 0) {
        EventComparison share = head;
        share.quantity = "passing_share";
        share.unit = "-";
        share.observed = share_of_rocks(here.size(), observed.rocks);
        share.simulated = share_of_rocks(there.size(), rocks);
        share.largest_distance = share.distance_by_chance = share.energy_distance = not_known;
        comparisons.push_back(std::move(share));
    }
    for (const std::string& group : groups_in(std::span<const ObservedPassage>{here})) {
        for (const PassageQuantity& quantity : passage_quantities) {
            std::vector<double> seen;
            for (const ObservedPassage& passage : here) {
                if ((group.empty() || passage.group == group) && passage.*quantity.seen) {
                    seen.push_back(*(passage.*quantity.seen));
                }
            }
            std::vector<double> fallen;
            for (const SimulatedPassage& passage : there) {
                fallen.push_back(passage.*quantity.simulated);
            }
            head.group = group;
            head.quantity = quantity.name;
            head.unit = quantity.unit;
            if (auto one = compare_samples(head, std::move(seen), std::move(fallen))) {
                comparisons.push_back(std::move(*one));
            }
        }
    }
}

struct ImpactQuantity {
    const char* name;
    const char* unit;
    std::function<std::optional<double>(const ObservedImpact&)> seen;
    std::function<std::optional<double>(const SimulatedImpact&)> simulated;
};

const std::vector<ImpactQuantity>& impact_quantities() {
    using Value = std::optional<double>;
    static const std::vector<ImpactQuantity> quantities{
        {"speed_in_mps", "m/s", [](const ObservedImpact& i) { return i.speed_in_mps; },
         [](const SimulatedImpact& i) { return Value{i.speed_in_mps}; }},
        {"angle_in_deg", "deg", [](const ObservedImpact& i) { return i.angle_in_deg; },
         [](const SimulatedImpact& i) { return Value{i.angle_in_deg}; }},
        {"speed_ratio", "-",
         [](const ObservedImpact& i) {
             return i.speed_in_mps && i.speed_out_mps && *i.speed_in_mps > 0.0
                        ? Value{*i.speed_out_mps / *i.speed_in_mps}
                        : Value{};
         },
         [](const SimulatedImpact& i) {
             return i.speed_in_mps > 0.0 ? Value{i.speed_out_mps / i.speed_in_mps} : Value{};
         }},
        {"angle_out_deg", "deg",
         [](const ObservedImpact& i) {
             return i.speed_out_mps && *i.speed_out_mps <= 0.0 ? Value{} : i.angle_out_deg;
         },
         [](const SimulatedImpact& i) { return i.speed_out_mps > 0.0 ? Value{i.angle_out_deg} : Value{}; }},
    };
    return quantities;
}

/// The codes of the grounds that impacts name; none where any of them names no ground.
std::set<int> grounds_of(std::span<const ObservedImpact> impacts) {
    std::set<int> codes;
    for (const ObservedImpact& impact : impacts) {
        if (!impact.ground) {
            return {};
        }
        codes.insert(*impact.ground);
    }
    return codes;
}

}  // namespace

std::string EventComparison::name() const {
    std::string text = joined(kind == Kind::passage ? "passage." : "impact.", quantity);
    if (!place.empty()) {
        text += joined(":", place);
    }
    return group.empty() ? text : joined(text, ":", group);
}

std::vector<EventComparison> compare_passages(const ObservedEvents& observed,
                                              std::span<const SimulatedPassage> simulated,
                                              std::span<const std::string> names, std::uint64_t rocks) {
    std::vector<EventComparison> comparisons;
    for (std::size_t target = 0; target < names.size(); ++target) {
        compare_at_target(static_cast<std::uint32_t>(target), names[target], observed, simulated, rocks,
                          comparisons);
    }
    return comparisons;
}

std::vector<EventComparison> compare_impacts(std::span<const ObservedImpact> observed,
                                             std::span<const SimulatedImpact> simulated) {
    std::vector<EventComparison> comparisons;
    for (const std::string& group : groups_in(observed)) {
        std::vector<ObservedImpact> members;
        for (const ObservedImpact& impact : observed) {
            if (group.empty() || impact.group == group) {
                members.push_back(impact);
            }
        }
        const std::set<int> grounds = grounds_of(members);
        for (const ImpactQuantity& quantity : impact_quantities()) {
            std::vector<double> seen;
            for (const ObservedImpact& impact : members) {
                if (const auto value = quantity.seen(impact)) {
                    seen.push_back(*value);
                }
            }
            std::vector<double> fallen;
            for (const SimulatedImpact& impact : simulated) {
                if (const auto value = quantity.simulated(impact);
                    value && (grounds.empty() || grounds.contains(impact.ground))) {
                    fallen.push_back(*value);
                }
            }
            EventComparison head{.kind = EventComparison::Kind::impact,
                                 .group = group,
                                 .quantity = quantity.name,
                                 .unit = quantity.unit};
            if (auto one = compare_samples(std::move(head), std::move(seen), std::move(fallen))) {
                comparisons.push_back(std::move(*one));
            }
        }
    }
    return comparisons;
}

}  // namespace coupling::observed
