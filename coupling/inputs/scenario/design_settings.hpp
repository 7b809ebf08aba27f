#pragma once

#include <cstdint>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/options/options.hpp"

namespace coupling {

/// What is added to the figures of simulated rocks before a barrier is chosen.
enum class DesignRule : std::uint8_t {
    none,  ///< nothing: percentiles as they are, with the radius of the rock
    own,   ///< the factors and the freeboard of the settings
};

/// The settings of section [design].
struct DesignSettings {
    DesignRule rule = DesignRule::none;
    double percentile = 95.0;    ///< of energy and height of passage of the rocks that come [%]
    double energy_factor = 1.0;  ///< of rule own: partial factor on the energy [-], >= 1
    double height_factor = 1.0;  ///< of rule own: partial factor on the height of passage [-], >= 1
    double freeboard_m = 0.0;    ///< of rule own: above all of that
    /// Of the nets on offer, rising [choice: half metres; the lowest and the highest as nets.file takes
    /// them].
    std::vector<double> sold_heights_m{1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0, 5.5,
                                       6.0, 6.5, 7.0, 7.5, 8.0, 8.5, 9.0, 9.5, 10.0};

    /// `percentile` as a share [0, 1]. 0.01 * 95 is above 0.95, and asks for the next rank.
    [[nodiscard]] double share() const { return percentile / 100.0; }
};

/// What the rule adds.
struct DesignMargins {
    double energy_factor = 1.0;
    double height_factor = 1.0;
    double freeboard_m = 0.0;
};
DesignMargins margins_of(const DesignSettings& design);

void declare(config::Options& options, DesignSettings& design);

/// Heights that do not rise, and a rule of one's own that adds nothing: problems of the settings.
void check(const DesignSettings& design, const config::Options& options, config::Problems& problems);

}  // namespace coupling
