#pragma once

#include "forest/stand/species.hpp"
#include "forest/stand/tree.hpp"

namespace forest {

/// Diameter of the crown of a forest tree [m] (SILVA, Pretzsch et al.). Requires a diameter and a height
/// above 0.
double crown_diameter_m(const Crown& shape, double dbh_cm, double height_m);

/// Height of the crown's base in a managed forest of usual density [m] (SILVA): [0, 0.88 H]. The law holds
/// for slenderness H / D up to 100 m/m, as its data do; more slender trees have the crown of one of 100.
double usual_crown_base_m(const Crown& shape, double dbh_cm, double height_m);

/// The crown of a tree of unknown past: of usual length.
TreeCrown starting_crown(const Species& species, double dbh_cm, double height_m);

/// What a crown depends on in a year.
struct CrownYear {
    double dbh_cm = 0.0;           ///< after the year
    double height_m = 0.0;         ///< after the year
    double height_growth_m = 0.0;  ///< >= 0
    double light_ratio = 1.0;      ///< [0, 1]
    double shaded_below_m = 0.0;  ///< height below which there is too little light for leaves of this species
};

/// The crown after a year [choice].
///
/// The base rises, never sinks, towards the larger of two heights: the usual one, up to 12.5 % higher in deep
/// shade and lower in full light, and the one below which there is too little light for a branch. It rises by
/// at most the height growth and 0.3 m, so a tree that is suddenly crowded needs years to lose its branches,
/// and one that is freed never regrows them. At least 12 % of the height stays crown. Foliage is proportional
/// to the length of the crown relative to the usual one, within 0.4 and 1.1.
TreeCrown next_crown(const Species& species, const TreeCrown& crown, const CrownYear& year);

}  // namespace forest
