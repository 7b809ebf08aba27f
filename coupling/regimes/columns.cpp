#include "coupling/regimes/columns.hpp"

#include <array>
#include <type_traits>

namespace coupling {

namespace {

constexpr std::array<std::string_view, treatment_count> treatment_names = {
    "thin_below",  "thin_density", "thin_crop_trees", "target_diameter", "selection",
    "shelter_cut", "group_cut",    "clear_cut",       "salvage",         "tend",
    "fence",       "plant",        "plant_clusters"};
constexpr std::array<std::string_view, where_count> where_names = {"all", "stands", "strips", "slits",
                                                                   "polygons"};

template <class... Values>
constexpr Uses uses(Values... values) {
    return ((Uses{1} << static_cast<unsigned>(values)) | ...);
}

constexpr Uses cuts = uses(Treatment::thin_below, Treatment::thin_density, Treatment::thin_crop_trees,
                           Treatment::target_diameter, Treatment::selection, Treatment::shelter_cut,
                           Treatment::group_cut, Treatment::clear_cut);
constexpr Uses planting = uses(Treatment::plant, Treatment::plant_clusters);
constexpr Uses crop = uses(Treatment::thin_crop_trees);
constexpr Uses selecting = uses(Treatment::selection);
constexpr Uses of_a_shape = uses(Where::strips, Where::slits);
constexpr Uses in_parts = uses(Where::stands, Where::strips, Where::slits, Where::polygons);
constexpr Uses of_slits = uses(Where::slits);

constexpr config::NumberRange years{.low = 0.0, .high = 10'000.0};
constexpr config::NumberRange pause{.low = 1.0, .high = 10'000.0};
constexpr config::NumberRange share{.low = 0.0, .high = 1.0};
constexpr config::NumberRange some_share{.low = 0.0, .high = 1.0, .low_excluded = true};
constexpr config::NumberRange some_m{.low = 0.0, .high = 1000.0, .low_excluded = true};

constexpr std::string_view practice = "practice [lit*]";
constexpr std::string_view choice = "[choice]";

std::vector<RegimeColumn> all_columns() {
    using I = Intervention;
    return {
        {"name", +[](I& i) -> std::string& { return i.name; },
         "the row's name in reports and for `after`; empty: that of its treatment"},
        {"treatment", +[](I& i) -> Treatment& { return i.treatment; }, "what is done", "", {}, 0, 0, true},
        {"first_year", +[](I& i) -> int& { return i.first_year; },
         "first year of the run (counted from 0) in which it may be done", "", years},
        {"every_years", +[](I& i) -> std::optional<int>& { return i.every_years; },
         "years from one turn to the next; empty: once, and with a condition once on each area until that is "
         "cleared",
         "", pause},
        {"last_year", +[](I& i) -> std::optional<int>& { return i.last_year; },
         "last year of the run in which it may be done", "", years},
        {"after", +[](I& i) -> std::string& { return i.after; },
         "name of a row above: done where that was done, after_years later"},
        {"after_years", +[](I& i) -> int& { return i.after_years; }, "years after the row that `after` names",
         "", years},
        {"from_age_years", +[](I& i) -> std::optional<double>& { return i.from_age_years; },
         "only where the area is this old: years since its clear cut, before that the mean age of its 100 "
         "thickest stems per hectare",
         "", years},
        {"to_age_years", +[](I& i) -> std::optional<double>& { return i.to_age_years; },
         "only where the area is younger than this", "", years},
        {"from_dominant_height_m",
         +[](I& i) -> std::optional<double>& { return i.from_dominant_height_m; },
         "only where the 100 thickest stems per hectare are this high on average",
         "",
         {.low = 0.0, .high = 80.0}},
        {"from_basal_area_m2pha",
         +[](I& i) -> std::optional<double>& { return i.from_basal_area_m2pha; },
         "only where there is this much basal area",
         "",
         {.low = 0.0, .high = 200.0}},
        {"from_relative_density",
         +[](I& i) -> std::optional<double>& { return i.from_relative_density; },
         "only where the forest is this dense (stems of 7 cm and more / most stems)",
         "",
         {.low = 0.0, .high = 2.0}},
        {"where", +[](I& i) -> Where& { return i.ground.where; },
         "which areas; with `after` those of that row"},
        {"stands",
         +[](I& i) -> std::vector<std::uint32_t>& { return i.ground.stands; },
         "numbers of the stand map, blanks between; empty: all stands",
         "",
         {.low = 0.0, .high = 4294967295.0}},
        {"polygons",
         +[](I& i) -> std::string& { return i.ground.polygons; },
         "file of polygons",
         "",
         {},
         0,
         uses(Where::polygons),
         true},
        {"entries",
         +[](I& i) -> int& { return i.ground.entries; },
         "parts of the ground that take turns: each part comes every entries x every_years; of strips every "
         "n-th, of slits the rungs, of stands and polygons every n-th",
         "",
         {.low = 1.0, .high = 1000.0},
         0,
         in_parts},
        {"length_m", +[](I& i) -> double& { return i.ground.length_m; }, "of a slit; usually 40-70",
         "Wunder & Brang 2003", some_m, 0, of_slits},
        {"width_m", +[](I& i) -> double& { return i.ground.width_m; },
         "of a slit (usually 15-20) or a strip (30-50)", "Wunder & Brang 2003; strips practice [lit*]",
         some_m, 0, of_a_shape, true},
        {"angle_deg",
         +[](I& i) -> double& { return i.ground.angle_deg; },
         "of the long side to the fall line: 0 straight down",
         "slits 45: Wunder & Brang 2003",
         {.low = -90.0, .high = 90.0},
         0,
         of_a_shape,
         true},
        {"gap_m",
         +[](I& i) -> double& { return i.ground.gap_m; },
         "between two slits of a ladder along the fall line, one tree length; below 0 where rungs of several "
         "entries lie side by side",
         "AFZ ladder scheme; value [choice]",
         {.low = -1000.0, .high = 1000.0},
         0,
         of_slits},
        {"lines_m", +[](I& i) -> double& { return i.ground.lines_m; },
         "between the middles of two ladders, two tree lengths", "AFZ ladder scheme; value [choice]", some_m,
         0, of_slits},
        {"share", +[](I& i) -> double& { return i.share; },
         "what is taken: of the basal area (thin_below 0.15-0.3, shelter_cut 0.25-0.4), of fresh dead wood "
         "(salvage), of the young stems of other species (tend)",
         practice, some_share,
         uses(Treatment::thin_below, Treatment::shelter_cut, Treatment::salvage, Treatment::tend), 0, true},
        {"of_volume",
         +[](I& i) -> bool& { return i.of_volume; },
         "yes: `share` is of the volume instead of the basal area",
         "",
         {},
         uses(Treatment::thin_below)},
        {"target_density",
         +[](I& i) -> double& { return i.target_density; },
         "relative density that stays; usually 0.5-0.7",
         "matreex 0.65",
         {.low = 0.1, .high = 1.0},
         uses(Treatment::thin_density)},
        {"from_dbh_cm",
         +[](I& i) -> double& { return i.from_dbh_cm; },
         "thinner trees stay and are not counted in shares: young growth under a thinning or a clearance",
         "",
         {.low = 0.0, .high = 200.0},
         cuts & ~uses(Treatment::selection, Treatment::thin_density)},
        {"crop_trees_pha",
         +[](I& i) -> double& { return i.crop.crop_trees_pha; },
         "usually 100-200",
         practice,
         {.low = 0.0, .high = 2000.0, .low_excluded = true},
         crop},
        {"competitors",
         +[](I& i) -> std::size_t& { return i.crop.competitors; },
         "taken at most around each crop tree; usually 1-3",
         practice,
         {.low = 1.0, .high = 20.0},
         crop},
        {"a_value",
         +[](I& i) -> double& { return i.crop.a_value; },
         "4 light to 6 strong thinning",
         "Johann 1982 [lit*]",
         {.low = 0.0, .high = 20.0, .low_excluded = true},
         crop},
        {"most_volume_share",
         +[](I& i) -> double& {
             return i.treatment == Treatment::selection ? i.selection.most_volume_share
                                                        : i.crop.most_volume_share;
         },
         "at most this share of the standing volume an entry; for selection 0.25 unless given", practice,
         some_share, crop | selecting},
        {"basal_area_m2pha",
         +[](I& i) -> double& { return i.selection.basal_area_m2pha; },
         "that stays in the selection forest; usually 25-32",
         practice,
         {.low = 0.0, .high = 100.0, .low_excluded = true},
         selecting},
        {"max_dbh_cm",
         +[](I& i) -> double& { return i.selection.max_dbh_cm; },
         "thickest tree that stays; usually 55-65",
         practice,
         {.low = 12.5, .high = 200.0, .low_excluded = true},
         selecting},
        {"q",
         +[](I& i) -> double& { return i.selection.q; },
         "stems of a class of 5 cm / stems of the next [-]",
         practice,
         {.low = 1.0, .high = 3.0},
         selecting},
        {"side_m",
         +[](I& i) -> double& { return i.groups.side_m; },
         "of a square hole; usually 1-1.5 tree heights",
         practice,
         {.low = 10.0, .high = 60.0},
         uses(Treatment::group_cut)},
        {"area_share", +[](I& i) -> double& { return i.groups.area_share; },
         "of the area in holes at most, an entry", "BWINPro scheme 0.1", some_share,
         uses(Treatment::group_cut)},
        {"stump_height_m",
         +[](I& i) -> double& { return i.felling.stump_height_m; },
         "1.0-1.3 for high stumps",
         "Italian manual",
         {.low = 0.0, .high = 3.0},
         cuts},
        {"left_share", +[](I& i) -> double& { return i.felling.left_share; },
         "of the felled stems from 15 cm on that stay as logs; usually 0.2-0.5", choice, share, cuts},
        {"log_length_m",
         +[](I& i) -> double& { return i.felling.log_length_m; },
         "of logs that stay: the thick end of the stem; 0 for whole stems, else usually 5-10",
         "Italian manual, BAFU aid",
         {.low = 0.0, .high = 60.0},
         cuts},
        {"log_angle_deg",
         +[](I& i) -> config::Angle& { return i.felling.to_fall_line; },
         "of these logs to the fall line, either way",
         "Italian manual, BAFU aid",
         {.low = 0.0, .high = 90.0},
         cuts},
        {"anchored",
         +[](I& i) -> bool& { return i.felling.anchored; },
         "yes: behind stumps; no: weak ones roll off",
         "",
         {},
         cuts},
        {"damage_share", +[](I& i) -> double& { return i.felling.damage_share; },
         "of standing trees within 5 m of a felled one that are wounded; usually 0.03-0.05", choice, share,
         cuts},
        {"oldest_years",
         +[](I& i) -> int& { return i.oldest_years; },
         "dead wood of at most this age is taken",
         choice,
         {.low = 0.0, .high = 50.0},
         uses(Treatment::salvage)},
        {"species",
         +[](I& i) -> std::vector<forest::SpeciesId>& { return i.species; },
         "codes with blanks between, or Latin names with commas: planted, or favoured by thin_crop_trees and "
         "tend",
         "",
         {},
         planting | crop | uses(Treatment::tend)},
        {"plants_pha",
         +[](I& i) -> std::vector<double>& { return i.plants_pha; },
         "plants a hectare, one number for each species, blanks between; usually 1500-2500 together",
         practice,
         {.low = 0.0, .high = 20'000.0, .low_excluded = true},
         uses(Treatment::plant),
         0,
         true},
        {"plant_height_m",
         +[](I& i) -> double& { return i.plant_height_m; },
         "of the plants",
         choice,
         {.low = 0.0, .high = 1.9, .low_excluded = true},
         planting},
        {"where_fewer_pha",
         +[](I& i) -> std::optional<double>& { return i.where_fewer_pha; },
         "only on patches with fewer young trees (from 0.3 m height to 5 cm dbh)",
         "",
         {.low = 0.0, .high = 100'000.0, .low_excluded = true},
         planting},
        {"spacing_m",
         +[](I& i) -> double& { return i.spacing_m; },
         "between clusters of 25 plants: a multiple of 10",
         choice,
         {.low = 10.0, .high = 100.0},
         uses(Treatment::plant_clusters)},
        {"from_height_m",
         +[](I& i) -> double& { return i.from_height_m; },
         "of young trees that are cut",
         choice,
         {.low = 0.0, .high = 20.0},
         uses(Treatment::tend)},
        {"to_height_m",
         +[](I& i) -> double& { return i.to_height_m; },
         "of young trees that are cut",
         choice,
         {.low = 0.0, .high = 20.0},
         uses(Treatment::tend)},
        {"fence_years",
         +[](I& i) -> int& { return i.fence_years; },
         "for which the fence keeps deer out, until young trees outgrow them",
         choice,
         {.low = 1.0, .high = 1000.0},
         uses(Treatment::fence)},
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
    return has(column.treatments, static_cast<unsigned>(intervention.treatment)) &&
           has(column.places, static_cast<unsigned>(intervention.ground.where));
}

std::string default_text(const RegimeColumn& column) {
    if (column.needed) {
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
    if (column.treatments == 0 && column.places == 0) {
        return "all";
    }
    if (column.treatments == cuts) {
        return "all cuts";
    }
    return column.treatments != 0 ? names_in(column.treatments, treatment_names)
                                  : names_in(column.places, where_names);
}

}  // namespace coupling
