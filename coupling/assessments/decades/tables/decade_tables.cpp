#include "coupling/assessments/decades/tables/decade_tables.hpp"

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/tables/member_columns.hpp"

namespace coupling::decades {
namespace {

using config::joined;

MemberTable<StandRow> stands() {
    using Figures = forest::StandFigures;
    const auto from = [](std::size_t limit) {
        return [limit](const Figures& figures) { return &figures.from[limit]; };
    };
    using Thick = forest::ThickTrees;
    using Young = forest::YoungFigures;
    return {
        "stands.csv",
        "What stands each year, by species and stand: stems, basal area, volume, heights.",
        "a stand, or all, and a species, or all, at the end of a year",
        {member_columns<StandRow>(),
         unit_column<StandRow>(),
         species_column<StandRow>("species code, or all"),
         {ColumnsOf<Figures>{
              {"stems_pha", 1, "stems of trees of 1 cm and more", &Figures::stems_pha},
              {"basal_area_m2pha", 3, "basal area at breast height", &Figures::basal_area_m2pha},
              {"volume_m3pha", 2, "stem wood over bark", &Figures::volume_m3pha},
              {"above_ground_tpha", 3, "dry mass above ground", &Figures::above_ground_tpha},
              {"mean_dbh_cm", 2, "quadratic mean diameter; 0 without trees", &Figures::mean_dbh_cm},
              {"lorey_height_m", 2, "mean height weighted by basal area; 0 without trees",
               &Figures::lorey_height_m},
              {"dominant_height_m", 2,
               "mean height of the 100 thickest stems per hectare, of all where there are fewer",
               &Figures::dominant_height_m},
              {"leaf_area_index", 3, "projected leaf area over ground area", &Figures::leaf_area_index},
              {ColumnsOf<Thick>{
                   {"stems_from_7cm_pha", 1, "stems from 7 cm diameter on", &Thick::stems_pha},
                   {"basal_area_from_7cm_m2pha", 3, "their basal area", &Thick::basal_area_m2pha},
                   {"volume_from_7cm_m3pha", 2, "their stem wood over bark", &Thick::volume_m3pha}},
               from(0)},
              {ColumnsOf<Thick>{
                   {"stems_from_12cm_pha", 1, "stems from 12 cm diameter on", &Thick::stems_pha},
                   {"basal_area_from_12cm_m2pha", 3, "their basal area", &Thick::basal_area_m2pha},
                   {"volume_from_12cm_m3pha", 2, "their stem wood over bark", &Thick::volume_m3pha}},
               from(1)}},
          &StandRow::figures},
         {"drought_index", 3,
          "share of the year's demand for water that was not met in the months above 5.5 degC, mean over the "
          "patches of the stand; empty at the start",
          &StandRow::drought_index},
         {ColumnsOf<Young>{
              {"saplings_pha", 1, "young trees below 1 cm", &Young::saplings_pha},
              {"saplings_from_20cm_pha", 1, "of these, 0.2 m tall and more", &Young::from_20cm_pha},
              {"saplings_on_wood_pha", 1, "of the saplings, on rotten logs and stumps", &Young::on_wood_pha},
              {"saplings_in_reach_pha", 1, "of the saplings, 0.1 to 1.3 m tall: in the reach of deer",
               &Young::in_reach_pha},
              {"saplings_browsed_pha", 1, "of these, whose leading shoot deer took within the year",
               &Young::browsed_pha}},
          &StandRow::young}}};
}

/// The stems of a diameter class.
struct ClassRow {
    std::int32_t year;
    std::uint32_t species;
    std::size_t dbh_class;
    double stems_pha;
};

MemberTable<ClassRow> dbh_classes() {
    return {"dbh_classes.csv",
            "Stems by species and diameter class of 4 cm each year.",
            "a diameter class that has stems",
            {member_columns<ClassRow>(),
             species_column<ClassRow>("species code, or all"),
             dbh_class_columns<ClassRow>(),
             {"stems_pha", 2, "stems in the class, in the whole forest", &ClassRow::stems_pha}}};
}

/// Of the whole forest; classes without stems are left out.
void add_classes(const MemberYears& member, const auto& add) {
    for (const StandRow& stand : member.stands) {
        for (std::size_t c = 0; stand.unit == all && c < forest::dbh_classes; ++c) {
            if (const double stems_pha = stand.figures.stems_pha_by_class[c]; stems_pha > 0.0) {
                add(ClassRow{stand.year, stand.species, c, stems_pha});
            }
        }
    }
}

ColumnsOf<YearRow> wood_budget_columns() {
    return {
        {"stem_wood_tpha", 4, "dry wood of living stems", &YearRow::stem_wood_tpha},
        {"stem_growth_tpha", 4, "what they gained in the year", &YearRow::stem_growth_tpha},
        {"stem_ingrowth_tpha", 4, "of trees that passed 1 cm", &YearRow::stem_ingrowth_tpha},
        {"stem_losses_tpha", 4, "of trees that left; in year 0 by work and rocks at the start",
         &YearRow::stem_losses_tpha},
        {"stem_hauled_tpha", 4, "of these losses, felled and taken out of the forest",
         &YearRow::stem_hauled_tpha},
        {"stem_litter_tpha", 4, "of these losses, below 7 cm and not followed", &YearRow::stem_litter_tpha},
        {"dead_wood_in_tpha", 4, "of these losses, now snag, stump or log", &YearRow::dead_wood_in_tpha},
        {"dead_wood_decayed_tpha", 4, "dead wood that decay took", &YearRow::dead_wood_decayed_tpha},
        {"dead_wood_to_soil_tpha", 4, "dead wood too rotten to be followed, or that rolled off",
         &YearRow::dead_wood_to_soil_tpha},
        {"dead_wood_taken_tpha", 4, "dead wood that was salvaged", &YearRow::dead_wood_taken_tpha}};
}

ColumnsOf<YearRow> dead_wood_columns() {
    const auto in_class = [](std::size_t decay_class) {
        return [decay_class](const YearRow& year) { return year.dead_wood_m3pha[decay_class]; };
    };
    return {
        {"saplings_pha", 1, "young trees below 1 cm", &YearRow::saplings_pha},
        {"snags_pha", 2, "standing dead stems, stumps of felling included", &YearRow::snags_pha},
        {"snags_m3pha", 3, "their volume, as far as decay has left it", &YearRow::snags_m3pha},
        {"logs_pha", 2, "lying dead stems", &YearRow::logs_pha},
        {"logs_m3pha", 3, "their volume, as far as decay has left it", &YearRow::logs_m3pha},
        {"dead_stems_tpha", 3, "dry mass of both, as far as it has not rotted", &YearRow::dead_stems_tpha},
        {"dead_wood_class1_m3pha", 3, "volume of both in decay class 1, fresh", in_class(0)},
        {"dead_wood_class2_m3pha", 3, "in decay class 2, hard", in_class(1)},
        {"dead_wood_class3_m3pha", 3, "in decay class 3, soft outside", in_class(2)},
        {"dead_wood_class4_m3pha", 3, "in decay class 4, soft", in_class(3)},
        {"dead_wood_class5_m3pha", 3, "in decay class 5, falling to pieces", in_class(4)}};
}

MemberTable<YearRow> forest_years() {
    constexpr const char* weather = "input climate.file, moved to the patches";
    const auto after_start = [](const YearRow& year) { return year.year == 0 ? nullptr : &year; };
    return {
        "forest_years.csv",
        "Growth, ingrowth, saplings, dead wood, water, weather and the budget of wood of each year.",
        "a year of the whole forest; what only a year can have is empty at the start",
        {member_columns<YearRow>(),

         {"calendar_year", "calendar year", "run.first_year", &YearRow::calendar_year},
         {ColumnsOf<YearRow>{
              {"volume_increment_m3pha", 3, "stem wood that the trees which began the year gained in it",
               &YearRow::volume_increment_m3pha},
              {"production_tpha", 3, "net primary production of the year, dry mass",
               &YearRow::production_tpha},
              {"ingrowth_stems_pha", 1, "trees that passed 1 cm or were planted",
               &YearRow::ingrowth_stems_pha}},
          after_start},
         dead_wood_columns(),
         {ColumnsOf<YearRow>{
              {"precipitation_mm", 1, "precipitation of the year, mean of the patches", weather,
               &YearRow::precipitation_mm},
              {"evapotranspiration_mm", 1, "evapotranspiration of the year", &YearRow::evapotranspiration_mm},
              {"runoff_mm", 1, "water that runs off or drains in the year", &YearRow::runoff_mm},
              {"storage_gain_mm", 1, "gain of water in soil and snow over the year",
               &YearRow::storage_gain_mm},
              {"mean_temperature_degc", 2, "mean air temperature of the year, mean of the patches", weather,
               &YearRow::mean_temperature_degc}},
          after_start},
         wood_budget_columns()}};
}

MemberTable<LossRow> mortality() {
    return {
        "mortality.csv",
        "Trees that left the forest each year, by cause.",
        "a species in a year that lost trees of it to a cause",
        {member_columns<LossRow>(),
         {"cause",
          "background, stress, self_thinning, wind, snow, beetle, rock, wound, felled, browsing or drought",
          [](const auto& row) { return forest::name_of(row.cause); }},
         species_column<LossRow>(),
         {"stems_pha", 3, "stems that left the forest in the year",
          [](const auto& row) { return row.loss.stems_pha; }},
         {"volume_m3pha", 4, "their stem wood over bark",
          [](const auto& row) { return row.loss.volume_m3pha; }},
         {"above_ground_tpha", 4, "their dry mass above ground",
          [](const auto& row) { return row.loss.above_ground_tpha; }}}};
}

MemberTable<TreeRow> trees() {
    return {"trees_YEAR.csv",
            "",
            "a tree, or a group of equal young ones, at the end of a year",
            {member_columns<TreeRow>(),
             tree_columns<TreeRow>(),

             {"crown_base_m", 2, "height of the crown base above the ground", &TreeRow::crown_base_m},
             {"crown_radius_m", 2, "radius of the crown", &TreeRow::crown_radius_m},
             {"age_years", 1, "age", &TreeRow::age_years},
             {"light_ratio", 3, "light of the last season, 1: no neighbour shades it; empty at the start",
              &TreeRow::light_ratio},
             {"vitality", 3, "0 to 1; production goes with its square root", &TreeRow::vitality},
             {"stems", "stems that the row stands for: young ones below 5 cm are kept in groups of equals",
              &TreeRow::stems},
             {"rock_hits", "hits by the simulated rocks of this year", from_counting, &TreeRow::rock_hits},
             {"rock_energy_kj", 2, "energy it took from the simulated rocks of this year",
              &TreeRow::rock_energy_kj}}};
}

}  // namespace

std::string Names::course_name(std::size_t course) const {
    const std::string& regime = regimes[regime_of(course)];
    return climates.size() > 1 ? joined(regime, ", ", climates[climate_of(course)]) : regime;
}

std::string Names::course_folder(std::size_t course) const {
    const std::string& regime = regimes[regime_of(course)];
    return climates.size() > 1 ? joined(regime, "/", climates[climate_of(course)]) : regime;
}

std::vector<TableLayout> forest_layouts() {
    return {stands(), dbh_classes(), forest_years(), mortality(), trees()};
}

std::vector<WrittenFile> write_forest_tables(const std::filesystem::path& folder, const Names& names,
                                             std::span<const MemberYears> members,
                                             std::span<const int> tree_list_years) {
    std::vector<WrittenFile> written{
        stands().write(folder, member_rows(names, members, &MemberYears::stands)),
        dbh_classes().write(
            folder, member_rows(names, members,
                                [](const auto& member, const auto& add) { add_classes(member, add); })),
        forest_years().write(folder, member_rows(names, members, &MemberYears::years)),
        mortality().write(folder, member_rows(names, members, &MemberYears::losses))};
    for (const int year : tree_list_years) {
        const std::string number = std::to_string(year);
        const auto trees_then = [&](const MemberYears& member, const auto& add) {
            for (const TreeRow& tree : member.trees) {
                if (tree.year == year) {
                    add(tree);
                }
            }
        };
        written.push_back(trees().write_as(
            folder, joined("trees_", number, ".csv"),
            joined("Every tree in year ", number, year == 0 ? ", the start." : ", at its end."),
            member_rows(names, members, trees_then)));
    }
    return written;
}

}  // namespace coupling::decades
