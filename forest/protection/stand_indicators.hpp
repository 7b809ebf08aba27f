#pragma once

#include <functional>

#include "forest/stand/patch.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// What foresters look at beside stems and gaps to see whether a stand will keep protecting (NaiS: cover,
/// stability of the bearing trees, regeneration, lying wood). NaN where nothing stands to be measured.
struct StandIndicators {
    double cover_percent = 0.0;         ///< crowns of trees from 12 cm on, as seen from above
    double regeneration_percent = 0.0;  ///< crowns of young growth: below 12 cm, from 0.4 m height on
    double regeneration_pha = 0.0;      ///< stems of it
    double slender_percent = 0.0;       ///< of the stems from 12 cm on, height / diameter above 90
    double slenderness = 0.0;           ///< height / diameter of the 100 thickest stems per hectare, mean [-]
    double crown_ratio_percent = 0.0;   ///< crown length / height of these, mean
    double logs_m3pha = 0.0;            ///< lying dead wood
};

/// From here on a stem counts against rocks, below it is young growth (NaiS).
inline constexpr double bearing_dbh_cm = 12.0;
/// From this height on young growth counts (NaiS: "Aufwuchs").
inline constexpr double young_growth_m = 0.4;
/// Slenderness above which a stem counts as unstable [-].
inline constexpr double slender_above = 90.0;

/// Share of the ground below crowns whose areas add up to `crown_area_share` of it, for crowns that overlap
/// at random: 1 - exp(-share) (Crookston & Stage 1999, RMRS-GTR-24). [0, 1).
double cover_of(double crown_area_share);

/// Of the patches that count. Cover is that of each patch, then the mean; crowns belong to the patch of their
/// stem. Crowns of plants below 1 cm have a fifth of their height as radius [choice].
StandIndicators indicators_of(const Stand& stand, const SpeciesTable& species,
                              const std::function<bool(const Patch&)>& counts);

}  // namespace forest
