#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "coupling/assessments/nets/siting/net_design.hpp"

namespace coupling::siting {

/// What a candidate is judged by.
struct Judged {
    double distance_m = 0.0;
    std::optional<NetDesign> net;  ///< nothing: too few rocks for a design
    Left left;
};

/// The order of candidates: first those that keep the wanted share, of them those no higher than nets on
/// offer, then the weakest class, then the least area, then the nearest. Where none keeps the wanted share,
/// the least energy left below decides before class and area.
///
/// Candidates tie with the best if they keep the wanted share alike, have its class, are on offer alike
/// and not more than a tenth larger in area [choice]; where none keeps the wanted share, if the energy left
/// below differs by no more than a tenth.
struct Ranking {
    std::optional<std::size_t> best;  ///< nothing where no candidate keeps a rock
    std::vector<bool> ties;           ///< by candidate; the best is none
};

Ranking rank(std::span<const Judged> candidates, double wanted_share);

/// Whether a candidate keeps the wanted share.
bool keeps_wanted(const Judged& candidate, double wanted_share);

}  // namespace coupling::siting
