#include "validation/engine/forest_cases/belts/belt_data.hpp"

#include <cmath>
#include <numeric>

#include "config/text/joined.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::validation::forest_cases::belts {

using config::joined;
using succession_trial::SuccessionSite;

std::string group_words(std::string name) {
    for (std::size_t at = name.find('_'); at != std::string::npos; at = name.find('_')) {
        name.replace(at, 1, " and ");
    }
    return name;
}

double sum_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

bool has_other_climate(const SuccessionSite& site) {
    return site.warmer_k != 0.0 || site.rain_factor != 1.0;
}

std::string site_words(const SuccessionSite& site) {
    std::string words = joined(std::to_string(std::lround(site.elevation_m)), " m");
    if (site.warmer_k != 0.0) {
        words += joined(", ", site.warmer_k > 0.0 ? "+" : "", report::tick_text(site.warmer_k), " K");
    }
    if (site.rain_factor != 1.0) {
        words += joined(", rain x ", report::tick_text(site.rain_factor));
    }
    return words;
}

}  // namespace coupling::validation::forest_cases::belts
