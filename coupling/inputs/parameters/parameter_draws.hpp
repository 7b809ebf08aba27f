#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "coupling/inputs/parameters/parameter_widths.hpp"
#include "rockfall/draws/fall_draw.hpp"

namespace coupling {

/// What is not known, drawn for each stratum of rocks or for all rocks of a replicate.
struct ParameterDraws {
    /// One component of the draws.
    struct Component {
        std::string parameter;      ///< "losses", "losses_on.pasture"
        std::string ground{};       ///< label of the ground type that it concerns alone; "" for all
        double width = 0.0;         ///< standard deviation of ln(factor) [-]
        bool of_obstacles = false;  ///< changes stems and logs alone: nothing on the bare slope
    };
    std::vector<Component> components;
    std::vector<std::vector<double>> factors;  ///< by stratum, by component [-]
    std::vector<rockfall::FallDraw> falls;     ///< by stratum; empty: all rocks fall by the central values

    [[nodiscard]] bool empty() const { return falls.empty(); }
};

/// What is drawn for a site: where it has neither stems nor logs nothing is drawn for them; of ground types
/// those that occur count.
struct DrawnSite {
    const std::vector<rockfall::SurfaceType>& types;
    std::vector<bool> occurs;  ///< by type
    bool has_obstacles = false;
};

/// Draws for the strata of so many rocks, from the seed alone: the same for all forests, regimes and motion
/// models. Empty where all widths are 0.
ParameterDraws draw_parameters(const std::vector<ParameterWidth>& widths, const DrawnSite& site,
                               const rockfall::FallLaw& law, std::uint64_t seed, std::uint64_t rocks);

/// One draw for all rocks of a replicate of a run over years, from seed and replicate alone: the same for all
/// regimes, climates and numbers of replicates. The first replicate (0) falls by the central values: empty.
ParameterDraws draw_of_replicate(const std::vector<ParameterWidth>& widths, const DrawnSite& site,
                                 const rockfall::FallLaw& law, std::uint64_t seed, std::uint32_t replicate);

}  // namespace coupling
