#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/inputs/scenario/design_settings.hpp"
#include "coupling/results/figures/indicators.hpp"
#include "rockfall/tally/footprint.hpp"

namespace coupling {

/// A rock in the plane of a barrier, as it first comes there.
struct Passage {
    double energy_kj = 0.0;
    double centre_m = 0.0;  ///< above the ground, vertical
    double radius_m = 0.0;
    std::uint32_t stratum = 0;  ///< of the rock: rocks of one share a draw of what is not known

    /// Height of passage: that of the rock's upper edge.
    [[nodiscard]] double top_m() const { return centre_m + radius_m; }
};
Passage passage_of(const rockfall::NetCrossingRecord& crossing, std::uint32_t stratum = 0);

/// Class and height of a barrier.
struct BarrierToOrder {
    std::string energy_class;
    double capacity_kj = 0.0;  ///< MEL of the class; of the open class the energy rounded up to 100 kJ
    std::optional<double> sold_height_m;  ///< nothing: none on offer is that high
    double height_m = 0.0;                ///< as sold; where none is, the design height rounded up to 10 cm
};

/// Where the percentiles of a design lie with all that is not known, with 95 %, and what their upper ends ask
/// for.
struct DesignSpread {
    Interval energy_kj;
    Interval height_m;
    BarrierToOrder at_upper_ends;
};

/// What a barrier has to be for the rocks that come to it, and what they would do there.
///
/// Energy and height of passage are the percentile over the rocks (order statistics), each for itself. The
/// rule of the settings adds its factors and the freeboard: E = f_E E_p, h = f_h h_p + freeboard. The class
/// is the weakest whose maximum energy level (MEL) takes E; the height the lowest on offer that is not below
/// h.
struct BarrierDesign : BarrierToOrder {
    double percentile_energy_kj = 0.0;
    double design_energy_kj = 0.0;
    double percentile_height_m = 0.0;
    double design_height_m = 0.0;
    std::optional<DesignSpread> spread;  ///< nothing: all is known, or too few rocks to know
    // Of the same rocks, by the rule of rockfall/obstacles/nets: over where the centre is above the edge.
    Share held;
    Share over;
    Share through;
};

/// The barrier that percentiles of energy and height of passage ask for; what it would hold stays empty.
BarrierDesign design_for(double percentile_energy_kj, double percentile_height_m,
                         const DesignSettings& settings);

/// Gives a design the intervals of its percentiles. They are empty where an upper end is not known.
void add_spread(BarrierDesign& design, const std::optional<Interval>& energy_kj,
                const std::optional<Interval>& height_m, const DesignSettings& settings);

/// Nothing from fewer rocks than one may pass of (rocks_to_tell()). `strata`: of the draws of what is not
/// known; 1 where all is known.
std::optional<BarrierDesign> design_barrier(std::span<const Passage> rocks, const DesignSettings& settings,
                                            std::uint32_t strata = 1);

/// What a barrier of a class would do at the height of a design.
struct ClassOutcome {
    std::string energy_class;
    double mel_kj;                 ///< infinite for the open class
    std::optional<double> sel_kj;  ///< nothing where the class has none
    double height_m;
    Share held;
    Share over;
    Share through;
    bool recommended;  ///< the class of the design
};

/// All classes, weakest first; a design of the open class has its own capacity.
std::vector<ClassOutcome> outcomes_by_class(std::span<const Passage> rocks, const BarrierDesign& design);

}  // namespace coupling
