#include "coupling/assessments/decades/tables/yearly_layouts.hpp"

#include "coupling/results/tables/figure_columns.hpp"

namespace coupling::decades {
namespace {

constexpr const char* simulated = "simulated";
constexpr const char* from_work_and_prices =
    "simulated work, prices of regimes.timber_prices and regimes.work_costs";

Column climate_column() {
    return {"climate", "text", "name of the climate; as_given: the only one, that of the settings",
            "input climate.variants"};
}

/// Which member and year a row speaks of.
std::vector<Column> member_columns() {
    return {{"regime", "text", "name of the regime", "input regimes.list"},
            climate_column(),
            {"replicate", "-",
             "number of the replicate, from 1; regimes share weather and rocks of a replicate, climates its "
             "rocks and chance",
             "run.replicates"},
            {"year", "-", "simulated years since the start; 0 is the start", simulated}};
}

Column species_column(const char* meaning) {
    return {"species", "text", meaning, "species table"};
}

Column stand_column() {
    return {"stand", "text", "number of the management unit, or all for the whole forest",
            "input stands.map"};
}

std::vector<Column> dbh_class_columns() {
    return {{"dbh_from_cm", "cm", "lower end of the class of diameter at breast height", "classes of 4 cm"},
            {"dbh_to_cm", "cm", "upper end of the class; empty: everything thicker", "classes of 4 cm"}};
}

TableLayout stands() {
    const std::vector<Column> rest{
        stand_column(),
        species_column("species code, or all"),
        {"stems_pha", "1/ha", "stems of trees of 1 cm and more", simulated},
        {"basal_area_m2pha", "m2/ha", "basal area at breast height", simulated},
        {"volume_m3pha", "m3/ha", "stem wood over bark", simulated},
        {"above_ground_tpha", "t/ha", "dry mass above ground", simulated},
        {"mean_dbh_cm", "cm", "quadratic mean diameter; 0 without trees", simulated},
        {"lorey_height_m", "m", "mean height weighted by basal area; 0 without trees", simulated},
        {"dominant_height_m", "m",
         "mean height of the 100 thickest stems per hectare, of all where there are fewer", simulated},
        {"leaf_area_index", "-", "projected leaf area over ground area", simulated},
        {"stems_from_7cm_pha", "1/ha", "stems from 7 cm diameter on", simulated},
        {"basal_area_from_7cm_m2pha", "m2/ha", "their basal area", simulated},
        {"volume_from_7cm_m3pha", "m3/ha", "their stem wood over bark", simulated},
        {"stems_from_12cm_pha", "1/ha", "stems from 12 cm diameter on", simulated},
        {"basal_area_from_12cm_m2pha", "m2/ha", "their basal area", simulated},
        {"volume_from_12cm_m3pha", "m3/ha", "their stem wood over bark", simulated},
        {"drought_index", "-",
         "share of the year's demand for water that was not met in the months above 5.5 degC, mean over the "
         "patches of the stand; empty at the start",
         simulated}};
    return {"stands.csv", "a stand, or all, and a species, or all, at the end of a year",
            together(member_columns(), rest)};
}

TableLayout dbh_classes() {
    const std::vector<Column> species{species_column("species code, or all")};
    const std::vector<Column> stems{
        {"stems_pha", "1/ha", "stems in the class, in the whole forest", simulated}};
    return {"dbh_classes.csv", "a diameter class that has stems",
            together(member_columns(), species, dbh_class_columns(), stems)};
}

TableLayout forest_years() {
    const std::vector<Column> rest{
        {"calendar_year", "-", "calendar year", "run.first_year"},
        {"volume_increment_m3pha", "m3/ha", "stem wood that the trees which began the year gained in it",
         simulated},
        {"production_tpha", "t/ha", "net primary production of the year, dry mass", simulated},
        {"ingrowth_stems_pha", "1/ha", "trees that passed 1 cm or were planted", simulated},
        {"saplings_pha", "1/ha", "young trees below 1 cm", simulated},
        {"snags_pha", "1/ha", "standing dead stems, stumps of felling included", simulated},
        {"snags_m3pha", "m3/ha", "their volume, as far as decay has left it", simulated},
        {"logs_pha", "1/ha", "lying dead stems", simulated},
        {"logs_m3pha", "m3/ha", "their volume, as far as decay has left it", simulated},
        {"dead_stems_tpha", "t/ha", "dry mass of both, as far as it has not rotted", simulated},
        {"dead_wood_class1_m3pha", "m3/ha", "volume of both in decay class 1, fresh", simulated},
        {"dead_wood_class2_m3pha", "m3/ha", "in decay class 2, hard", simulated},
        {"dead_wood_class3_m3pha", "m3/ha", "in decay class 3, soft outside", simulated},
        {"dead_wood_class4_m3pha", "m3/ha", "in decay class 4, soft", simulated},
        {"dead_wood_class5_m3pha", "m3/ha", "in decay class 5, falling to pieces", simulated},
        {"precipitation_mm", "mm", "precipitation of the year, mean of the patches",
         "input climate.file, moved to the patches"},
        {"evapotranspiration_mm", "mm", "evapotranspiration of the year", simulated},
        {"runoff_mm", "mm", "water that runs off or drains in the year", simulated},
        {"storage_gain_mm", "mm", "gain of water in soil and snow over the year", simulated},
        {"mean_temperature_degc", "degC", "mean air temperature of the year, mean of the patches",
         "input climate.file, moved to the patches"},
        {"stem_wood_tpha", "t/ha", "dry wood of living stems", simulated},
        {"stem_growth_tpha", "t/ha", "what they gained in the year", simulated},
        {"stem_ingrowth_tpha", "t/ha", "of trees that passed 1 cm", simulated},
        {"stem_losses_tpha", "t/ha", "of trees that left; in year 0 by work and rocks at the start",
         simulated},
        {"stem_hauled_tpha", "t/ha", "of these losses, felled and taken out of the forest", simulated},
        {"stem_litter_tpha", "t/ha", "of these losses, below 7 cm and not followed", simulated},
        {"dead_wood_in_tpha", "t/ha", "of these losses, now snag, stump or log", simulated},
        {"dead_wood_decayed_tpha", "t/ha", "dead wood that decay took", simulated},
        {"dead_wood_to_soil_tpha", "t/ha", "dead wood too rotten to be followed, or that rolled off",
         simulated},
        {"dead_wood_taken_tpha", "t/ha", "dead wood that was salvaged", simulated}};
    return {"forest_years.csv", "a year of the whole forest; what only a year can have is empty at the start",
            together(member_columns(), rest)};
}

TableLayout mortality() {
    const std::vector<Column> rest{
        {"cause", "text",
         "background, stress, self_thinning, wind, snow, beetle, rock, wound, felled, browsing or drought",
         simulated},
        species_column("species code"),
        {"stems_pha", "1/ha", "stems that left the forest in the year", simulated},
        {"volume_m3pha", "m3/ha", "their stem wood over bark", simulated},
        {"above_ground_tpha", "t/ha", "their dry mass above ground", simulated}};
    return {"mortality.csv", "a species in a year that lost trees of it to a cause",
            together(member_columns(), rest)};
}

std::vector<Column> tree_columns() {
    return {{"tree_id", "-", "number of the tree, kept for its life", simulated},
            {"x_m", "m", "easting of the stem", "input trees.file, or simulated"},
            {"y_m", "m", "northing of the stem", "input trees.file, or simulated"},
            species_column("species code"),
            {"dbh_cm", "cm", "diameter at breast height", simulated},
            {"height_m", "m", "height of the tree", simulated}};
}

TableLayout trees() {
    const std::vector<Column> rest{
        {"crown_base_m", "m", "height of the crown base above the ground", simulated},
        {"crown_radius_m", "m", "radius of the crown", simulated},
        {"age_years", "years", "age", simulated},
        {"light_ratio", "-", "light of the last season, 1: no neighbour shades it; empty at the start",
         simulated},
        {"vitality", "-", "0 to 1; production goes with its square root", simulated},
        {"stems", "-", "stems that the row stands for: young ones below 5 cm are kept in groups of equals",
         simulated},
        {"rock_hits", "-", "hits by the simulated rocks of this year", "counted over the simulated rocks"},
        {"rock_energy_kj", "kJ", "energy it took from the simulated rocks of this year", simulated}};
    return {"trees_YEAR.csv", "a tree, or a group of equal young ones, at the end of a year",
            together(member_columns(), tree_columns(), rest)};
}

TableLayout gaps() {
    constexpr const char* measured = "simulated, on patches of 10 m";
    const std::vector<Column> rest{
        stand_column(),
        {"area_ha", "ha", "area of the stand on the map", "input stands.map"},
        {"open_percent", "%", "of the area on patches without a living stem of 12 cm", measured},
        {"gaps", "-", "lines of open patches down the fall line that touch the stand", measured},
        {"gap_mean_m", "m", "their mean length along the ground; 0 without gaps", measured},
        {"gap_95_m", "m", "95th percentile of their lengths, linearly interpolated", measured},
        {"gap_max_m", "m", "the longest of them", measured}};
    return {"gaps.csv", "a stand, or all, at the end of a year", together(member_columns(), rest)};
}

TableLayout target_profile() {
    constexpr const char* guideline = "NaiS (Frehner et al. 2005), for the mean diameter of the rocks";
    const std::vector<Column> rest{
        stand_column(),
        {"criterion", "text", "stems_from_N_cm: stems of N cm and more; longest_gap: along the fall line",
         guideline},
        {"value", "as the unit says", "what the stand has", simulated},
        {"unit", "text", "of value and limits", "definition"},
        {"at_least", "as the unit says", "least value; empty: none", guideline},
        {"at_most", "as the unit says", "largest value; empty: none", guideline},
        {"met", "text", "yes or no", simulated},
        {"ideal", "text", "yes or no: whether the ideal number of stems is there; empty for gaps",
         simulated}};
    return {"target_profile.csv", "a criterion for a stand, or all, at the end of a year with a profile",
            together(member_columns(), rest)};
}

TableLayout causes() {
    constexpr const char* counted = "counted over the simulated rocks";
    constexpr const char* exact = "Clopper & Pearson 1934";
    const std::vector<Column> rest{
        cover_column(),
        {"cause", "text", "what ended the fall: tree, log, net, ground, left_terrain or gave_up", simulated},
        {"rocks", "-", "rocks that fell", counted},
        {"stopped", "-", "rocks whose fall it ended", counted},
        {"share_percent", "%", "of the rocks that fell", counted},
        {"share_low_percent", "%", "lower end of the 95 % interval", exact},
        {"share_high_percent", "%", "upper end of the 95 % interval", exact}};
    return {"causes.csv", "a cause on one slope in a year with rocks", together(member_columns(), rest)};
}

TableLayout interventions() {
    const std::vector<Column> rest{
        {"intervention", "text", "name of the row of the regime", "input regimes.list"},
        {"treatment", "text", "kind of treatment", "input regimes.list"},
        {"areas", "-", "areas that it came to", simulated},
        {"area_ha", "ha", "their area; of a group cut that of the holes", simulated},
        {"stems", "-", "stems felled, of salvage taken, in the whole forest", simulated},
        {"taken_m3", "m3", "stem wood over bark that left the forest", simulated},
        {"left_m3", "m3", "stem wood that stayed as logs and stumps", simulated},
        {"plants", "-", "trees planted", simulated},
        {"guarded", "-", "of these, with a guard each", simulated},
        {"tended", "-", "young stems cut by tending", simulated},
        {"fenced_ha", "ha", "area that is fenced longer than before", simulated},
        {"found_nothing", "text", "yes: it was due but found nothing to do", simulated}};
    return {"interventions.csv", "an intervention that was due", together(member_columns(), rest)};
}

TableLayout timber() {
    const std::vector<Column> species{species_column("species code")};
    const std::vector<Column> rest{
        {"stems", "-", "stems felled, in the whole forest", simulated},
        {"taken_m3", "m3", "their stem wood over bark that left the forest", simulated},
        {"left_m3", "m3", "their stem wood that stayed as logs and stumps", simulated}};
    return {"timber.csv", "a species and diameter class that was felled in a year",
            together(member_columns(), species, dbh_class_columns(), rest)};
}

TableLayout margins() {
    const std::vector<Column> rest{
        {"revenue_eur_pha", "EUR/ha", "revenue of the wood sold", from_work_and_prices},
        {"harvest_cost_eur_pha", "EUR/ha", "cost of felling and hauling", from_work_and_prices},
        {"young_growth_cost_eur_pha", "EUR/ha", "cost of planting, tending and fencing",
         from_work_and_prices},
        {"contribution_margin_eur_pha", "EUR/ha", "revenue less these costs, without overhead",
         from_work_and_prices}};
    return {"margins.csv", "a year with work", together(member_columns(), rest)};
}

TableLayout work_by_year() {
    const std::vector<Column> rest{
        {"felled_m3pha", "m3/ha", "stem wood of living trees that were cut, taken or left", simulated},
        {"salvaged_m3pha", "m3/ha", "stem wood of dead trees that salvage worked up, taken or left",
         simulated},
        {"removed_m3pha", "m3/ha", "stem wood that left the forest; felled + salvaged = removed + left",
         simulated},
        {"left_m3pha", "m3/ha", "felled or salvaged stem wood that stayed as logs and stumps", simulated},
        {"revenue_eur_pha", "EUR/ha", "revenue of the wood sold", from_work_and_prices},
        {"harvest_cost_eur_pha", "EUR/ha", "cost of felling and hauling", from_work_and_prices},
        {"young_growth_cost_eur_pha", "EUR/ha", "cost of planting, tending and fencing",
         from_work_and_prices},
        {"contribution_margin_eur_pha", "EUR/ha", "revenue less these costs, without overhead",
         from_work_and_prices},
        {"machine_hours_pha", "h/ha", "to bring the removed wood out", "input regimes.machine_m3_per_hour"},
        {"cable_setups", "-", "corridors in the whole forest from which timber was taken", simulated}};
    return {"work_by_year.csv", "a year, also one without work; per hectare of the whole forest",
            together(member_columns(), rest)};
}

TableLayout removed_trees() {
    const std::vector<Column> reason{
        {"reason", "text",
         "rock: broken or uprooted by a rock; wound: died of an old wound; others as in mortality.csv",
         simulated}};
    return {
        "removed_trees.csv",
        "a tree of 7 cm and more that rocks or old wounds took, or any cause with output.all_removed_trees",
        together(member_columns(), tree_columns(), reason)};
}

TableLayout protection() {
    return {"protection.csv", "a target in a year with rocks",
            together(member_columns(), target_columns(), protection_columns())};
}

TableLayout targets() {
    const std::vector<Column> cover{cover_column()};
    return {"targets.csv", "a target on one slope in a year with rocks",
            together(member_columns(), target_columns(), cover, arrival_columns())};
}

TableLayout runs() {
    const std::vector<Column> cover{cover_column()};
    return {"runs.csv", "a slope in a year with rocks", together(member_columns(), cover, slope_columns())};
}

Column regime_column() {
    return member_columns().front();
}

/// The figure that rows of the comparison of regimes speak of.
std::vector<Column> figure_columns() {
    return {
        {"target_id", "text", "target of the figure; empty for figures of the forest", "input targets.file"},
        {"quantity", "text", "the figure, its unit at the end, such as protection_percent", "definition"}};
}

std::vector<Column> band_columns() {
    constexpr const char* over_replicates = "over the replicates";
    constexpr const char* students_t = "over the replicates, Student's t; from five on Hall (1992)";
    return {{"replicates", "-", "replicates that know the figure", over_replicates},
            {"mean", "as the quantity says", "mean of the replicates", over_replicates},
            {"mean_low_90", "as the quantity says",
             "lower end of the 90 % interval of the mean; empty for one replicate and where all are equal",
             students_t},
            {"mean_high_90", "as the quantity says", "upper end of the same", students_t},
            {"low_5", "as the quantity says",
             "5th percentile of the replicates, linearly interpolated; empty for fewer than ten",
             over_replicates},
            {"high_95", "as the quantity says", "95th percentile, likewise", over_replicates},
            {"least", "as the quantity says", "lowest replicate", over_replicates},
            {"most", "as the quantity says", "highest replicate", over_replicates}};
}

TableLayout regimes_by_year() {
    return {"regimes_by_year.csv", "a figure of a regime in a year",
            together(std::vector<Column>{regime_column(), climate_column()}, figure_columns(),
                     std::vector<Column>{member_columns().back()}, band_columns())};
}

TableLayout regimes_worst_year() {
    const std::vector<Column> which{
        {"worst", "text", "lowest or highest: which extreme is bad", "definition"},
        {"year", "-", "the year in which the mean of the replicates is worst; the first of several",
         simulated}};
    return {"regimes_worst_year.csv", "a figure of a regime in its worst year",
            together(std::vector<Column>{regime_column(), climate_column()}, figure_columns(), which,
                     band_columns())};
}

std::vector<Column> difference_columns(const char* known_in_both, const char* of_what) {
    constexpr const char* paired = "pairs of replicates, Student's t";
    return {
        {"pairs", "-", known_in_both, paired},
        {"mean_difference", "as the quantity says", of_what, paired},
        {"low_95", "as the quantity says", "lower end of its 95 % interval; empty for one pair", paired},
        {"high_95", "as the quantity says", "upper end of its 95 % interval; empty for one pair", paired},
        {"replicates_needed", "-",
         "replicates from which on the interval of such a difference leaves 0 out; empty: not known, or more "
         "than 100 000",
         paired}};
}

TableLayout regime_differences() {
    const std::vector<Column> reference{
        {"reference", "text", "the regime it is compared with: the first of the list", "input regimes.list"}};
    return {"regime_differences.csv",
            "a figure of a regime in a year, minus that of the first regime in the same climate",
            together(std::vector<Column>{regime_column(), climate_column()}, reference, figure_columns(),
                     std::vector<Column>{member_columns().back()},
                     difference_columns("replicates that know the figure in both regimes",
                                        "mean over the pairs of regime minus reference"))};
}

TableLayout climate_differences() {
    const std::vector<Column> reference{{"reference", "text",
                                         "the climate it is compared with: the first of the table",
                                         "input climate.variants"}};
    return {"climate_differences.csv",
            "a figure of a regime in a climate and year, minus that of the same regime in the first climate",
            together(std::vector<Column>{regime_column(), climate_column()}, reference, figure_columns(),
                     std::vector<Column>{member_columns().back()},
                     difference_columns("replicates that know the figure in both climates",
                                        "mean over the pairs of climate minus reference"))};
}

}  // namespace

const std::vector<TableLayout>& yearly_layouts() {
    static const std::vector<TableLayout> layouts{stands(),
                                                  dbh_classes(),
                                                  forest_years(),
                                                  mortality(),
                                                  trees(),
                                                  interventions(),
                                                  timber(),
                                                  margins(),
                                                  work_by_year(),
                                                  removed_trees(),
                                                  protection(),
                                                  targets(),
                                                  runs(),
                                                  causes(),
                                                  gaps(),
                                                  target_profile(),
                                                  regimes_by_year(),
                                                  regimes_worst_year(),
                                                  regime_differences(),
                                                  climate_differences()};
    return layouts;
}

}  // namespace coupling::decades
