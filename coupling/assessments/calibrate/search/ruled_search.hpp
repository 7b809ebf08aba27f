#pragma once

#include <functional>
#include <span>
#include <vector>

#include "coupling/assessments/calibrate/search/search.hpp"
#include "coupling/inputs/scenario/calibrate_settings.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::calibrate {

/// A search for models of which each set takes long: history matching, then rejection within what is left.
///
/// After each round polynomials are fitted to the summaries of all sets so far (emulator), and what they say
/// cannot show what was observed is ruled out (ruling). The sets of the next round are drawn by the widths
/// from what is left, and a twentieth of them from what is ruled out: so nothing is lost for good, and how
/// often the emulators were wrong is counted. Sets of all rounds count, the first one included, where they
/// are within the goal of the scale at their mean; each by the density by the widths over that from which all
/// rounds together drew (balance heuristic: Veach & Guibas 1995; Owen & Zhou 2000). Within what is left all
/// weigh the same.
///
/// The goal is that of `search`. It ends with calibrate.sets kept ones, or at calibrate.most_sets: then it
/// came close if `least_sample` or more are within the goal.
void ruled_search(const Simulator& simulator, const SearchPlan& plan, SearchState& state,
                  const std::function<void(const SearchState&)>& keep,
                  const std::function<void(std::uint64_t sets)>& moved);

/// Whether a search goes this way: where it is chosen, or by itself for a motion model whose rocks have a
/// shape.
bool emulates(Emulates chosen, rockfall::MotionModel model);

/// So many sets within the goal are a sample at the end of the budget: the least calibrate.sets.
inline constexpr std::uint64_t least_sample = 50;

/// Density by the widths over that from which all rounds drew, up to a constant: the weight of a set.
/// `first_sets`: drawn by the widths alone. `rounds`, `rulings`: see Ruled, both of the same length.
double mixture_weight(const Point& point, std::uint64_t first_sets, std::span<const RuledRound> rounds,
                      std::span<const Ruling> rulings);

/// What emulators of an observation did in a search with them.
struct RuledOut {
    std::size_t observation = 0;  ///< its place
    double share = 0.0;           ///< of what the widths allow, ruled out by this observation alone [-]
    double explained = 0.0;       ///< Emulator::explained of its best figure, in the first ruling
};

/// Of each observation that is fitted to. None without rulings.
std::vector<RuledOut> ruled_out_of(const Simulator& simulator, const Ruled& ruled);

}  // namespace coupling::calibrate
