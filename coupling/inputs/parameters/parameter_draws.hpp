#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "coupling/inputs/parameters/parameter_knowledge.hpp"
#include "forest/forest_factors.hpp"
#include "rockfall/draws/fall_draw.hpp"
#include "rockfall/draws/strata.hpp"

namespace coupling {

/// What is not known, drawn for each stratum of rocks or for all rocks of a replicate.
struct ParameterDraws {
    /// One component of the draws.
    struct Component {
        std::string parameter;      ///< "losses", "losses_on.pasture"
        std::string ground{};       ///< label of the ground type that it concerns alone; "" for all
        double width = 0.0;         ///< standard deviation of ln(factor) [-]
        bool of_obstacles = false;  ///< changes the forest alone: nothing on the bare slope
        std::string goes_with{};    ///< a component before it, that goes with none; "": independent
        double correlation = 0.0;   ///< of the logarithms of the two
    };
    std::vector<Component> components;
    std::vector<std::vector<double>> factors;  ///< by stratum, by component [-]
    std::vector<rockfall::FallDraw> falls;     ///< by stratum; empty: all rocks fall by the central values
    std::vector<forest::ForestFactors> forests{};  ///< by stratum

    [[nodiscard]] bool empty() const { return falls.empty(); }
    /// Whether rocks fall by several vectors, so that results have an interval of what is not known.
    [[nodiscard]] bool has_spread() const { return falls.size() > 1; }
    /// Of the rocks of a static run with this seed.
    [[nodiscard]] rockfall::Strata strata(std::uint64_t seed) const {
        return {has_spread() ? static_cast<std::uint32_t>(falls.size()) : 1, seed};
    }
};

/// What is drawn for a site: where it has neither stems nor logs nothing is drawn for them; of ground types
/// those that occur count.
struct DrawnSite {
    const std::vector<rockfall::SurfaceType>& types;
    std::vector<bool> occurs;  ///< by type
    bool has_obstacles = false;
    /// Standard deviation of ln(diameter) of all stems together: 0 where they were measured.
    double stem_diameter_width = 0.0;
    bool grows = false;  ///< a forest over years
};

/// Draws for the strata of so many rocks, from the seed alone: the same for all forests, regimes and motion
/// models. Empty where all is known. Of a joint sample each stratum takes a set, sets by their weights.
ParameterDraws draw_parameters(const ParameterKnowledge& knowledge, const DrawnSite& site,
                               const rockfall::FallLaw& law, std::uint64_t seed, std::uint64_t rocks);

/// One draw for all rocks of a replicate of a run over years, from seed and replicate alone: the same for all
/// regimes, climates and numbers of replicates. The first replicate (0) falls by the central values.
ParameterDraws draw_of_replicate(const ParameterKnowledge& knowledge, const DrawnSite& site,
                                 const rockfall::FallLaw& law, std::uint64_t seed, std::uint32_t replicate);

/// The central values for all rocks: the centre of a joint sample; empty without one.
ParameterDraws central_draw(const ParameterKnowledge& knowledge, const DrawnSite& site,
                            const rockfall::FallLaw& law);

/// A draw for each of some sets, given as factors of the components of `components_on`, in their order.
ParameterDraws draw_of_sets(const ParameterKnowledge& knowledge, const DrawnSite& site,
                            const rockfall::FallLaw& law, std::vector<std::vector<double>> factors);

/// Standard numbers of components that correlate as these say, of independent ones, in their order: a normal
/// copula. Within the cut-off of the draws, as those are.
std::vector<double> correlated(std::span<const ParameterDraws::Component> components,
                               std::vector<double> independent);

/// What is drawn on a site.
std::vector<ParameterDraws::Component> components_on(const ParameterKnowledge& knowledge,
                                                     const DrawnSite& site);

}  // namespace coupling
