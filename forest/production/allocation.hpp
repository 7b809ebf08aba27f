#pragma once

#include "forest/stand/species.hpp"

namespace forest {

// Allocation of production and litterfall in 3-PG (Landsberg & Waring 1997; Sands & Landsberg 2002).

/// Share of production used for roots [-]: the more, the poorer the site. `fertility_response` is m
/// of 3-PG, m0 + (1 - m0) * fertility, and physiology the modifier of the year or month.
double root_share(const RootShare& range, double physiology, double fertility_response);

/// Production for foliage per production for stem at a DBH: a power law through its values at 2 and 20 cm.
class FoliageToStemLaw {
public:
    explicit FoliageToStemLaw(const FoliageToStem& ratio);
    [[nodiscard]] double at(double dbh_cm) const;

private:
    double exponent_;
    double factor_;
};

/// Share of foliage lost a month at an age: sigmoid from the initial to the mature rate.
double litterfall_pmonth(double age_years, const Litterfall& litterfall);

/// A property that changes with age from `young` to `mature`, half-way at `half_years`; constant where that
/// is 0.
double by_age(double age_years, double young, double mature, double half_years, double power);

}  // namespace forest
