#include "coupling/assessments/decades/tables/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <set>

#include "config/random/quantiles.hpp"
#include "config/text/joined.hpp"
#include "coupling/assessments/decades/tables/indicator_series.hpp"
#include "coupling/assessments/decades/tables/profile_tables.hpp"
#include "coupling/assessments/decades/tables/yearly_work.hpp"
#include "coupling/inputs/forest/forest_site.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/figures/ratio_parts.hpp"
#include "coupling/results/figures/stop_causes.hpp"

namespace coupling::decades {
namespace {

using config::joined;

/// Rocks that arrive at a target over the bare slope, over the replicates of a course in a year.
using BareArrivals = std::map<std::pair<std::size_t, std::int32_t>, std::uint64_t>;

BareArrivals bare_arrivals(const Names& names, std::span<const MemberYears> members, std::uint32_t target) {
    BareArrivals sums;
    for (const MemberYears& member : members) {
        for (const TargetRow& row : member.targets) {
            if (row.target == target) {
                sums[{names.course_of(member.member), row.year}] += row.paired.bare();
            }
        }
    }
    return sums;
}

void add_targets(std::vector<Series>& all_series, const Names& names, const Site& site,
                 std::span<const MemberYears> members) {
    const auto of_member = [&](Series& series, const MemberYears& member) -> std::map<std::int32_t, double>& {
        return values_of(series, names, member);
    };
    for (std::uint32_t t = 0; t < site.targets.size(); ++t) {
        const std::string& id = site.targets[t].id;
        Series protection = empty_ratio(names, members, "protection_percent", id, true);
        Series reached = empty_series(names, members, "reached_percent", id, false);
        Series energy = empty_series(names, members, "energy_95_kj", id, false);
        const BareArrivals arrivals = bare_arrivals(names, members, t);
        for (const MemberYears& member : members) {
            const std::size_t course = names.course_of(member.member);
            for (const TargetRow& row : member.targets) {
                if (row.target != t) {
                    continue;
                }
                const auto effect = protection_effect(row.paired);
                if (effect && !too_few_for_protection(arrivals.at({course, row.year}))) {
                    set_ratio(protection, names, member, row.year, 100.0 * effect->value,
                              static_cast<double>(row.paired.bare()));
                }
                of_member(reached, member)[row.year] = 100.0 * row.forest.share.value;
                if (!std::isnan(row.forest.energy_kj.p95)) {
                    of_member(energy, member)[row.year] = row.forest.energy_kj.p95;
                }
            }
        }
        protection.has_worst = reached.has_worst = true;
        all_series.push_back(std::move(protection));
        all_series.push_back(std::move(reached));
        all_series.push_back(std::move(energy));
    }
}

void add_causes(std::vector<Series>& all_series, const Names& names, std::span<const MemberYears> members) {
    const auto of_member = [&](Series& series, const MemberYears& member) -> std::map<std::int32_t, double>& {
        return values_of(series, names, member);
    };
    for (std::size_t cause = 0; cause < stop_causes; ++cause) {
        const auto kind = static_cast<StopCause>(cause);
        const bool stops = kind < StopCause::left_terrain;
        Series series = empty_series(
            names, members, joined(stops ? "stopped_by_" : "", name_of(kind), "_percent"), "", stops);
        for (const MemberYears& member : members) {
            for (const SlopeRow& slope : member.slopes) {
                if (slope.cover == Cover::forest && slope.figures.rocks > 0) {
                    of_member(series, member)[slope.year] =
                        100.0 * shares_by_cause(slope.figures)[cause].value;
                }
            }
        }
        if (!years_of(series).empty()) {
            all_series.push_back(std::move(series));
        }
    }
}

void add_profile(std::vector<Series>& all_series, const Names& names, std::span<const MemberYears> members,
                 const std::optional<forest::TargetProfile>& profile) {
    const auto of_member = [&](Series& series, const MemberYears& member) -> std::map<std::int32_t, double>& {
        return values_of(series, names, member);
    };
    Series gap_95 = empty_series(names, members, "gap_95_m", "", false);
    Series gap_max = empty_series(names, members, "gap_max_m", "", false);
    Series met = empty_series(names, members, "target_profile_met_percent", "", true);
    for (const MemberYears& member : members) {
        for (const GapRow& gap : member.gaps) {
            if (gap.unit == all) {
                of_member(gap_95, member)[gap.year] = gap.figures.p95_m;
                of_member(gap_max, member)[gap.year] = gap.figures.max_m;
            }
        }
        if (profile) {
            for (const auto& [year, share] : share_met(member, *profile)) {
                of_member(met, member)[year] = 100.0 * share;
            }
        }
    }
    gap_max.has_worst = met.has_worst = true;
    all_series.push_back(std::move(gap_95));
    all_series.push_back(std::move(gap_max));
    if (profile) {
        all_series.push_back(std::move(met));
    }
}

void add_forest(std::vector<Series>& all_series, const Names& names, std::span<const MemberYears> members) {
    const auto of_member = [&](Series& series, const MemberYears& member) -> std::map<std::int32_t, double>& {
        return values_of(series, names, member);
    };
    Series basal_area = empty_series(names, members, "basal_area_m2pha", "", true);
    Series volume = empty_series(names, members, "volume_m3pha", "", true);
    Series stems = empty_series(names, members, "stems_pha", "", true);
    for (const MemberYears& member : members) {
        for (const StandRow& row : member.stands) {
            if (row.unit == all && row.species == all) {
                of_member(basal_area, member)[row.year] = row.figures.basal_area_m2pha;
                of_member(volume, member)[row.year] = row.figures.volume_m3pha;
                of_member(stems, member)[row.year] = row.figures.stems_pha;
            }
        }
    }
    basal_area.has_worst = true;
    for (Series* series : {&basal_area, &volume, &stems}) {
        all_series.push_back(std::move(*series));
    }
}

/// Timber and money.
void add_work(std::vector<Series>& all_series, const Names& names, std::span<const MemberYears> members,
              double area_ha) {
    const auto of_member = [&](Series& series, const MemberYears& member) -> std::map<std::int32_t, double>& {
        return values_of(series, names, member);
    };
    for (const WorkFigure& figure : work_figures()) {
        Series series = empty_series(names, members, figure.quantity, "", false);
        for (const MemberYears& member : members) {
            const std::vector<YearlyWork> work = work_by_year(names, member, area_ha);
            for (std::size_t year = 0; year < work.size(); ++year) {
                of_member(series, member)[static_cast<std::int32_t>(year)] = figure.of(work[year]);
            }
        }
        all_series.push_back(std::move(series));
    }
}

}  // namespace

Series empty_series(const Names& names, std::span<const MemberYears> members, std::string quantity,
                    std::string target, bool low_is_bad) {
    Series series{std::move(quantity), std::move(target), low_is_bad, false, {}};
    series.values.resize(names.courses());
    for (const MemberYears& member : members) {
        auto& replicates = series.values[names.course_of(member.member)];
        replicates.resize(std::max<std::size_t>(replicates.size(), member.member.replicate + 1));
    }
    return series;
}

std::map<std::int32_t, double>& values_of(Series& series, const Names& names, const MemberYears& member) {
    return series.values[names.course_of(member.member)][member.member.replicate];
}

Series empty_ratio(const Names& names, std::span<const MemberYears> members, std::string quantity,
                   std::string target, bool low_is_bad) {
    Series series = empty_series(names, members, std::move(quantity), std::move(target), low_is_bad);
    series.weights = series.values;
    return series;
}

void set_ratio(Series& series, const Names& names, const MemberYears& member, std::int32_t year, double value,
               double weight) {
    values_of(series, names, member)[year] = value;
    series.weights[names.course_of(member.member)][member.member.replicate][year] = weight;
}

std::vector<Series> series_of(const Names& names, const Site& site, std::span<const MemberYears> members,
                              const std::optional<forest::TargetProfile>& profile) {
    std::vector<Series> all_series;
    add_targets(all_series, names, site, members);
    add_living(all_series, names, site, members);
    add_causes(all_series, names, members);
    add_forest(all_series, names, members);
    if (site.forest) {
        add_work(all_series, names, members, site.forest->grid.area_ha());
    }
    add_profile(all_series, names, members, profile);
    add_indicators(all_series, names, members);
    return all_series;
}

std::vector<std::int32_t> years_of(const Series& series) {
    std::set<std::int32_t> years;
    for (const auto& replicates : series.values) {
        for (const auto& values : replicates) {
            for (const auto& [year, value] : values) {
                years.insert(year);
            }
        }
    }
    return {years.begin(), years.end()};
}

namespace {

/// Values of the replicates of a course in a year, those of `also` alone where given.
struct OfReplicates {
    std::vector<double> values, weights;
};

OfReplicates of_replicates(const Series& series, std::size_t course, std::int32_t year,
                           std::optional<std::size_t> also = {}) {
    OfReplicates found;
    for (std::size_t r = 0; r < series.values[course].size(); ++r) {
        const auto& replicate = series.values[course][r];
        const auto value = replicate.find(year);
        const bool is_in_other =
            !also || (r < series.values[*also].size() && series.values[*also][r].contains(year));
        if (value != replicate.end() && is_in_other) {
            found.values.push_back(value->second);
            if (!series.weights.empty()) {
                found.weights.push_back(series.weights[course][r].at(year));
            }
        }
    }
    return found;
}

/// What the replicates bring to the mean.
std::vector<double> parts_of(const OfReplicates& of) {
    return of.weights.empty() || of.values.empty() ? of.values : parts_of_ratio(of.values, of.weights);
}

}  // namespace

std::optional<OverReplicates> over_replicates(const Series& series, std::size_t course, std::int32_t year) {
    const OfReplicates of = of_replicates(series, course, year);
    if (of.values.empty()) {
        return std::nullopt;
    }
    const Bounds bounds = bounds_of(series);
    Band band = band_of(of.values, bounds);
    if (!of.weights.empty()) {
        const Band of_mean = band_of(parts_of(of), bounds);
        band.mean = of_mean.mean;
        band.low = of_mean.low;
        band.high = of_mean.high;
    }
    return OverReplicates{of.values.size(), band};
}

Series as_parts(const Series& series) {
    Series parts = series;
    for (std::size_t course = 0; course < parts.values.size() && !series.weights.empty(); ++course) {
        for (const std::int32_t year : years_of(series)) {
            const std::vector<double> in_year = parts_of(of_replicates(series, course, year));
            auto next = in_year.begin();
            for (auto& replicate : parts.values[course]) {
                if (const auto found = replicate.find(year); found != replicate.end()) {
                    found->second = *next++;
                }
            }
        }
    }
    parts.weights.clear();
    return parts;
}

Bounds bounds_of(const Series& series) {
    const std::string& quantity = series.quantity;
    Bounds bounds = not_negative;
    if (quantity.ends_with("_percent")) {
        bounds.high = 100.0;
    }
    if (quantity.starts_with("protection") || quantity.ends_with("_eur_pha")) {
        bounds.low = -std::numeric_limits<double>::infinity();
    }
    return bounds;
}

PairedDifference difference_of(const std::vector<double>& differences) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const auto n = static_cast<double>(differences.size());
    double mean = 0.0;
    for (const double d : differences) {
        mean += d / n;
    }
    PairedDifference found{differences.size(), mean, unknown, unknown, unknown};
    if (differences.size() > 1) {
        double squares = 0.0;
        for (const double d : differences) {
            squares += (d - mean) * (d - mean);
        }
        found.deviation = std::sqrt(squares / (n - 1.0));
        const double error = found.deviation / std::sqrt(n);
        // Equal differences (no rock arrives, say) say nothing about chance: no interval rather than one of
        // no width.
        if (error > 1e-9 * std::abs(mean) && error > 0.0) {
            const double t = config::students_t_quantile(n - 1.0, 0.975);
            found.low = mean - t * error;
            found.high = mean + t * error;
        } else {
            found.deviation = unknown;
        }
    }
    return found;
}

std::optional<PairedDifference> difference(const Series& series, std::size_t course, std::size_t reference,
                                           std::int32_t year) {
    const std::vector<double> here = parts_of(of_replicates(series, course, year, reference));
    const std::vector<double> there = parts_of(of_replicates(series, reference, year, course));
    if (here.empty()) {
        return std::nullopt;
    }
    std::vector<double> differences;
    std::transform(here.begin(), here.end(), there.begin(), std::back_inserter(differences), std::minus<>{});
    return difference_of(differences);
}

std::optional<Extreme> worst_year(const Series& series, std::size_t course) {
    std::optional<Extreme> worst;
    for (const std::int32_t year : years_of(series)) {
        const auto here = over_replicates(series, course, year);
        if (!here) {
            continue;
        }
        const bool is_worse = !worst || (series.low_is_bad ? here->band.mean < worst->value.band.mean
                                                           : here->band.mean > worst->value.band.mean);
        if (is_worse) {
            worst = {year, *here};
        }
    }
    return worst;
}

}  // namespace coupling::decades
