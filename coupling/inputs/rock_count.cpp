#include "coupling/inputs/rock_count.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling::plausible {

using config::joined;

std::uint64_t rocks_in_all(const Scenario& scenario, const Site& site) {
    std::uint64_t rocks = 0;
    for (const rockfall::ReleaseSource& source : site.sources) {
        rocks += source.rocks;
    }
    if (scenario.run.years == 0 || scenario.forest.rockfall_every == 0) {
        return rocks;
    }
    const std::uint64_t falls = scenario.run.years / scenario.forest.rockfall_every + 1;
    return rocks * falls * scenario.forest.replicates;
}

void warn_of_few_rocks(std::uint64_t rocks, config::Warnings& warnings) {
    if (rocks == 0 || rocks >= least_rocks) {
        return;
    }
    // Half the width of the 95 % interval of a share of one half, where it is widest.
    const double half_width_percent = 98.0 / std::sqrt(static_cast<double>(rocks));
    warnings.add(joined("only ", std::to_string(rocks), rocks == 1 ? " rock is" : " rocks are",
                        " released in all: a share of 50 % is uncertain by ",
                        std::to_string(std::lround(std::min(half_width_percent, 50.0))),
                        " percentage points either way; raise release.rocks or release.rocks_per_source"),
                 config::Effect::answer);
}

void warn_of_odd_sizes(const rockfall::DiameterRange& diameters, config::Warnings& warnings) {
    const auto warn = [&](const char* which, double diameter_m) {
        warnings.add(joined("the ", which, " rocks have a diameter of ",
                            config::to_text(std::round(1000.0 * diameter_m) / 1000.0),
                            " m: check the units of their sizes (m, t, m3)"),
                     config::Effect::answer);
    };
    if (diameters.smallest_m < smallest_usual_m) {
        warn("smallest", diameters.smallest_m);
    }
    if (diameters.largest_m > largest_usual_m) {
        warn("largest", diameters.largest_m);
    }
}

void warn_of_rocks(const Scenario& scenario, const Site& site, config::Warnings& warnings) {
    warn_of_few_rocks(rocks_in_all(scenario, site), warnings);
    if (!site.sources.empty()) {
        warn_of_odd_sizes(rockfall::diameter_range(start_law(scenario.release), site.sources), warnings);
    }
}

}  // namespace coupling::plausible
