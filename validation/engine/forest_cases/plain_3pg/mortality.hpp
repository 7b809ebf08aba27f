#pragma once

#include <vector>

#include "validation/engine/forest_cases/plain_3pg/stand.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

/// Thinnings that are still to come: of each species the next one is due when its age is reached, one a month
/// at most.
class ThinningList {
public:
    explicit ThinningList(const Inputs& inputs);
    /// Takes out what is due this month.
    void thin(Stand& stand, const Inputs& inputs, int month);

private:
    std::vector<std::vector<Thinning>> due_;  ///< by species, in order of age
    std::vector<std::size_t> next_;
};

/// Random death at the rate of the species' age; none in dormant months.
void die_at_random(Stand& stand, const Inputs& inputs, int month);

/// Death by crowding where the mean tree is heavier than its species' limit at this density; none in dormant
/// months.
void thin_themselves(Stand& stand, const Inputs& inputs, int month);

/// Trees [1/ha] that must die so that `stem_tpha` on the others meets the limit.
///
/// At most five of Newton's steps, as in 3-PG; the last of them is below one tree.
double self_thinned_pha(double stems_pha, double stem_tpha, double lost_stem, const SelfThinning& limit);

}  // namespace coupling::validation::forest_cases::plain_3pg
