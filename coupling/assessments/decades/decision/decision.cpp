#include "coupling/assessments/decades/decision/decision.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include "config/random/quantiles.hpp"
#include "coupling/assessments/decades/decision/course_years.hpp"
#include "coupling/assessments/decades/decision/judged_years.hpp"

namespace coupling::decades {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

bool is_after_start(std::int32_t year) {
    return year > 0;
}

/// The lowest year after the start of each replicate, as simulated.
std::vector<double> lowest_of_replicates(const Series& protection, std::size_t course) {
    std::vector<double> lowest;
    for (const auto& replicate : protection.values[course]) {
        std::optional<double> here;
        for (const auto& [year, percent] : replicate) {
            if (is_after_start(year)) {
                here = std::min(here.value_or(percent), percent);
            }
        }
        if (here) {
            lowest.push_back(*here);
        }
    }
    return lowest;
}

/// Rocks that arrive over the bare slope in all years after the start, by replicate; nothing where that is
/// not known.
std::vector<double> weights_of(const Series& protection, std::size_t course) {
    std::vector<double> weights;
    for (std::size_t r = 0; r < (protection.weights.empty() ? 0 : protection.weights[course].size()); ++r) {
        weights.push_back(0.0);
        for (const auto& [year, weight] : protection.weights[course][r]) {
            weights.back() += is_after_start(year) ? weight : 0.0;
        }
    }
    return weights;
}

double rock_error(const Names& names, std::span<const MemberYears> members, std::size_t course,
                  std::uint32_t target) {
    std::vector<double> halves;
    for (const MemberYears& member : members) {
        if (names.course_of(member.member) != course) {
            continue;
        }
        for (const TargetRow& row : member.targets) {
            const auto effect = row.target == target && is_after_start(row.year)
                                    ? protection_effect(row.paired)
                                    : std::nullopt;
            if (effect && effect->interval.low <= effect->interval.high) {
                halves.push_back(50.0 * (effect->interval.high - effect->interval.low));
            }
        }
    }
    if (halves.empty()) {
        return unknown;
    }
    const auto middle = halves.begin() + static_cast<std::ptrdiff_t>(halves.size() / 2);
    std::nth_element(halves.begin(), middle, halves.end());
    return *middle;
}

Lowest lowest_over(const std::vector<double>& lowest_percent) {
    Lowest lowest;
    double squares = 0.0;
    for (const double percent : lowest_percent) {
        ++lowest.replicates;
        const double off = percent - lowest.mean_percent;
        lowest.mean_percent += off / static_cast<double>(lowest.replicates);
        squares += off * (percent - lowest.mean_percent);
    }
    lowest.deviation_percent =
        lowest.replicates > 1 ? std::sqrt(squares / static_cast<double>(lowest.replicates - 1)) : unknown;
    return lowest;
}

/// As the replicates were simulated; without what the forest behind its rocks says.
CourseAtTarget as_simulated(const Series& protection, std::size_t course, const Decision& decision) {
    CourseAtTarget at{.course = course, .target = protection.target};
    const std::vector<double> lowest = lowest_of_replicates(protection, course);
    const auto kept = std::count_if(lowest.begin(), lowest.end(), [&](double percent) {
        return percent >= decision.settings.protection_at_least_percent;
    });
    if (!lowest.empty()) {
        at.kept = kept_share(static_cast<std::size_t>(kept), lowest.size(), decision.chances);
    }
    at.lowest_of_replicates = lowest_over(lowest);
    const std::size_t shown = years_of(protection).size();  // that of the start too, as in each replicate
    at.has_gaps = std::any_of(protection.values[course].begin(), protection.values[course].end(),
                              [&](const auto& replicate) { return replicate.size() < shown; });
    return at;
}

/// Years with rocks, whether any arrived or not, rising.
std::vector<std::int32_t> rock_years_in(std::span<const MemberYears> members,
                                        std::span<const Series* const> protection) {
    std::set<std::int32_t> years;
    for (const MemberYears& member : members) {
        for (const TargetRow& row : member.targets) {
            years.insert(row.year);
        }
    }
    for (const Series* series : protection) {
        for (const std::int32_t year : years_of(*series)) {
            years.insert(year);
        }
    }
    return {years.begin(), years.end()};
}

}  // namespace

VerdictChances verdict_chances(std::size_t regimes, std::size_t places) {
    assert(regimes > 0 && places > 0);
    constexpr double together = 0.05;
    const double of_a_regime = together / static_cast<double>(regimes);
    return {of_a_regime, of_a_regime / static_cast<double>(places)};
}

KeptShare kept_share(std::size_t kept, std::size_t replicates, const VerdictChances& chances) {
    assert(replicates > 0 && kept <= replicates);
    const auto n = static_cast<double>(replicates);
    const auto k = static_cast<double>(kept);
    const auto low = [&](double chance) { return config::least_probability(n, k, chance); };
    const auto high = [&](double chance) { return config::greatest_probability(n, k, chance); };
    constexpr double one_side = 0.5 * (1.0 - interval_share);
    return {kept, replicates, low(one_side), high(one_side), low(chances.yes), high(chances.no)};
}

std::size_t least_for_yes(double probability, const VerdictChances& chances) {
    return static_cast<std::size_t>(std::ceil(std::log(chances.yes) / std::log(probability) - 1e-9));
}

Keeps judge(const KeptShare& share, double probability) {
    if (share.replicates == 0) {
        return Keeps::undecided;
    }
    return share.verdict_low >= probability   ? Keeps::yes
           : share.verdict_high < probability ? Keeps::no
                                              : Keeps::undecided;
}

bool is_above(const Lowest& lowest, double at_least_percent, double probability, double chance) {
    constexpr std::size_t least_replicates = 6;
    // Equal replicates (all at 100 %) do not show how much others may differ.
    return lowest.replicates >= least_replicates && lowest.deviation_percent > 0.0 &&
           lowest.mean_percent -
                   config::tolerance_factor(static_cast<double>(lowest.replicates), probability, chance) *
                       lowest.deviation_percent >=
               at_least_percent;
}

Keeps judge(const CourseAtTarget& at, const DecisionSettings& settings, const VerdictChances& chances) {
    Keeps by_counts = judge(at.kept, settings.probability);
    const bool noise_may_be_to_blame =
        at.forest.worst && at.forest.worst->at_most(chances.no) >= settings.probability;
    const WorstYear* worst = at.worst();
    if (by_counts == Keeps::no && noise_may_be_to_blame) {
        by_counts = Keeps::undecided;
    }
    // A year that some replicates do not show counts for none of them: as likely as not is no yes.
    if (by_counts == Keeps::yes && at.has_gaps && worst != nullptr &&
        worst->median() < settings.probability) {
        by_counts = Keeps::undecided;
    }
    if (by_counts == Keeps::undecided && worst != nullptr &&
        worst->at_least(chances.yes) >= settings.probability) {
        return Keeps::yes;
    }
    const bool all_keep = at.kept.replicates > 0 && at.kept.kept == at.kept.replicates;
    return by_counts == Keeps::undecided && all_keep &&
                   is_above(at.lowest_of_replicates, settings.protection_at_least_percent,
                            settings.probability, chances.yes)
               ? Keeps::yes
               : by_counts;
}

Keeps both(Keeps a, Keeps b) {
    if (a == Keeps::no || b == Keeps::no) {
        return Keeps::no;
    }
    return a == Keeps::yes && b == Keeps::yes ? Keeps::yes : Keeps::undecided;
}

std::optional<std::size_t> replicates_to_judge(const KeptShare& share, double probability,
                                               const VerdictChances& chances) {
    constexpr std::size_t most = 5000;
    if (share.replicates == 0 || share.value() == probability) {
        return std::nullopt;
    }
    for (std::size_t n = 2; n <= most; n += n < 100 ? 1 : n / 50) {
        // Rounded to the side that decides less.
        const double expected = share.value() * static_cast<double>(n);
        const auto kept = static_cast<std::size_t>(share.value() > probability ? std::floor(expected + 1e-9)
                                                                               : std::ceil(expected - 1e-9));
        if (judge(kept_share(kept, n, chances), probability) != Keeps::undecided) {
            return n;
        }
    }
    return std::nullopt;
}

const CourseAtTarget* Decision::find(std::size_t course, const std::string& target) const {
    const auto found = std::find_if(at_targets.begin(), at_targets.end(), [&](const CourseAtTarget& at) {
        return at.course == course && at.target == target;
    });
    return found == at_targets.end() ? nullptr : &*found;
}

Keeps Decision::at_target(const Names& names, const CourseAtTarget& at) const {
    const std::size_t regime = names.regime_of(at.course);
    const bool is_judged = regime >= unjudged_cuts.size() || unjudged_cuts[regime].empty();
    const Keeps keeps = judge(at, settings, chances);
    return is_judged ? keeps : both(keeps, Keeps::undecided);
}

Keeps Decision::of_course(std::size_t course) const {
    Keeps keeps = Keeps::yes;
    for (const CourseAtTarget& at : at_targets) {
        if (at.course == course) {
            keeps = both(keeps, judge(at, settings, chances));
        }
    }
    return keeps;
}

Keeps Decision::of_regime(const Names& names, std::size_t regime) const {
    Keeps keeps = Keeps::yes;
    for (std::size_t climate = 0; climate < names.climates.size(); ++climate) {
        keeps = both(keeps, of_course(names.course(regime, climate)));
    }
    const bool is_judged = regime >= unjudged_cuts.size() || unjudged_cuts[regime].empty();
    return is_judged ? keeps : both(keeps, Keeps::undecided);
}

double Decision::present_value_of(const Names& names, std::size_t regime) const {
    double sum = 0.0;
    for (std::size_t climate = 0; climate < names.climates.size(); ++climate) {
        sum += money[names.course(regime, climate)].present_value_eur_pha.mean;
    }
    return sum / static_cast<double>(names.climates.size());
}

std::vector<std::size_t> Decision::keeping(const Names& names) const {
    std::vector<std::size_t> regimes;
    for (std::size_t regime = 0; regime < names.regimes.size(); ++regime) {
        if (of_regime(names, regime) == Keeps::yes) {
            regimes.push_back(regime);
        }
    }
    std::stable_sort(regimes.begin(), regimes.end(), [&](std::size_t a, std::size_t b) {
        return present_value_of(names, a) > present_value_of(names, b);
    });
    return regimes;
}

std::optional<Decision> decide(const Names& names, std::span<const Series> series,
                               std::span<const MemberYears> members, const DecisionSettings& settings) {
    Decision decision{.settings = settings};
    decision.first_year = std::numeric_limits<std::int32_t>::max();
    bool any = false;
    std::vector<const Series*> protection;
    for (const Series& each : series) {
        if (each.quantity != "protection_percent") {
            continue;
        }
        protection.push_back(&each);
        for (const std::int32_t year : years_of(each)) {
            if (is_after_start(year)) {
                any = true;
                decision.first_year = std::min(decision.first_year, year);
                decision.last_year = std::max(decision.last_year, year);
            }
        }
    }
    if (!any) {
        return std::nullopt;
    }
    const std::vector<std::int32_t> rock_years = rock_years_in(members, protection);
    decision.chances = verdict_chances(names.regimes.size(), names.climates.size() * protection.size());
    for (std::size_t course = 0; course < names.courses(); ++course) {
        for (std::size_t target = 0; target < protection.size(); ++target) {
            const auto number = static_cast<std::uint32_t>(target);
            CourseAtTarget at = as_simulated(*protection[target], course, decision);
            at.rock_error_percent = rock_error(names, members, course, number);
            at.forest = drawn_protection(course_years(*protection[target], course, number, names, members),
                                         weights_of(*protection[target], course), settings, rock_years);
            decision.at_targets.push_back(std::move(at));
        }
        decision.money.push_back(money_of(series, course, settings));
    }
    // A year in which too few rocks arrive for a figure judges no cut.
    std::vector<std::int32_t> shown_years = protection.empty() ? rock_years : years_of(*protection.front());
    for (const Series* each : protection) {
        std::vector<std::int32_t> common;
        const std::vector<std::int32_t> own = years_of(*each);
        std::set_intersection(shown_years.begin(), shown_years.end(), own.begin(), own.end(),
                              std::back_inserter(common));
        shown_years = std::move(common);
    }
    for (std::size_t regime = 0; regime < names.regimes.size(); ++regime) {
        decision.unjudged_cuts.push_back(unjudged_cuts(names, members, regime, shown_years));
    }
    return decision;
}

std::optional<PairedDifference> difference_in_percent_years(const CourseAtTarget& a,
                                                            const CourseAtTarget& b) {
    std::vector<double> differences;
    for (std::size_t r = 0; r < std::min(a.forest.records.size(), b.forest.records.size()); ++r) {
        if (a.forest.records[r] && b.forest.records[r]) {
            differences.push_back(a.forest.records[r]->percent_years_lost() -
                                  b.forest.records[r]->percent_years_lost());
        }
    }
    return differences.empty() ? std::nullopt : std::optional{difference_of(differences)};
}

std::optional<PairedDifference> difference_in_value(const Decision& decision, const Names& names,
                                                    std::size_t regime, std::size_t reference) {
    std::vector<double> differences;
    for (std::size_t climate = 0; climate < names.climates.size(); ++climate) {
        const auto& a = decision.money[names.course(regime, climate)].present_values_eur_pha;
        const auto& b = decision.money[names.course(reference, climate)].present_values_eur_pha;
        const std::size_t pairs = std::min(a.size(), b.size());
        differences.resize(climate == 0 ? pairs : std::min(pairs, differences.size()));
        for (std::size_t r = 0; r < differences.size(); ++r) {
            differences[r] += (a[r] - b[r]) / static_cast<double>(names.climates.size());
        }
    }
    return differences.empty() ? std::nullopt : std::optional{difference_of(differences)};
}

}  // namespace coupling::decades
