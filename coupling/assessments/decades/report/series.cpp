#include "coupling/assessments/decades/report/series.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

#include "coupling/results/text/join_texts.hpp"

namespace coupling::decades {
namespace {

std::vector<YearView> years_of(const Names& names, const MemberYears& member, double area_ha) {
    std::vector<YearView> years;
    for (const YearRow& row : member.years) {
        assert(row.year == static_cast<std::int32_t>(years.size()));
        years.push_back({&row, nullptr, std::vector<double>(names.species.size(), 0.0), {}, {}, 0.0});
    }
    for (const StandRow& stand : member.stands) {
        if (stand.unit != all) {
            continue;
        }
        YearView& year = years[static_cast<std::size_t>(stand.year)];
        if (stand.species == all) {
            year.stand = &stand.figures;
            year.drought_index = stand.drought_index;
        } else {
            year.volumes_m3pha[stand.species] = stand.figures.volume_m3pha;
        }
    }
    // What is done at the start belongs to the first year: sums over years begin with that.
    const auto place_of = [&](std::size_t year) { return year == 0 && years.size() > 1 ? 1 : year; };
    for (const LossRow& loss : member.losses) {
        forest::Loss& sum =
            years[place_of(static_cast<std::size_t>(loss.year))].losses[forest::index_of(loss.cause)];
        sum.stems_pha += loss.loss.stems_pha;
        sum.volume_m3pha += loss.loss.volume_m3pha;
        sum.above_ground_tpha += loss.loss.above_ground_tpha;
    }
    const std::vector<YearlyWork> work = work_by_year(names, member, area_ha);
    for (std::size_t year = 0; year < work.size(); ++year) {
        years[place_of(year)].work += work[year];
    }
    return years;
}

}  // namespace

std::string letter_of(std::size_t place, std::size_t regimes) {
    if (regimes < 2) {
        return "";
    }
    return regimes <= 26 ? std::string(1, static_cast<char>('A' + place)) : std::to_string(place + 1);
}

std::string CourseLook::title() const {
    return letter.empty() ? name : report::with_label(letter, name);
}

std::string CourseLook::title_in_chart() const {
    return letter.empty() ? in_chart : report::with_label(letter, in_chart);
}

CourseLook look_of(const Names& names, std::size_t course) {
    const std::size_t regime = names.regime_of(course);
    const std::size_t climate = names.climate_of(course);
    const bool by_climate = names.regimes.size() == 1;
    return {
        letter_of(by_climate ? climate : regime, by_climate ? names.climates.size() : names.regimes.size()),
        by_climate ? climate : regime, names.course_name(course),
        splits_charts(names) ? names.regimes[regime] : names.course_name(course)};
}

bool splits_charts(const Names& names) {
    return names.regimes.size() > 1 && names.climates.size() > 1;
}

Band RegimeView::band(std::size_t year, const YearFigure& figure, const Bounds& bounds) const {
    return mean_band(year, year, figure, bounds);
}

Band RegimeView::mean_band(std::size_t first_year, std::size_t last_year, const YearFigure& figure,
                           const Bounds& bounds) const {
    std::vector<double> means;
    for (const std::vector<YearView>& years : replicates) {
        double sum = 0.0;
        for (std::size_t year = first_year; year <= last_year; ++year) {
            sum += figure(years[year]);
        }
        means.push_back(sum / static_cast<double>(last_year - first_year + 1));
    }
    return band_of(std::move(means), bounds);
}

std::size_t RunView::replicates() const {
    std::size_t most = 0;
    for (const RegimeView& regime : regimes) {
        most = std::max(most, regime.replicates.size());
    }
    return most;
}

RunView view_of(const Names& names, std::span<const MemberYears> members, double area_ha) {
    std::vector<const MemberYears*> order;
    std::set<std::size_t> species;
    for (const MemberYears& member : members) {
        order.push_back(&member);
        for (const StandRow& stand : member.stands) {
            if (stand.species != all) {
                species.insert(stand.species);
            }
        }
    }
    std::sort(order.begin(), order.end(), [](const MemberYears* a, const MemberYears* b) {
        return std::tuple{a->member.regime, a->member.climate, a->member.replicate} <
               std::tuple{b->member.regime, b->member.climate, b->member.replicate};
    });
    RunView run;
    run.climates = names.climates;
    run.chart_a_climate = splits_charts(names);
    run.species.assign(species.begin(), species.end());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t course = names.course_of(order[i]->member);
        if (run.regimes.empty() || course != run.regimes.back().course) {
            run.regimes.push_back({course, order[i]->member.climate, look_of(names, course), {}, order[i]});
        }
        run.regimes.back().replicates.push_back(years_of(names, *order[i], area_ha));
    }
    if (!order.empty()) {
        run.years = order.front()->years.size() - 1;
    }
    return run;
}

double stems_from_12_cm(const forest::StandFigures& stand) {
    const std::size_t first = forest::dbh_class_of(12.0);
    return std::accumulate(stand.stems_pha_by_class.begin() + static_cast<std::ptrdiff_t>(first),
                           stand.stems_pha_by_class.end(), 0.0);
}

}  // namespace coupling::decades
