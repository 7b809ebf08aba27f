#include "coupling/assessments/hazard/risk/risk_results.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "config/table/table.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "coupling/assessments/hazard/hits/arrival_rows.hpp"
#include "coupling/results/figures/figures.hpp"

namespace coupling::hazard::risk {
namespace {

std::vector<TargetExposure> exposures_of(const RiskPlan& plan) {
    std::vector<TargetExposure> exposures;
    for (const ExposedTarget& target : plan.targets) {
        exposures.push_back(target.exposure);
    }
    return exposures;
}

constexpr Estimate no_estimate{.value = std::numeric_limits<double>::quiet_NaN(),
                               .low = std::numeric_limits<double>::quiet_NaN(),
                               .high = std::numeric_limits<double>::quiet_NaN()};

/// Nothing is known of deaths where no target has persons, and so on.
PlaceRisk without_uncounted(PlaceRisk risk, std::span<const TargetExposure> exposures,
                            const RiskSettings& settings) {
    for (std::size_t q = 0; q < quantities; ++q) {
        if (consequences::any_has_what_counts(exposures, static_cast<Quantity>(q), settings)) {
            continue;
        }
        for (SlopeRisk& slope : risk.slopes) {
            slope.of[q] = no_estimate;
            if (static_cast<Quantity>(q) == Quantity::money) {
                slope.all_money.reset();
            }
            for (Quantities& part : slope.by_class) {
                part[q] = no_estimate.value;
            }
        }
        if (static_cast<Quantity>(q) == Quantity::deaths) {
            risk.spared_deaths = no_estimate;
        }
    }
    return risk;
}

/// Among how many draws of what is not known a finished return period shared its rocks.
std::uint32_t strata_in(const std::filesystem::path& folder) {
    constexpr const char* name = "parameter_draws.csv";
    if (!compare::has_table(folder, name)) {
        return 1;
    }
    const config::Table draws = compare::read_table(folder, name, {"stratum"});
    double last = 0.0;
    for (std::size_t row = 0; row < draws.rows(); ++row) {
        last = std::max(last, compare::count(draws, row, "stratum"));
    }
    return static_cast<std::uint32_t>(last) + 1;
}

}  // namespace

RiskOfPeriods::RiskOfPeriods(const RiskPlan& plan, std::filesystem::path without)
    : plan_{plan},
      sums_{exposures_of(plan), plan.curves, plan.settings},
      without_{std::move(without)},
      with_and_without_(without_.empty() ? 0 : rockfall::covers, sums_) {}

std::vector<Hit> RiskOfPeriods::hits_in(const std::filesystem::path& folder, const Site& site,
                                        const hits::BlockRows& blocks) const {
    std::vector<std::optional<std::uint32_t>> exposed(site.targets.size());
    for (std::size_t i = 0; i < plan_.targets.size(); ++i) {
        exposed[consequences::place_among(plan_.targets[i].id, site.targets)] = static_cast<std::uint32_t>(i);
    }
    std::vector<Hit> found;
    hits::for_each_arrival(
        folder / "tables" / "arrivals.csv", site, blocks, [&](const hits::ArrivalRow& row) {
            if (const auto& target = exposed[row.target]) {
                found.push_back({row.rock, *target, static_cast<std::uint16_t>(row.block_row),
                                 static_cast<std::uint16_t>(plan_.curves.class_of(row.energy_kj)),
                                 row.cover});
            }
        });
    return found;
}

void RiskOfPeriods::add(const std::filesystem::path& folder, double return_period_years, const Site& site,
                        const hits::BlockRows& blocks, std::uint64_t seed) {
    const rockfall::Strata strata{strata_in(folder), seed};
    std::vector<Hit> found = hits_in(folder, site, blocks);
    if (!without_.empty()) {
        last_period_without_ = without_ / folder.filename();
        const std::vector<Hit> others = hits_in(last_period_without_, site, blocks);
        for (std::size_t slope = 0; slope < with_and_without_.size(); ++slope) {
            std::vector<Hit> both;
            const auto take = [&](const std::vector<Hit>& hits, Cover as) {
                for (Hit hit : hits) {
                    if (coupling::index_of(hit.cover) == slope) {
                        hit.cover = as;
                        both.push_back(hit);
                    }
                }
            };
            take(found, Cover::forest);
            take(others, Cover::bare);
            with_and_without_[slope].add_period(return_period_years, blocks.rows(), std::move(both), strata);
        }
    }
    sums_.add_period(return_period_years, blocks.rows(), std::move(found), strata);
}

AvoidedRisk RiskOfPeriods::avoided_on(const Site& site, const std::vector<Cover>& slopes) const {
    AvoidedRisk avoided;
    avoided.barriers = new_barriers(site, last_period_without_, plan_.settings.interest_percent);
    for (const Cover cover : slopes) {
        const PlaceRisk both = without_uncounted(with_and_without_[coupling::index_of(cover)].of_all(),
                                                 exposures_of(plan_), plan_.settings);
        const SlopeRisk& with = both.slopes[coupling::index_of(Cover::forest)];
        const SlopeRisk& without = both.slopes[coupling::index_of(Cover::bare)];
        avoided.slopes.push_back({cover, without.at(Quantity::money), with.at(Quantity::money),
                                  without.at(Quantity::deaths), with.at(Quantity::deaths), both.spared_money,
                                  both.spared_deaths});
    }
    return avoided;
}

RiskResults RiskOfPeriods::results(const Site& site, std::vector<Cover> slopes) const {
    const std::vector<TargetExposure> exposures = exposures_of(plan_);
    RiskResults results{plan_.curves,
                        plan_.settings,
                        std::move(slopes),
                        {},
                        without_uncounted(sums_.of_all(), exposures, plan_.settings),
                        {}};
    for (std::size_t i = 0; i < plan_.targets.size(); ++i) {
        results.targets.push_back({consequences::place_among(plan_.targets[i].id, site.targets),
                                   plan_.targets[i].exposure,
                                   without_uncounted(sums_.at(i), {&exposures[i], 1}, plan_.settings)});
    }
    if (!without_.empty()) {
        results.avoided = avoided_on(site, results.slopes);
    }
    return results;
}

std::vector<std::size_t> RiskResults::ranked() const {
    const auto height = [&](std::size_t i) {
        const SlopeRisk& now = targets[i].risk.slopes[coupling::index_of(slopes.front())];
        const SlopeRisk& bare = targets[i].risk.slopes[coupling::index_of(slopes.back())];
        return std::tuple{now.at(Quantity::money).value, bare.at(Quantity::money).value,
                          now.at(Quantity::arrivals).value, bare.at(Quantity::arrivals).value};
    };
    std::vector<std::size_t> order(targets.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return height(a) > height(b); });
    return order;
}

}  // namespace coupling::hazard::risk
