#pragma once

#include "forest/climate/series.hpp"
#include "forest/regeneration/ground_cover.hpp"
#include "forest/stand/species.hpp"

namespace forest {

// What decides whether a seed becomes a seedling of 5 cm, each a chance on [0, 1] (iLand, after TACA of
// Nitschke & Innes 2008, on monthly climate; light limits of ForClim).

/// Growth of young trees by degree-days above 5.5 degC: 1 - exp(-0.0013 (GDD - least)) (Bugmann & Solomon
/// 2000), beyond the middle between least and most times the parabola 4 (GDD - least)(most - GDD) / (most -
/// least)^2 (Bugmann 1994).
double degree_day_response(const Response& species, double degree_days);

/// Whether the year's climate lets seedlings of a species survive: 0 beyond one of its limits, else 1 but
/// for late frost, which leaves tolerance^sqrt(n), n the frost days to be expected between bud burst and
/// July.
///
/// Limits: mean daily minimum and mean of the coldest month, chilling days (-5 to 5 degC, days scattered by
/// 4 K), degree-days above the species' base, days without frost.
double climate_chance(const Species& species, const ClimateYear& year);

/// (L - least) / (least + 0.1) of the ground's light [choice], 0 below the species' least light (ForClim).
double light_chance(const Light& species, double ground_light);

/// 1 - drought / tolerated drought [choice]. `drought` is that of the species: how far its stomata were
/// closed over the growing season (SpeciesDrought) [0, 1].
double water_chance(double drought);

/// Where it is colder than in the montane belt, seedlings want two hours of sun a day in June: hours / 2
/// within 0.2 and 1 (practice of NaiS), 1 below.
double sun_chance(double degree_days, double june_sun_hours);

/// Share of seeds that become seedlings on the parts of a seed bed, each times its part of the ground.
struct SeedBed {
    double ground = 0.0;
    double wood = 0.0;
};

/// 3.8 % of seeds germinate on litter (Kupferschmid et al. 2002, spruce), none under fresh wood; on rotten
/// wood 10 (evergreen conifers) or 5 (others) times as many [choice] (Bujoczek et al. 2015: 30 % of seedlings
/// on 4 % of the ground); under tall herbs 0.2 of all that [choice].
SeedBed seed_bed(const Species& species, const GroundCover& cover);

}  // namespace forest
