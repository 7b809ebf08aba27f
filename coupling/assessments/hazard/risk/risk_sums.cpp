#include "coupling/assessments/hazard/risk/risk_sums.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "coupling/results/figures/drawn_spread.hpp"

namespace coupling::hazard::risk {
namespace {

using hits::BlockRow;

/// What is set against each other on both slopes.
constexpr std::array<Quantity, 2> compared{Quantity::money, Quantity::deaths};

/// How often a year a simulated rock of a row falls.
double per_year(double return_period_years, const BlockRow& row) {
    return 1.0 / (return_period_years * static_cast<double>(row.rocks));
}

void add_weighted(Quantities& to, const Quantities& of, double weight) {
    for (std::size_t q = 0; q < quantities; ++q) {
        to[q] += weight * of[q];
    }
}

/// To the larger one of each.
void raise(Quantities& largest, const Quantities& could) {
    for (std::size_t q = 0; q < quantities; ++q) {
        largest[q] = std::max(largest[q], could[q]);
    }
}

/// Rocks of a stratum share a draw of what is not known: as many of each, so that a stratum alone would bring
/// its sum times their number. Chance is taken to be the same in all of them.
std::optional<Interval> by_all(const std::vector<RateSum>& strata, double rocks, const Estimate& of_rocks) {
    if (strata.size() < 2 || !can_show_spread(rocks, strata.size())) {
        return std::nullopt;
    }
    const auto number = static_cast<double>(strata.size());
    double squares = 0.0;
    for (const RateSum& of : strata) {
        squares += of.squares;
    }
    std::vector<StratumFigure> figures;
    for (std::size_t k = 0; k < strata.size(); ++k) {
        figures.push_back({number * strata[k].sum, number * squares, k});
    }
    const auto figure =
        DrawnSpread{strata.size()}.figure(of_rocks.value, {of_rocks.low, of_rocks.high}, {}, figures);
    return figure ? std::optional{figure->of_all} : std::nullopt;
}

}  // namespace

RiskSums::RiskSums(std::vector<TargetExposure> targets, Curves curves, RiskSettings settings)
    : targets_{std::move(targets)}, curves_{std::move(curves)}, settings_{std::move(settings)} {
    places_.assign(targets_.size(), empty_place());
    all_ = empty_place();
}

RiskSums::Place RiskSums::empty_place() const {
    Place place;
    place.by_class.fill(std::vector<Quantities>(curves_.classes().size(), Quantities{}));
    return place;
}

void RiskSums::bound_weights(double return_period_years, const std::vector<BlockRow>& rows,
                             const std::vector<Hit>& found) {
    std::vector<std::optional<std::size_t>> strongest(rows.size());
    std::vector<std::vector<bool>> hits_target(targets_.size(), std::vector<bool>(rows.size()));
    for (const Hit& hit : found) {
        auto& top = strongest[hit.block_row];
        top = std::max<std::size_t>(top.value_or(0), hit.energy_class);
        hits_target[hit.target][hit.block_row] = true;
    }
    for (std::size_t row = 0; row < rows.size(); ++row) {
        if (rows[row].rocks == 0) {
            continue;
        }
        for (std::size_t t = 0; t < targets_.size(); ++t) {
            for (std::size_t k = 0; k < curves_.classes().size(); ++k) {
                Quantities could{};
                add_weighted(could,
                             consequences::consequence(targets_[t], curves_.classes()[k],
                                                       rows[row].diameter_m, settings_),
                             per_year(return_period_years, rows[row]));
                LargestWeights& here = places_[t].largest;
                raise(here.possible, could);
                if (strongest[row] && k <= *strongest[row]) {
                    raise(here.of_rows_that_hit_others, could);
                    if (hits_target[t][row]) {
                        raise(here.of_rows_that_hit, could);
                    }
                }
            }
            LargestWeights& everywhere = all_.largest;
            raise(everywhere.possible, places_[t].largest.possible);
            raise(everywhere.of_rows_that_hit, places_[t].largest.of_rows_that_hit);
        }
    }
}

void RiskSums::begin_strata(std::uint32_t count) {
    strata_ = !strata_ || *strata_ == count ? count : 0;
    const auto begin = [&](Place& place) {
        for (std::vector<RateSum>& of_cover : place.money_of_strata) {
            of_cover.resize(*strata_ > 1 ? *strata_ : 0);
        }
    };
    std::for_each(places_.begin(), places_.end(), begin);
    begin(all_);
}

void RiskSums::add(Place& place, const OfCovers& rock, std::uint32_t stratum) {
    place.is_hit = true;
    for (std::size_t cover = 0; cover < rockfall::covers; ++cover) {
        if (const double money = rock[cover][index_of(Quantity::money)]; money > 0.0) {
            place.rocks[cover] += 1.0;
            if (!place.money_of_strata[cover].empty()) {
                place.money_of_strata[cover][stratum].add(money);
            }
        }
    }
    for (std::size_t cover = 0; cover < rockfall::covers; ++cover) {
        for (std::size_t q = 0; q < quantities; ++q) {
            if (rock[cover][q] > 0.0) {
                place.sums[cover][q].add(rock[cover][q]);
            }
        }
    }
    const Quantities& bare = rock[static_cast<std::size_t>(rockfall::Cover::bare)];
    const Quantities& forest = rock[static_cast<std::size_t>(rockfall::Cover::forest)];
    for (std::size_t k = 0; k < compared.size(); ++k) {
        const double less = bare[index_of(compared[k])] - forest[index_of(compared[k])];
        if (less > 0.0) {
            place.spared[k].add(less);
        } else if (less < 0.0) {
            place.added[k].add(-less);
        }
    }
}

void RiskSums::add_period(double return_period_years, const std::vector<BlockRow>& rows,
                          std::vector<Hit> found, const rockfall::Strata& strata) {
    begin_strata(strata.count);
    bound_weights(return_period_years, rows, found);
    std::sort(found.begin(), found.end(), [](const Hit& a, const Hit& b) {
        return std::tuple{a.rock, a.target, a.cover} < std::tuple{b.rock, b.target, b.cover};
    });
    for (auto hit = found.begin(); hit != found.end();) {
        const std::uint64_t rock = hit->rock;
        OfCovers everywhere{};
        while (hit != found.end() && hit->rock == rock) {
            const std::uint32_t target = hit->target;
            OfCovers here{};
            for (; hit != found.end() && hit->rock == rock && hit->target == target; ++hit) {
                const BlockRow& row = rows[hit->block_row];
                const auto cover = static_cast<std::size_t>(hit->cover);
                Quantities of{};
                add_weighted(of,
                             consequences::consequence(targets_[target], curves_.classes()[hit->energy_class],
                                                       row.diameter_m, settings_),
                             per_year(return_period_years, row));
                add_weighted(here[cover], of, 1.0);
                add_weighted(places_[target].by_class[cover][hit->energy_class], of, 1.0);
                of[index_of(Quantity::individual_risk)] = 0.0;
                add_weighted(everywhere[cover], of, 1.0);
                add_weighted(all_.by_class[cover][hit->energy_class], of, 1.0);
            }
            add(places_[target], here, strata.of(rock));
        }
        add(all_, everywhere, strata.of(rock));
    }
}

PlaceRisk RiskSums::risk_of(Place place) const {
    const Quantities& largest = place.is_hit  ? place.largest.of_rows_that_hit
                                : all_.is_hit ? place.largest.of_rows_that_hit_others
                                              : place.largest.possible;
    for (RateSums& sums : place.sums) {
        for (std::size_t q = 0; q < quantities; ++q) {
            sums[q].could_add(largest[q]);
        }
    }
    for (std::size_t k = 0; k < compared.size(); ++k) {
        place.spared[k].could_add(largest[index_of(compared[k])]);
        place.added[k].could_add(largest[index_of(compared[k])]);
    }
    PlaceRisk risk;
    for (std::size_t cover = 0; cover < rockfall::covers; ++cover) {
        for (std::size_t q = 0; q < quantities; ++q) {
            risk.slopes[cover].of[q] = estimate(place.sums[cover][q]);
        }
        risk.slopes[cover].by_class = place.by_class[cover];
        risk.slopes[cover].all_money =
            by_all(place.money_of_strata[cover], place.rocks[cover], risk.slopes[cover].at(Quantity::money));
    }
    risk.spared_money = difference(place.spared[0], place.added[0]);
    risk.spared_deaths = difference(place.spared[1], place.added[1]);
    return risk;
}

PlaceRisk RiskSums::at(std::size_t target) const {
    return risk_of(places_[target]);
}

PlaceRisk RiskSums::of_all() const {
    Place place = all_;
    place.largest.of_rows_that_hit[index_of(Quantity::individual_risk)] = 0.0;
    place.largest.possible[index_of(Quantity::individual_risk)] = 0.0;
    return risk_of(std::move(place));
}

}  // namespace coupling::hazard::risk
