#include "forest/parameters.hpp"

namespace forest {

namespace {

void declare_mortality(config::Options& options, MortalityLaw& law) {
    options.choice("forest.age_deaths", law.age,
                   {{"rising", AgeLaw::rising}, {"gap_model", AgeLaw::gap_model}},
                   {.meaning = "deaths by age: rising with size and age, or the constant rate of gap models",
                    .source = "choice; JABOWA, ForClim, iLand",
                    .needs = {{"forest.background_deaths"}}});
    options.number("forest.canopy_death", law.canopy.when_old,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 0.1,
                    .meaning = "probability of an old tree of any size to die in a year, half of it at 0.35 "
                               "of the greatest age; with storms nine tenths of it",
                    .source = "fitted to validation/forest_old; form: choice",
                    .needs = {{"forest.background_deaths"}, {"forest.age_deaths", {"rising"}}}});
    options.number(
        "forest.canopy_death_any_age", law.canopy.at_any_age,
        {.unit = "-",
         .low = 0.0,
         .high = 5.0,
         .meaning = "added to it at any age: this share of 1 / greatest age, more under thicker trees "
                    "(e-fold with 50 m2/ha)",
         .source = "fitted to Guyennon et al. 2023 (validation/forest_demography)",
         .needs = {{"forest.background_deaths"}, {"forest.age_deaths", {"rising"}}}});
    options.number("forest.canopy_death_by_density", law.canopy.by_density,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 4.0,
                    .meaning = "it is multiplied by 0.2 + (basal area / 37 m2/ha) to this power, at most 2.5",
                    .source = "choice; direction: Guyennon et al. 2023",
                    .needs = {{"forest.background_deaths"}, {"forest.age_deaths", {"rising"}}}});
    options.number(
        "forest.canopy_death_by_warmth", law.canopy.by_warmth,
        {.unit = "-",
         .low = 0.0,
         .high = 0.1,
         .meaning = "part by which canopy deaths change with 100 degree-days; they are usual at 1300, "
                    "and 0.6 to 1.4 times that",
         .source = "Stephenson & van Mantgem 2005",
         .needs = {{"forest.background_deaths"}, {"forest.age_deaths", {"rising"}}}});
    options.number("forest.canopy_death_by_size", law.canopy.by_size,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 0.5,
                    .meaning = "added to it at a diameter of 1 m, falling with its sixth power, conifers; "
                               "broadleaves 3 times; with storms nine tenths of it",
                    .source = "choice; Holzwarth et al. 2013",
                    .needs = {{"forest.background_deaths"}, {"forest.age_deaths", {"rising"}}}});
    options.number(
        "forest.suppression_death", law.suppression.in_full_shade,
        {.unit = "-",
         .low = 0.0,
         .high = 1.0,
         .meaning = "probability of a very thin tree without light to die in a year; 0.3 of it in full "
                    "light; falls with diameter",
         .source = "choice; Holzwarth et al. 2013, Guyennon et al. 2023",
         .needs = {{"forest.stress_deaths"}}});
    options.number("forest.suppression_dbh", law.suppression.dbh_scale_cm,
                   {.unit = "cm",
                    .low = 1.0,
                    .high = 500.0,
                    .meaning = "diameter by which that probability has fallen to 1/e",
                    .source = "choice",
                    .needs = {{"forest.stress_deaths"}}});
    options.number("forest.drought_death", law.drought.at_full_drought,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "probability of a tree to die in a year in which its stomata never open for "
                               "want of water; 0 while they are closed for less than 42 % of the season",
                    .source = "choice"});
    options.flag("forest.background_deaths", law.background,
                 {.meaning = "trees die of age", .source = "choice"});
    options.flag("forest.stress_deaths", law.stress,
                 {.meaning = "trees die after years without growth", .source = "Bugmann 1994"});
    options.number("forest.stress_growth_cm", law.least_growth_cm,
                   {.unit = "cm",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "a year with less diameter growth counts as bad",
                    .source = "Bugmann 1994"});
    options.number(
        "forest.stress_relative_growth", law.least_relative_growth,
        {.unit = "-",
         .low = 0.0,
         .high = 1.0,
         .meaning =
             "a year with less than this share of the mean growth of its species nearby counts as bad, too",
         .source = "Bugmann 1994"});
    options.number("forest.stress_relative_growth_by_class", law.least_relative_growth_by_class,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 0.1,
                    .meaning = "added to that share with each step of the light-response class, 1 to 9",
                    .source = "choice"});
    options.count("forest.stress_years", law.bad_years,
                  {.unit = "years",
                   .low = 1.0,
                   .high = 50.0,
                   .meaning = "bad years in a row after which a tree may die of stress",
                   .source = "Bugmann 1994",
                   .needs = {{"forest.stress_deaths"}}});
    options.number("forest.stress_death", law.stress_death,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "probability to die of stress in each year after that, most tolerant species",
                    .source = "choice",
                    .needs = {{"forest.stress_deaths"}}});
    options.number("forest.stress_death_by_class", law.stress_death_by_class,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 0.1,
                    .meaning = "added to it with each step of the light-response class, 1 to 9",
                    .source = "choice",
                    .needs = {{"forest.stress_deaths"}}});
}

void declare_regeneration(config::Options& options, RegenerationLaw& law) {
    options.number("forest.browsing_pressure", law.browsing_pressure,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 10.0,
                    .meaning = "deer: 0 fenced, 1 normal, 3 high; multiplies the odds of being browsed",
                    .source = "iLand; levels: choice",
                    .needs = {{"forest.regeneration"}}});
    options.number("forest.seeds_from_outside", law.outside.share,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "seeds from outside the area, as a share of a species' fecundity",
                    .source = "choice",
                    .needs = {{"forest.regeneration"}}});
}

void declare_uprooting(config::Options& options, UprootingLaw& law) {
    options.number("forest.uprooting", law.deep_soil,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "probability that a tree which fails under a rock is uprooted, not broken",
                    .source = "choice"});
    options.number("forest.uprooting_on_shallow_soil", law.shallow_soil,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "the same on soils that hold at most 70 mm of water",
                    .source = "choice"});
}

void declare_disturbance(config::Options& options, DisturbanceLaw& law) {
    options.flag("disturbance.wind", law.wind,
                 {.meaning = "storms uproot or break trees", .source = "Barrere et al. 2023; off: choice"});
    options.flag("disturbance.snow", law.snow,
                 {.meaning = "wet snow breaks slender conifers; by the days near 0 degC of each winter",
                  .source = "choice"});
    options.flag("disturbance.beetle", law.beetle,
                 {.meaning = "bark beetles kill spruces of 15 cm and more",
                  .source = "iLand bark beetle module, PHENIPS; off: choice"});
    options.number("disturbance.storm_interval", law.storm_interval_years,
                   {.unit = "years",
                    .low = 1.0,
                    .high = 10'000.0,
                    .meaning = "mean time from one storm year to the next",
                    .source = "Barrere et al. 2023",
                    .needs = {{"disturbance.wind"}}});
    options.number("disturbance.wet_snow", law.wet_snow_chance,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "probability of heavy wet snow in a year",
                    .source = "choice",
                    .needs = {{"disturbance.snow"}}});
    options.number(
        "disturbance.beetle_in_windthrow", law.beetle_in_windthrow,
        {.unit = "-",
         .low = 0.0,
         .high = 1.0,
         .meaning = "probability that beetles breed in windthrown spruces of a patch which still lie there a "
                    "year later",
         .source = "choice; iLand takes 0.8",
         .needs = {{"disturbance.beetle"}}});
    options.number(
        "disturbance.beetle_background", law.beetle_background,
        {.unit = "1/ha/year",
         .low = 0.0,
         .high = 0.99,
         .meaning = "probability that beetles start without a storm, on a hectare with spruces; more in warm "
                    "and in dry years",
         .source = "fit to losses in Switzerland; iLand 0.000685",
         .needs = {{"disturbance.beetle"}}});
    options.whole_numbers("disturbance.storm_years", law.storm_years,
                          {.unit = "yr",
                           .low = 0.0,
                           .high = 9999.0,
                           .meaning = "calendar years in which a storm comes for sure, in all replicates, "
                                      "regimes and climates, also without disturbance.wind"});
    options.number("disturbance.storm_years_intensity", law.intensity_asked_for,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "intensity of these storms; of storms by chance 0.23 on average, and 0.6 or "
                               "more of one in 30",
                    .source = "choice",
                    .needs = {{"disturbance.storm_years"}}});
    options.whole_numbers("disturbance.beetle_years", law.beetle_years,
                          {.unit = "yr",
                           .low = 0.0,
                           .high = 9999.0,
                           .meaning = "calendar years in which bark beetles come in from outside, in all "
                                      "replicates, regimes and climates; what they begin goes on in the "
                                      "years after",
                           .needs = {{"disturbance.beetle"}}});
    options.number(
        "disturbance.beetle_years_pha", law.beetle_years_pha,
        {.unit = "1/ha",
         .low = 0.0,
         .high = 0.99,
         .meaning = "probability of beetles from outside on a hectare with spruces in such a year; "
                    "more in warm and in dry years; never less than disturbance.beetle_background",
         .source = "choice",
         .needs = {{"disturbance.beetle_years"}}});
    options.count("disturbance.first_year", law.first_year,
                  {.unit = "yr",
                   .low = 0.0,
                   .high = 9999.0,
                   .meaning = "calendar year in which storms, snow and beetles begin; 0: first of the run",
                   .source = "choice"});
}

void declare_differences(config::Options& options, TreeDifferences& law) {
    options.number("forest.growth_spread", law.growth,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 1.0,
                    .meaning = "how much trees of one species, size and place differ in growth for life: "
                               "standard deviation of the logarithm of a tree's share; 0: not at all",
                    .source = "fitted to validation/forest_hauersteig; form: choice"});
}

}  // namespace

void declare(config::Options& options, Parameters& parameters) {
    options.flag("forest.water", parameters.processes.water,
                 {.meaning = "soil water limits production and young trees; off: water is never short",
                  .source = "choice"});
    declare_differences(options, parameters.differences);
    declare_mortality(options, parameters.mortality);
    options.flag("forest.self_thinning", parameters.processes.self_thinning,
                 {.meaning = "trees die of crowding: no window of 50 m is denser than its species can be",
                  .source = "French national inventory, after matreex"});
    declare_regeneration(options, parameters.regeneration);
    declare_uprooting(options, parameters.uprooting);
    declare_disturbance(options, parameters.disturbance);
    options.flag("forest.regeneration", parameters.processes.regeneration,
                 {.meaning = "seeds fall, young trees grow", .source = "choice"});
    options.flag("forest.co2_response", parameters.processes.co2_response,
                 {.meaning = "production and transpiration follow the CO2 of the air; off: as at 350 ppm",
                  .source = "Forrester & Tang 2016; off: choice, as the responses are uncertain"});
}

}  // namespace forest
