#include "coupling/assessments/decades/risk/risk_over_years.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace coupling::decades {
namespace {

using consequences::Quantities;
using consequences::quantities;
using consequences::Quantity;

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

RiskAtPlace empty_place(std::string id, const Names& names, std::span<const MemberYears> members) {
    RiskAtPlace place{std::move(id), {}};
    for (auto& of_cover : place.values) {
        of_cover.resize(names.courses());
        for (const MemberYears& member : members) {
            auto& replicates = of_cover[names.course_of(member.member)];
            replicates.resize(std::max<std::size_t>(replicates.size(), member.member.replicate + 1));
        }
    }
    return place;
}

void add(Quantities& to, const Quantities& more) {
    for (std::size_t q = 0; q < quantities; ++q) {
        to[q] += more[q];
    }
}

/// What these rocks do, each standing for `weight` rocks a year.
Quantities risk_of_rocks(std::span<const exchange::RockAtTarget> rocks, double weight,
                         const TargetExposure& exposure, const consequences::RiskPlan& plan) {
    constexpr double j_per_kj = 1000.0;
    Quantities sum{};
    for (const exchange::RockAtTarget& rock : rocks) {
        const double energy_kj = static_cast<double>(rock.energy_j) / j_per_kj;
        add(sum, consequences::consequence(exposure, plan.curves.classes()[plan.curves.class_of(energy_kj)],
                                           static_cast<double>(rock.diameter_m), plan.settings));
    }
    for (double& figure : sum) {
        figure *= weight;
    }
    return sum;
}

/// Nothing is known of deaths where no target has persons, and so on.
Quantities without_uncounted(Quantities figures, std::span<const ExposedTarget> targets,
                             const RiskSettings& settings) {
    for (std::size_t q = 0; q < quantities; ++q) {
        const bool is_counted = std::any_of(targets.begin(), targets.end(), [&](const ExposedTarget& target) {
            return consequences::has_what_counts(target.exposure, static_cast<Quantity>(q), settings);
        });
        figures[q] = is_counted ? figures[q] : not_known;
    }
    return figures;
}

/// Adds the years of a member. `exposed`: place in the plan of each target of the site.
void add_member(const Names& names, const MemberYears& member,
                const std::vector<std::optional<std::size_t>>& exposed, RiskOverYears& risk) {
    const std::size_t course = names.course_of(member.member);
    const auto years_at = [&](RiskAtPlace& place, Cover cover) -> RiskByYear& {
        return place.values[static_cast<std::size_t>(cover)][course][member.member.replicate];
    };
    std::span<const exchange::RockAtTarget> rest{member.rocks_at_targets};
    for (const TargetRow& row : member.targets) {
        for (const auto& [cover, count] :
             {std::pair{Cover::forest, row.paired.forest()}, std::pair{Cover::bare, row.paired.bare()}}) {
            assert(count <= rest.size());
            const auto rocks = rest.first(count);
            rest = rest.subspan(count);
            const std::uint64_t started = row.bare.share.whole;
            if (!exposed[row.target] || started == 0) {
                continue;
            }
            const std::size_t place = *exposed[row.target];
            Quantities here = risk_of_rocks(rocks, risk.rocks_per_year / static_cast<double>(started),
                                            risk.plan.targets[place].exposure, risk.plan);
            years_at(risk.targets[place], cover)[row.year] =
                without_uncounted(here, {&risk.plan.targets[place], 1}, risk.plan.settings);
            here[consequences::index_of(Quantity::individual_risk)] = not_known;
            add(years_at(risk.all, cover)[row.year], here);
        }
    }
    assert(rest.empty());
}

RiskBands bands_over(const std::vector<Quantities>& replicates) {
    RiskBands bands{replicates.size(), {}};
    for (std::size_t q = 0; q < quantities; ++q) {
        std::vector<double> values;
        for (const Quantities& replicate : replicates) {
            values.push_back(replicate[q]);
        }
        const bool is_known =
            std::none_of(values.begin(), values.end(), [](double value) { return std::isnan(value); });
        bands.of[q] = is_known
                          ? band_of(std::move(values), not_negative)
                          : Band{not_known, not_known, not_known, not_known, not_known, not_known, not_known};
    }
    return bands;
}

/// Calls `use(figures, first, last)` for each year with rocks after the start and the years it stands for.
template <class Use>
void for_years_after_start(const RiskByYear& years, Use use) {
    std::int32_t before = 0;
    for (const auto& [year, figures] : years) {
        if (year > 0) {
            use(figures, before + 1, year);
            before = year;
        }
    }
}

}  // namespace

RiskOverYears risk_over_years(const Names& names, std::span<const rockfall::Target> targets,
                              std::span<const MemberYears> members, const consequences::RiskPlan& plan,
                              double rocks_per_year) {
    RiskOverYears risk{plan, rocks_per_year, {}, empty_place(all_targets, names, members)};
    std::vector<std::optional<std::size_t>> exposed(targets.size());
    for (std::size_t i = 0; i < plan.targets.size(); ++i) {
        exposed[consequences::place_among(plan.targets[i].id, targets)] = i;
        risk.targets.push_back(empty_place(plan.targets[i].id, names, members));
    }
    for (const MemberYears& member : members) {
        add_member(names, member, exposed, risk);
    }
    for (auto& courses : risk.all.values) {
        for (std::vector<RiskByYear>& replicates : courses) {
            for (RiskByYear& years : replicates) {
                for (auto& [year, figures] : years) {
                    figures = without_uncounted(figures, plan.targets, plan.settings);
                }
            }
        }
    }
    return risk;
}

std::optional<Quantities> mean_after_start(const RiskByYear& years) {
    Quantities sum{};
    double count = 0.0;
    for_years_after_start(years, [&](const Quantities& figures, std::int32_t first, std::int32_t last) {
        const double stands_for = last - first + 1;
        count += stands_for;
        for (std::size_t q = 0; q < quantities; ++q) {
            sum[q] += stands_for * figures[q];
        }
    });
    if (count == 0.0) {
        return std::nullopt;
    }
    for (double& figure : sum) {
        figure /= count;
    }
    return sum;
}

double present_value_of_risk(const RiskByYear& years, double discount_percent) {
    double sum = 0.0;
    for_years_after_start(years, [&](const Quantities& figures, std::int32_t first, std::int32_t last) {
        for (std::int32_t year = first; year <= last; ++year) {
            sum += figures[consequences::index_of(Quantity::money)] *
                   std::pow(1.0 + discount_percent / 100.0, -static_cast<double>(year));
        }
    });
    return sum;
}

std::optional<RiskBands> risk_in_year(const RiskAtPlace& place, Cover cover, std::size_t course,
                                      std::int32_t year) {
    std::vector<Quantities> known;
    for (const RiskByYear& replicate : place.at(cover, course)) {
        if (const auto found = replicate.find(year); found != replicate.end()) {
            known.push_back(found->second);
        }
    }
    return known.empty() ? std::nullopt : std::optional{bands_over(known)};
}

std::optional<RiskBands> mean_risk(const RiskAtPlace& place, Cover cover, std::size_t course) {
    std::vector<Quantities> known;
    for (const RiskByYear& replicate : place.at(cover, course)) {
        if (const auto mean = mean_after_start(replicate)) {
            known.push_back(*mean);
        }
    }
    return known.empty() ? std::nullopt : std::optional{bands_over(known)};
}

std::vector<std::int32_t> years_of(const RiskAtPlace& place) {
    std::set<std::int32_t> years;
    for (const auto& of_cover : place.values) {
        for (const auto& replicates : of_cover) {
            for (const RiskByYear& replicate : replicates) {
                for (const auto& [year, figures] : replicate) {
                    years.insert(year);
                }
            }
        }
    }
    return {years.begin(), years.end()};
}

}  // namespace coupling::decades
