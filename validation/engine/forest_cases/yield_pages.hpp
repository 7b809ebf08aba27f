#pragma once

#include <string>
#include <vector>

#include "validation/engine/forest_cases/shared/comparison.hpp"
#include "validation/engine/forest_cases/yield_trial/comparison.hpp"

namespace coupling::validation::forest_cases {

/// A yield case, read and checked.
struct YieldData {
    forest::SpeciesTable species;
    yield_trial::YieldCase tables;
    std::vector<int> ages_years;
    std::vector<int> drawn_ages_years;
    bool twins = true;  ///< whether stands are also grown without thinning
};

/// A site grown in its ways.
struct SiteOutcome {
    yield_trial::SiteYields thinned;
    yield_trial::SiteYields twin;    ///< left alone
    yield_trial::SiteYields layers;  ///< left alone, in light by layers
};

/// "Picea abies at 1000 m".
std::string words_of(const YieldData& data, const yield_trial::YieldSite& site);

/// Adds the plots and tables of the page. `found` has one entry a site.
void add_yield_pages(Outcome& outcome, const YieldData& data, const std::vector<SiteOutcome>& found);

}  // namespace coupling::validation::forest_cases
