#pragma once

#include <vector>

#include "forest/stand/stand.hpp"

namespace forest {

/// What covers the ground of a patch, shares [0, 1].
struct GroundCover {
    double herbs = 0.0;        ///< of what no wood covers
    double rotten_wood = 0.0;  ///< logs and stumps that have lost half of their density or more
    double fresh_wood = 0.0;   ///< other logs, in their first ten years with as much ground under branches
};

/// What covers the ground of each patch.
std::vector<GroundCover> ground_covers(const Stand& stand);

/// Ground cover after a year [choice]: herbs spread over four years, from the second with more than 0.3 of
/// the open light on, and vanish below 0.15.
PatchState after_year_of_herbs(PatchState state);

/// Share of each patch on which trees that fell in the year before lay or lie, by storm or saw [0, 1]: each
/// takes twice the ground of its stem [choice], and they fall on each other, too.
std::vector<double> crushed_shares(const Stand& stand);

}  // namespace forest
