#include "coupling/assessments/decades/decision/decision.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>

#include "config/random/quantiles.hpp"
#include "coupling/assessments/decades/decision/course_years.hpp"
#include "coupling/assessments/decades/decision/judged_years.hpp"
#include "coupling/assessments/decades/decision/rock_noise.hpp"

namespace coupling::decades {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

bool is_after_start(std::int32_t year) {
    return year > 0;
}

/// The last year stands for `years_beyond` more: who leaves an open slope behind has not kept it.
std::optional<ProtectionRecord> record_of(const std::map<std::int32_t, double>& protection,
                                          const DecisionSettings& settings,
                                          std::span<const std::int32_t> rock_years) {
    const double at_least_percent = settings.protection_at_least_percent;
    ProtectionRecord record{.lowest_percent = std::numeric_limits<double>::infinity()};
    double years = 0.0;
    for (const auto& [year, protection_percent] : protection) {
        if (!is_after_start(year)) {
            continue;
        }
        years += 1.0;
        record.mean_percent += protection_percent;
        record.lowest_percent = std::min(record.lowest_percent, protection_percent);
        if (protection_percent < at_least_percent) {
            const auto next = std::lower_bound(rock_years.begin(), rock_years.end(), year);
            const double stands_for = year - (next == rock_years.begin() ? 0 : *std::prev(next));
            record.years_below += stands_for;
            const double beyond = year == protection.rbegin()->first ? settings.years_beyond : 0.0;
            record.percent_years_lost += (at_least_percent - protection_percent) * (stands_for + beyond);
        }
    }
    if (years == 0.0) {
        return std::nullopt;
    }
    record.mean_percent /= years;
    return record;
}

/// The year after the start with the lowest mean over replicates.
std::optional<Extreme> lowest_year(const Series& protection, std::size_t course) {
    std::optional<Extreme> lowest;
    for (const std::int32_t year : years_of(protection)) {
        const auto here = is_after_start(year) ? over_replicates(protection, course, year) : std::nullopt;
        if (here && (!lowest || here->band.mean < lowest->value.band.mean)) {
            lowest = {year, *here};
        }
    }
    return lowest;
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

template <class Of>
Band band_over(const std::vector<std::optional<ProtectionRecord>>& records, Of of) {
    std::vector<double> values;
    for (const auto& record : records) {
        if (record) {
            values.push_back(of(*record));
        }
    }
    return values.empty() ? Band{unknown, unknown, unknown, unknown, unknown, unknown, unknown}
                          : band_of(std::move(values), not_negative);
}

Lowest lowest_over(const std::vector<std::optional<ProtectionRecord>>& records) {
    Lowest lowest;
    double squares = 0.0;
    for (const auto& record : records) {
        if (record) {
            ++lowest.replicates;
            const double off = record->lowest_percent - lowest.mean_percent;
            lowest.mean_percent += off / static_cast<double>(lowest.replicates);
            squares += off * (record->lowest_percent - lowest.mean_percent);
        }
    }
    lowest.deviation_percent =
        lowest.replicates > 1 ? std::sqrt(squares / static_cast<double>(lowest.replicates - 1)) : unknown;
    return lowest;
}

CourseAtTarget at_target_of(const Series& protection, std::size_t course, const Decision& decision,
                            const std::map<std::int32_t, double>& rock_variances,
                            std::span<const std::int32_t> rock_years) {
    const DecisionSettings& settings = decision.settings;
    CourseAtTarget at{.course = course, .target = protection.target};
    const auto keeps = [&](const std::optional<ProtectionRecord>& record) {
        return record && record->lowest_percent >= settings.protection_at_least_percent;
    };
    const auto record = [&](const std::map<std::int32_t, double>& replicate) {
        return record_of(replicate, settings, rock_years);
    };
    std::vector<std::optional<ProtectionRecord>> as_simulated;
    std::transform(protection.values[course].begin(), protection.values[course].end(),
                   std::back_inserter(as_simulated), record);
    const auto without = without_rock_noise(protection.values[course], rock_variances);
    std::transform(without.begin(), without.end(), std::back_inserter(at.records), record);
    const std::size_t shown = years_of(protection).size();  // that of the start too, as in each replicate
    at.has_gaps = std::any_of(protection.values[course].begin(), protection.values[course].end(),
                              [&](const auto& replicate) { return replicate.size() < shown; });
    const auto known = static_cast<std::size_t>(std::count_if(
        as_simulated.begin(), as_simulated.end(), [](const auto& one) { return one.has_value(); }));
    if (known > 0) {
        const auto count = [&](const auto& records) {
            return static_cast<std::size_t>(std::count_if(records.begin(), records.end(), keeps));
        };
        at.kept = kept_share(count(as_simulated), known, decision.chances);
        at.kept_without_noise = kept_share(count(at.records), known, decision.chances);
    }
    at.lowest_of_replicates = lowest_over(as_simulated);
    at.years_below = band_over(at.records, [](const ProtectionRecord& r) { return r.years_below; });
    at.percent_years_lost =
        band_over(at.records, [](const ProtectionRecord& r) { return r.percent_years_lost; });
    at.lowest = lowest_year(protection, course);
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

const Series* find(std::span<const Series> all_series, const std::string& quantity) {
    const auto found = std::find_if(all_series.begin(), all_series.end(), [&](const Series& series) {
        return series.target.empty() && series.quantity == quantity;
    });
    return found == all_series.end() ? nullptr : &*found;
}

/// Sums over the years of each replicate, each year times its factor.
template <class Factor>
std::vector<double> sums_of(const Series* series, std::size_t course, Factor factor) {
    std::vector<double> sums;
    for (const auto& replicate :
         series != nullptr ? series->values[course] : std::vector<std::map<std::int32_t, double>>{}) {
        double sum = 0.0;
        for (const auto& [year, value] : replicate) {
            sum += factor(year) * value;
        }
        sums.push_back(sum);
    }
    return sums;
}

Band known_band(const std::vector<double>& values, const Bounds& bounds) {
    return values.empty() ? Band{unknown, unknown, unknown, unknown, unknown, unknown, unknown}
                          : band_of(values, bounds);
}

CourseMoney money_of(std::span<const Series> series, std::size_t course, const DecisionSettings& settings) {
    const Series* margin = find(series, "contribution_margin_eur_pha");
    const Series* removed = find(series, "removed_m3pha");
    const auto years = margin != nullptr ? years_of(*margin) : std::vector<std::int32_t>{};
    const double last = years.empty() ? 1.0 : std::max(1.0, static_cast<double>(years.back()));
    const auto a_year = [&](std::int32_t) { return 1.0 / last; };
    CourseMoney money{.course = course};
    const auto discounted = [&](std::int32_t year) {
        return std::pow(1.0 + settings.discount_percent / 100.0, -static_cast<double>(year));
    };
    const std::vector<double> work = sums_of(margin, course, discounted);
    const auto end = static_cast<std::int32_t>(last);
    std::vector<double> stock =
        sums_of(find(series, "standing_value_eur_pha"), course, [&](std::int32_t year) {
            return year == end ? discounted(year) : year == 0 ? -1.0 : 0.0;
        });
    stock.resize(work.size(), 0.0);
    money.work_value_eur_pha = known_band(work, {});
    money.stock_value_eur_pha = known_band(stock, {});
    std::transform(work.begin(), work.end(), stock.begin(), std::back_inserter(money.present_values_eur_pha),
                   std::plus<>{});
    money.present_value_eur_pha = known_band(money.present_values_eur_pha, {});
    money.net_eur_pha_a_year = known_band(sums_of(margin, course, a_year), {});
    money.removed_m3pha_a_year = known_band(sums_of(removed, course, a_year), not_negative);
    return money;
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
    const bool noise_may_be_to_blame = at.worst
                                           ? at.worst->at_most(chances.no) >= settings.probability
                                           : judge(at.kept_without_noise, settings.probability) != Keeps::no;
    if (by_counts == Keeps::no && noise_may_be_to_blame) {
        by_counts = Keeps::undecided;
    }
    // A year that some replicates do not show counts for none of them: as likely as not is no yes.
    if (by_counts == Keeps::yes && at.has_gaps && at.worst && at.worst->median() < settings.probability) {
        by_counts = Keeps::undecided;
    }
    if (by_counts == Keeps::undecided && at.worst &&
        at.worst->at_least(chances.yes) >= settings.probability) {
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
            const auto variances = rock_variances(names, members, course, static_cast<std::uint32_t>(target));
            CourseAtTarget at = at_target_of(*protection[target], course, decision, variances, rock_years);
            at.rock_error_percent = rock_error(names, members, course, static_cast<std::uint32_t>(target));
            at.worst = worst_year(
                course_years(*protection[target], course, static_cast<std::uint32_t>(target), names, members),
                settings.protection_at_least_percent);
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
    for (std::size_t r = 0; r < std::min(a.records.size(), b.records.size()); ++r) {
        if (a.records[r] && b.records[r]) {
            differences.push_back(a.records[r]->percent_years_lost - b.records[r]->percent_years_lost);
        }
    }
    return differences.empty() ? std::nullopt : std::optional{difference_of(differences)};
}

std::optional<PairedDifference> difference_in_value(const CourseMoney& a, const CourseMoney& b) {
    std::vector<double> differences;
    for (std::size_t r = 0; r < std::min(a.present_values_eur_pha.size(), b.present_values_eur_pha.size());
         ++r) {
        differences.push_back(a.present_values_eur_pha[r] - b.present_values_eur_pha[r]);
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
