#pragma once

#include <cstdint>
#include <vector>

#include "rockfall/obstacles/stem.hpp"
#include "validation/engine/slope/recipe.hpp"

namespace coupling::validation {

/// A stretch of slope in plan: x along the profile, y from its axis.
struct StandArea {
    double from_m = 0.0;
    double to_m = 0.0;
    double width_m = 0.0;  ///< y from -width / 2 to width / 2

    [[nodiscard]] double hectares() const { return 1e-4 * (to_m - from_m) * width_m; }
};

/// A tree of an artificial stand.
struct ArtificialTree {
    rockfall::Stem stem;  ///< in plan coordinates of the recipe
    std::size_t species;  ///< place in the recipe's list of species
};

/// Height of a tree by its DBH: 1.3 m + dbh^2 / (1.54 + 0.17 dbh)^2, DBH in cm (form of Naslund 1936;
/// constants: choice for a mixed mountain forest, 22 m at 31 cm, 27 m at 60 cm).
double height_of_dbh_m(double dbh_cm);

/// Stands that have the published statistics of one whose trees are not public.
///
/// As many trees as stems/ha give; their DBHs are the quantiles of the gamma distribution at equal steps, so
/// each stand has its mean and deviation; places are drawn evenly over the area, none nearer to another than
/// the spacing; species are given tree by tree to the one that lacks most of its share of the basal area.
class ArtificialStands {
public:
    /// Requires a recipe with a stand, which must outlive this.
    ArtificialStands(const Recipe& recipe, const StandArea& area);

    /// Stand number k, from its own random stream. Throws InputError (settings) if no place is left for a
    /// tree.
    [[nodiscard]] std::vector<ArtificialTree> draw(std::uint32_t stand) const;

private:
    const Recipe& recipe_;
    StandArea area_;
    std::vector<double> dbhs_cm_;  ///< rising
};

/// The stems alone.
std::vector<rockfall::Stem> stems_of(const std::vector<ArtificialTree>& trees);

}  // namespace coupling::validation
