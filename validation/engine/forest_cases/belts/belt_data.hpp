#pragma once

#include <string>
#include <vector>

#include "validation/engine/forest_cases/shared/comparison.hpp"
#include "validation/engine/forest_cases/succession_trial/comparison.hpp"

namespace coupling::validation::forest_cases::belts {

/// What a case of forests from bare ground was given.
struct BeltData {
    forest::SpeciesTable species;
    succession_trial::SuccessionCase tables;
    std::vector<std::string> published;  ///< of each group: what the literature has
    std::vector<std::string> sources;
    BeltSettings settings;
    forest::YearWindow judged;
};

/// What a case has found, by site.
struct Found {
    std::vector<succession_trial::SuccessionRun> runs;  ///< site by site, replicate by replicate
    std::vector<std::vector<double>> judged_tpha;       ///< by site and species, mean over the judged years
};

/// "fir and beech" for "fir_beech".
std::string group_words(std::string name);
/// "1200 m", or "1200 m, +4 K, rain x 0.7".
std::string site_words(const succession_trial::SuccessionSite& site);
double sum_of(const std::vector<double>& values);
/// Whether the climate of a site is another than that of its elevation.
bool has_other_climate(const succession_trial::SuccessionSite& site);

}  // namespace coupling::validation::forest_cases::belts
