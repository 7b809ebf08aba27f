#include "coupling/exchange/regimes/columns.hpp"

#include <array>
#include <type_traits>

namespace coupling {

namespace {

constexpr std::array<std::string_view, treatment_count> treatment_names = {
    "thin_below",    "thin_density", "thin_crop_trees", "target_diameter",
    "selection",     "shelter_cut",  "group_cut",       "thin_to_basal_area",
    "thin_to_stems", "clear_cut",    "fell_list",       "salvage",
    "tend",          "fence",        "plant",           "plant_clusters"};
constexpr std::array<std::string_view, where_count> where_names = {"all",      "stands",    "strips", "slits",
                                                                   "polygons", "corridors", "cuts_of"};

template <class... Values>
constexpr Uses uses(Values... values) {
    return ((Uses{1} << static_cast<unsigned>(values)) | ...);
}

constexpr Uses cuts =
    uses(Treatment::thin_below, Treatment::thin_density, Treatment::thin_crop_trees,
         Treatment::target_diameter, Treatment::selection, Treatment::shelter_cut, Treatment::group_cut,
         Treatment::thin_to_basal_area, Treatment::thin_to_stems, Treatment::clear_cut);
/// Those that choose trees by a rule, and the list.
constexpr Uses listed = uses(Treatment::fell_list);
constexpr Uses all_cuts = cuts | listed;
/// What leaves stumps and logs.
constexpr Uses felling = all_cuts | uses(Treatment::salvage);
constexpr Uses planting = uses(Treatment::plant, Treatment::plant_clusters);
constexpr Uses crop = uses(Treatment::thin_crop_trees);
constexpr Uses selecting = uses(Treatment::selection);
constexpr Uses of_a_shape = uses(Where::strips, Where::slits);
constexpr Uses in_parts = uses(Where::stands, Where::strips, Where::slits, Where::polygons, Where::corridors);
constexpr Uses with_width = of_a_shape | uses(Where::corridors);
/// Cuts of another row have their place already.
constexpr Uses on_the_map = in_parts | uses(Where::all);
constexpr Uses of_slits = uses(Where::slits);

constexpr config::NumberRange years{.low = 0.0, .high = 10'000.0};
constexpr config::NumberRange pause{.low = 1.0, .high = 10'000.0};
constexpr config::NumberRange share{.low = 0.0, .high = 1.0};
constexpr config::NumberRange some_share{.low = 0.0, .high = 1.0, .low_excluded = true};
constexpr config::NumberRange some_m{.low = 1.0, .high = 1000.0};

constexpr std::string_view practice = "practice [lit*]";
constexpr std::string_view choice = "[choice]";

/// The member of an intervention along a path of members.
template <auto... path>
constexpr auto at = +[](Intervention& i) -> auto& {
    return (i.*....*path);
};

/// Selections and thinnings of crop trees have a limit each.
double& volume_limit(Intervention& i) {
    return i.treatment == Treatment::selection ? i.selection.most_volume_share : i.crop.most_volume_share;
}

std::vector<RegimeColumn> all_columns() {
    using I = Intervention;
    return {
        {"name", at<&I::name>, "the row's name in reports and for `after`; empty: that of its treatment"},
        {"treatment", at<&I::treatment>, "what is done", {.needed = true}},
        {"first_year",
         at<&I::first_year>,
         "first year in which it may be done: of the run, counted from 0, or a calendar year (1500 and "
         "later)",
         {.range = years}},
        {"every_years",
         at<&I::every_years>,
         "years from one turn to the next; empty: once, and with a condition once on each area until that is "
         "cleared",
         {.range = pause}},
        {"last_year",
         at<&I::last_year>,
         "last year in which it may be done, counted as first_year",
         {.range = years}},
        {"order",
         at<&I::order>,
         "place among the rows that are due in a year, lower first; rows of different order may work on the "
         "same "
         "ground in the same year, each on what the ones before have left",
         {.range = {.low = 1.0, .high = 1000.0}}},
        {"after", at<&I::after>, "name of a row above: done where that was done, after_years later"},
        {"after_years", at<&I::after_years>, "years after the row that `after` names", {.range = years}},
        {"from_age_years",
         at<&I::from_age_years>,
         "only where the area is this old: years since its clear cut, before that the mean age of its 100 "
         "thickest stems per hectare",
         {.range = years}},
        {"to_age_years", at<&I::to_age_years>, "only where the area is younger than this", {.range = years}},
        {"from_dominant_height_m",
         at<&I::from_dominant_height_m>,
         "only where the 100 thickest stems per hectare are this high on average",
         {.range = {.low = 0.0, .high = 80.0}}},
        {"from_basal_area_m2pha",
         at<&I::from_basal_area_m2pha>,
         "only where there is this much basal area",
         {.range = {.low = 0.0, .high = 200.0}}},
        {"from_relative_density",
         at<&I::from_relative_density>,
         "only where the forest is this dense (stems of 7 cm and more / most stems)",
         {.range = {.low = 0.0, .high = 2.0}}},
        {"from_damage_m3pha",
         at<&I::from_damage_m3pha>,
         "only where storm, wet snow and beetles have just taken so much in the year",
         {.range = {.low = 0.0, .high = 2000.0}}},
        {"from_gap_m",
         at<&I::from_gap_m>,
         "only where the longest gap along the fall line (no stem from 12 cm) is this long",
         {.range = {.low = 0.0, .high = 5000.0}}},
        {"to_gap_m",
         at<&I::to_gap_m>,
         "only where it is no longer than this, such as 25: no cut that would lengthen it",
         {.range = {.low = 0.0, .high = 5000.0}}},
        {"where", at<&I::ground, &Ground::where>,
         "which areas; with `after` those of that row; cuts_of:ROW where a row above cut or salvaged, such "
         "as the holes of a group cut"},
        {"stands",
         at<&I::ground, &Ground::stands>,
         "numbers of the stand map, blanks between; empty: all stands",
         {.range = {.low = 0.0, .high = 4294967295.0}, .places = on_the_map}},
        {"from_slope_deg",
         at<&I::ground, &Ground::from_slope_deg>,
         "only patches of 10 m that are this steep",
         {.range = {.low = 0.0, .high = 90.0}, .places = on_the_map}},
        {"to_slope_deg",
         at<&I::ground, &Ground::to_slope_deg>,
         "only patches of 10 m that are not steeper, such as 40 for a harvester",
         {.range = {.low = 0.0, .high = 90.0}, .places = on_the_map}},
        {"polygons",
         at<&I::ground, &Ground::polygons>,
         "file of polygons",
         {.places = uses(Where::polygons), .needed = true}},
        {"lines",
         at<&I::ground, &Ground::lines>,
         "file of lines, such as those of a cable crane",
         {.places = uses(Where::corridors), .needed = true}},
        {"entries",
         at<&I::ground, &Ground::entries>,
         "parts of the ground that take turns: each part comes every entries x every_years; of strips every "
         "n-th, of slits the rungs, of stands and polygons every n-th",
         {.range = {.low = 1.0, .high = 1000.0}, .places = in_parts}},
        {"length_m",
         at<&I::ground, &Ground::length_m>,
         "of a slit; usually 40-70",
         {.source = "Wunder & Brang 2003", .range = some_m, .places = of_slits}},
        {"width_m",
         at<&I::ground, &Ground::width_m>,
         "of a slit (usually 15-20), a strip (30-50) or a corridor (usually 10-15)",
         {.source = "Wunder & Brang 2003; strips practice [lit*]",
          .range = some_m,
          .places = with_width,
          .needed = true}},
        {"angle_deg",
         at<&I::ground, &Ground::angle_deg>,
         "of the long side to the fall line: 0 straight down",
         {.source = "slits 45: Wunder & Brang 2003",
          .range = {.low = -90.0, .high = 90.0},
          .places = of_a_shape,
          .needed = true}},
        {"gap_m",
         at<&I::ground, &Ground::gap_m>,
         "between two slits of a ladder along the fall line, one tree length; below 0 where rungs of several "
         "entries lie side by side",
         {.source = "AFZ ladder scheme; value [choice]",
          .range = {.low = -1000.0, .high = 1000.0},
          .places = of_slits}},
        {"lines_m",
         at<&I::ground, &Ground::lines_m>,
         "between the middles of two ladders, two tree lengths",
         {.source = "AFZ ladder scheme; value [choice]", .range = some_m, .places = of_slits}},
        {"share",
         at<&I::share>,
         "what is taken: of the basal area (thin_below 0.15-0.3, shelter_cut 0.25-0.4), of fresh dead wood "
         "(salvage), of the young stems of other species (tend)",
         {.source = practice,
          .range = some_share,
          .treatments =
              uses(Treatment::thin_below, Treatment::shelter_cut, Treatment::salvage, Treatment::tend),
          .needed = true}},
        {"of_volume",
         at<&I::of_volume>,
         "yes: `share` is of the volume instead of the basal area",
         {.treatments = uses(Treatment::thin_below)}},
        {"target_density",
         at<&I::target_density>,
         "relative density that stays; usually 0.5-0.7",
         {.source = "matreex 0.65",
          .range = {.low = 0.1, .high = 1.0},
          .treatments = uses(Treatment::thin_density)}},
        {"from_dbh_cm",
         at<&I::from_dbh_cm>,
         "thinner trees stay and are not counted in shares: young growth under a thinning or a clearance",
         {.range = {.low = 0.0, .high = 200.0},
          .treatments = cuts & ~uses(Treatment::selection, Treatment::thin_density)}},
        {"to_basal_area_m2pha",
         at<&I::to_basal_area_m2pha>,
         "basal area that stays, of all trees of the area",
         {.range = {.low = 0.0, .high = 200.0, .low_excluded = true},
          .treatments = uses(Treatment::thin_to_basal_area),
          .needed = true}},
        {"stems",
         at<&I::stems>,
         "file with age_years, stems_pha and perhaps stand: the stems that stay at the age of an area, as "
         "yield "
         "tables have them; straight between two ages, nothing is cut outside of them",
         {.treatments = uses(Treatment::thin_to_stems), .needed = true}},
        {"only_species",
         at<&I::only_species>,
         "only trees of these species are cut: a species out, or a thinning of one",
         {.treatments = cuts}},
        {"spare_species", at<&I::spare_species>, "trees of these species stay", {.treatments = cuts}},
        {"retain_pha",
         at<&I::retain_pha>,
         "so many of the thickest trees stay, per hectare (habitat trees); usually 5-10",
         {.source = practice, .range = {.low = 0.0, .high = 1000.0}, .treatments = cuts}},
        {"crop_trees_pha",
         at<&I::crop, &forest::CropTreeThinning::crop_trees_pha>,
         "usually 100-200",
         {.source = practice,
          .range = {.low = 0.0, .high = 2000.0, .low_excluded = true},
          .treatments = crop}},
        {"competitors",
         at<&I::crop, &forest::CropTreeThinning::competitors>,
         "taken at most around each crop tree; usually 1-3",
         {.source = practice, .range = {.low = 1.0, .high = 20.0}, .treatments = crop}},
        {"a_value",
         at<&I::crop, &forest::CropTreeThinning::a_value>,
         "4 light to 6 strong thinning",
         {.source = "Johann 1982 [lit*]",
          .range = {.low = 0.0, .high = 20.0, .low_excluded = true},
          .treatments = crop}},
        {"most_volume_share",
         volume_limit,
         "at most this share of the standing volume an entry; for selection 0.25 unless given",
         {.source = practice, .range = some_share, .treatments = crop | selecting}},
        {"basal_area_m2pha",
         at<&I::selection, &forest::SelectionForest::basal_area_m2pha>,
         "that stays in the selection forest; usually 25-32",
         {.source = practice,
          .range = {.low = 0.0, .high = 100.0, .low_excluded = true},
          .treatments = selecting}},
        {"max_dbh_cm",
         at<&I::selection, &forest::SelectionForest::max_dbh_cm>,
         "thickest tree that stays; usually 55-65",
         {.source = practice,
          .range = {.low = 12.5, .high = 200.0, .low_excluded = true},
          .treatments = selecting}},
        {"q",
         at<&I::selection, &forest::SelectionForest::q>,
         "stems of a class of 5 cm / stems of the next [-]",
         {.source = practice, .range = {.low = 1.0, .high = 3.0}, .treatments = selecting}},
        {"side_m",
         at<&I::groups, &forest::Groups::side_m>,
         "of a square hole; usually 1-1.5 tree heights",
         {.source = practice,
          .range = {.low = 10.0, .high = 60.0},
          .treatments = uses(Treatment::group_cut)}},
        {"area_share",
         at<&I::groups, &forest::Groups::area_share>,
         "of the area in holes at most, an entry",
         {.source = "BWINPro scheme 0.1", .range = some_share, .treatments = uses(Treatment::group_cut)}},
        {"stump_height_m",
         at<&I::felling, &forest::Felling::stump_height_m>,
         "1.0-1.3 for high stumps",
         {.source = "Italian manual", .range = {.low = 0.0, .high = 3.0}, .treatments = felling}},
        {"left_share",
         at<&I::felling, &forest::Felling::left_share>,
         "of the felled or salvaged stems from 15 cm on that stay as logs; usually 0.2-0.5",
         {.source = choice, .range = share, .treatments = felling}},
        {"log_length_m",
         at<&I::felling, &forest::Felling::log_length_m>,
         "of logs that stay: the thick end of the stem; 0 for whole stems, else usually 5-10",
         {.source = "Italian manual, BAFU aid", .range = {.low = 0.0, .high = 60.0}, .treatments = felling}},
        {"log_angle_deg",
         at<&I::felling, &forest::Felling::to_fall_line>,
         "of these logs to the fall line, either way",
         {.source = "Italian manual, BAFU aid", .range = {.low = 0.0, .high = 90.0}, .treatments = felling}},
        {"anchored",
         at<&I::felling, &forest::Felling::anchored>,
         "yes: behind stumps; no: weak ones roll off",
         {.treatments = felling}},
        {"girdled",
         at<&I::felling, &forest::Felling::girdled>,
         "yes: trees are killed by a ring and stay standing, without timber; costs as felling",
         {.treatments = all_cuts}},
        {"damage_share",
         at<&I::felling, &forest::Felling::damage_share>,
         "of standing trees within 5 m of a felled one that are wounded; usually 0.03-0.05",
         {.source = choice, .range = share, .treatments = all_cuts}},
        {"trees",
         at<&I::trees>,
         "file with tree_id and year (of the run or calendar) of each felled tree, as numbered in the list "
         "of "
         "trees",
         {.treatments = listed, .needed = true}},
        {"oldest_years",
         at<&I::oldest_years>,
         "dead wood of at most this age is taken",
         {.source = choice, .range = {.low = 0.0, .high = 50.0}, .treatments = uses(Treatment::salvage)}},
        {"species",
         at<&I::species>,
         "codes with blanks between, or Latin names with commas: planted, or favoured by thin_crop_trees and "
         "tend",
         {.treatments = planting | crop | uses(Treatment::tend)}},
        {"plants_pha",
         at<&I::plants_pha>,
         "plants a hectare, one number for each species, blanks between; usually 1500-2500 together",
         {.source = practice,
          .range = {.low = 0.0, .high = 20'000.0, .low_excluded = true},
          .treatments = uses(Treatment::plant),
          .needed = true}},
        {"plant_height_m",
         at<&I::plant_height_m>,
         "of the plants",
         {.source = choice,
          .range = {.low = 0.0, .high = 1.9, .low_excluded = true},
          .treatments = planting}},
        {"where_fewer_pha",
         at<&I::where_fewer_pha>,
         "only on patches with fewer young trees (from 0.3 m height to 5 cm dbh)",
         {.range = {.low = 0.0, .high = 100'000.0, .low_excluded = true}, .treatments = planting}},
        {"spacing_m",
         at<&I::spacing_m>,
         "between clusters of 25 plants: a multiple of 10",
         {.source = choice,
          .range = {.low = 10.0, .high = 100.0},
          .treatments = uses(Treatment::plant_clusters)}},
        {"from_height_m",
         at<&I::from_height_m>,
         "of young trees that are cut",
         {.source = choice, .range = {.low = 0.0, .high = 20.0}, .treatments = uses(Treatment::tend)}},
        {"to_height_m",
         at<&I::to_height_m>,
         "of young trees that are cut",
         {.source = choice, .range = {.low = 0.0, .high = 20.0}, .treatments = uses(Treatment::tend)}},
        {"fence_years",
         at<&I::fence_years>,
         "for which the fence keeps deer out, until young trees outgrow them",
         {.source = choice, .range = {.low = 1.0, .high = 1000.0}, .treatments = uses(Treatment::fence)}},
        {"guard_years",
         at<&I::guard_years>,
         "for which a tube or cage around each plant keeps deer off; 0: no guards; usually 8-15",
         {.source = practice, .range = {.low = 0.0, .high = 1000.0}, .treatments = planting}},
    };
}

std::string names_in(Uses wanted, std::span<const std::string_view> names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if ((wanted >> i & 1U) != 0U) {
            text.append(text.empty() ? "" : ", ").append(names[i]);
        }
    }
    return text;
}

template <class T>
struct TargetOf;
template <class T>
struct TargetOf<T& (*)(Intervention&)> {
    using type = T;
};

}  // namespace

std::string name_of(Treatment treatment) {
    return std::string{treatment_names[static_cast<std::size_t>(treatment)]};
}

std::string name_of(Where where) {
    return std::string{where_names[static_cast<std::size_t>(where)]};
}

std::span<const RegimeColumn> regime_columns() {
    static const std::vector<RegimeColumn> columns = all_columns();
    return columns;
}

bool is_used(const RegimeColumn& column, const Intervention& intervention) {
    const auto has = [](Uses wanted, unsigned value) { return wanted == 0 || (wanted >> value & 1U) != 0U; };
    return has(column.rules.treatments, static_cast<unsigned>(intervention.treatment)) &&
           has(column.rules.places, static_cast<unsigned>(intervention.ground.where));
}

std::string default_text(const RegimeColumn& column) {
    if (column.rules.needed) {
        return "";
    }
    return std::visit(
        [](auto field) -> std::string {
            using T = typename TargetOf<decltype(field)>::type;
            Intervention fresh;
            const T& value = field(fresh);
            if constexpr (std::is_same_v<T, bool>) {
                return value ? "yes" : "no";
            } else if constexpr (std::is_same_v<T, config::Angle>) {
                return config::to_text(value.in_degrees());
            } else if constexpr (std::is_arithmetic_v<T>) {
                return config::to_text(static_cast<double>(value));
            } else if constexpr (std::is_same_v<T, Where>) {
                return name_of(value);
            } else {
                return "";
            }
        },
        column.field);
}

std::string users_text(const RegimeColumn& column) {
    if (column.rules.treatments == 0 && column.rules.places == 0) {
        return "all";
    }
    if (column.rules.treatments == cuts) {
        return "all cuts but fell_list";
    }
    if (column.rules.treatments == all_cuts) {
        return "all cuts";
    }
    if (column.rules.treatments == felling) {
        return "all cuts, salvage";
    }
    return column.rules.treatments != 0 ? names_in(column.rules.treatments, treatment_names)
                                        : names_in(column.rules.places, where_names);
}

}  // namespace coupling
