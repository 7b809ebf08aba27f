#include "coupling/assessments/decades/tables/indicator_series.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "coupling/results/figures/few_rocks.hpp"

namespace coupling::decades {
namespace {

constexpr double carbon_share = 0.5;
constexpr double sawn_share = 0.5;
constexpr double sawn_half_life_years = 35.0;
constexpr std::size_t years_of_losses = 5;

void add_figures_of_stands(std::vector<Series>& all_series, const Names& names,
                           std::span<const MemberYears> members) {
    struct Figure {
        const char* quantity;
        bool low_is_bad;
        double forest::StandIndicators::*value;
    };
    for (const Figure& figure :
         {Figure{"hd_above_90_percent", false, &forest::StandIndicators::slender_percent},
          Figure{"cover_percent", true, &forest::StandIndicators::cover_percent},
          Figure{"regeneration_percent", true, &forest::StandIndicators::regeneration_percent},
          Figure{"regeneration_pha", true, &forest::StandIndicators::regeneration_pha}}) {
        Series series = empty_series(names, members, figure.quantity, "", figure.low_is_bad);
        for (const MemberYears& member : members) {
            for (const IndicatorRow& row : member.indicators) {
                const double value = row.figures.*figure.value;
                if (row.unit == all && !std::isnan(value)) {
                    values_of(series, names, member)[row.year] = value;
                }
            }
        }
        all_series.push_back(std::move(series));
    }
}

}  // namespace

void add_living(std::vector<Series>& all_series, const Names& names, const Site& site,
                std::span<const MemberYears> members) {
    for (std::uint32_t t = 0; t < site.targets.size(); ++t) {
        Series series = empty_ratio(names, members, "protection_living_percent", site.targets[t].id, true);
        std::map<std::pair<std::size_t, std::int32_t>, std::uint64_t> arrivals;
        for (const MemberYears& member : members) {
            for (const LivingRow& row : member.living) {
                if (row.target == t) {
                    arrivals[{names.course_of(member.member), row.year}] += row.paired.bare();
                }
            }
        }
        for (const MemberYears& member : members) {
            for (const LivingRow& row : member.living) {
                const auto effect = protection_effect(row.paired);
                if (row.target == t && effect &&
                    !too_few_for_protection(arrivals.at({names.course_of(member.member), row.year}))) {
                    set_ratio(series, names, member, row.year, 100.0 * effect->value,
                              static_cast<double>(row.paired.bare()));
                }
            }
        }
        series.has_worst = true;
        if (!years_of(series).empty()) {
            all_series.push_back(std::move(series));
        }
    }
}

std::vector<double> lost_in_five_years_m3pha(const MemberYears& member) {
    std::vector<double> yearly(member.years.size(), 0.0);
    for (const LossRow& row : member.losses) {
        if (row.cause != forest::Cause::felled) {
            yearly[static_cast<std::size_t>(row.year)] += row.loss.volume_m3pha;
        }
    }
    std::vector<double> sums(yearly.size(), 0.0);
    for (std::size_t year = 0; year < yearly.size(); ++year) {
        for (std::size_t back = 0; back < years_of_losses && back <= year; ++back) {
            sums[year] += yearly[year - back];
        }
    }
    return sums;
}

std::vector<CarbonYear> carbon_by_year(const MemberYears& member) {
    std::vector<CarbonYear> carbon(member.years.size());
    for (const StandRow& row : member.stands) {
        if (row.unit == all && row.species == all) {
            carbon[static_cast<std::size_t>(row.year)].stand_tpha =
                carbon_share * row.figures.above_ground_tpha;
        }
    }
    const double kept_a_year = std::exp2(-1.0 / sawn_half_life_years);
    double products_tpha = 0.0;
    for (std::size_t year = 0; year < member.years.size(); ++year) {
        const YearRow& row = member.years[year];
        products_tpha = products_tpha * kept_a_year +
                        carbon_share * sawn_share * (row.stem_hauled_tpha + row.dead_wood_taken_tpha);
        carbon[year].products_tpha = products_tpha;
        carbon[year].dead_wood_tpha = carbon_share * row.dead_stems_tpha;
    }
    return carbon;
}

void add_indicators(std::vector<Series>& all_series, const Names& names,
                    std::span<const MemberYears> members) {
    add_figures_of_stands(all_series, names, members);
    Series lost = empty_series(names, members, "lost_in_5_years_m3pha", "", false);
    Series stand = empty_series(names, members, "carbon_stand_tpha", "", true);
    Series dead = empty_series(names, members, "carbon_dead_wood_tpha", "", true);
    Series products = empty_series(names, members, "carbon_products_tpha", "", true);
    for (const MemberYears& member : members) {
        const std::vector<double> losses = lost_in_five_years_m3pha(member);
        for (std::size_t year = years_of_losses; year < losses.size(); ++year) {
            values_of(lost, names, member)[static_cast<std::int32_t>(year)] = losses[year];
        }
        const std::vector<CarbonYear> carbon = carbon_by_year(member);
        for (std::size_t year = 0; year < carbon.size(); ++year) {
            const auto at = static_cast<std::int32_t>(year);
            values_of(stand, names, member)[at] = carbon[year].stand_tpha;
            values_of(dead, names, member)[at] = carbon[year].dead_wood_tpha;
            values_of(products, names, member)[at] = carbon[year].products_tpha;
        }
    }
    for (Series* series : {&lost, &stand, &dead, &products}) {
        all_series.push_back(std::move(*series));
    }
}

}  // namespace coupling::decades
