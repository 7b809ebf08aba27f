#include "coupling/inputs/observed/observed_events_input.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "rockfall/slope/slope.hpp"
#include "rockfall/tally/target.hpp"

namespace coupling {

struct ObservedPassageRow : ObservedPassage {
    std::string target_id;
};
struct ObservedImpactRow : ObservedImpact {
    std::optional<double> x_m;
    std::optional<double> y_m;
};
struct ObservedTreeRow : ObservedTree {};
struct ObservedOutlineRow {
    config::Shape shape;
};
struct ObservedScarRow : ObservedScar {
    std::optional<double> x_m;
    std::optional<double> y_m;
};
struct SearchedAreaRow {
    config::Shape shape;
};

namespace {

using config::joined;

constexpr config::NumberRange seen_speeds{0.0, 200.0};
constexpr config::NumberRange seen_energies{0.0, 1e9};
constexpr config::NumberRange seen_angles{-90.0, 90.0};

/// Nothing measured: the rock still counts among those that passed.
std::vector<ObservedPassage> read_passages(std::span<const rockfall::Target> targets, Reading& reading) {
    const config::Table table = table_of(observed_passage_columns(), reading.observed().passages, reading);
    config::RowProblems wrong{table};
    std::vector<std::string> names;
    for (const rockfall::Target& target : targets) {
        names.push_back(target.id);
    }
    std::vector<ObservedPassage> passages;
    for (config::Read<ObservedPassageRow>& row : observed_passage_columns().rows(table, wrong)) {
        const auto target = std::find(names.begin(), names.end(), row.target_id);
        if (target == names.end()) {
            const std::string nearest = config::nearest_word(row.target_id, names);
            wrong.refuse(
                row.row, "target_id", joined("target_id ", config::in_quotes(row.target_id)),
                joined("a target of targets.file", nearest.empty() ? "" : joined(" (", nearest, "?)")),
                "add the target as a line or area, or correct its name");
            continue;
        }
        row.target = static_cast<std::uint32_t>(target - names.begin());
        passages.push_back(std::move(row));
    }
    wrong.throw_first();
    return passages;
}

/// The place of an impact, that is another one than that of the impact before it on its track.
void take_place(config::Read<ObservedImpactRow>& row, std::map<std::string, Eigen::Vector2d>& last_of_track,
                config::RowProblems& wrong) {
    if (!row.x_m && !row.y_m) {
        row.track.clear();
        return;
    }
    if (!row.x_m || !row.y_m || row.track.empty()) {
        const char* missing = !row.x_m ? "x_m" : !row.y_m ? "y_m" : "track";
        wrong.refuse(row.row, missing, joined("no ", missing), "x_m, y_m and track, or none of them",
                     "the track is the rock: its rows are its impacts in their order");
        return;
    }
    row.at_m = Eigen::Vector2d{*row.x_m, *row.y_m};
    const auto [last, is_first] = last_of_track.try_emplace(row.track, *row.at_m);
    if (!is_first && last->second == *row.at_m) {
        wrong.refuse(row.row, "x_m",
                     joined("the place of the row before on track ", config::in_quotes(row.track)),
                     "another place: a jump has a length", "delete one of the rows");
    }
    last->second = *row.at_m;
}

/// A place alone says nothing where no track has a second impact: the file would have nothing to compare.
void refuse_tracks_without_jump(const std::vector<ObservedImpact>& impacts,
                                const std::map<std::string, std::size_t>& impacts_of_track,
                                config::RowProblems& wrong) {
    const bool are_places_alone =
        std::none_of(impacts.begin(), impacts.end(), [&](const ObservedImpact& impact) {
            return impact.speed_in_mps || impact.speed_out_mps || impact.angle_in_deg ||
                   impact.angle_out_deg || (!impact.track.empty() && impacts_of_track.at(impact.track) > 1);
        });
    const bool has_places = std::any_of(impacts.begin(), impacts.end(),
                                        [](const ObservedImpact& impact) { return impact.at_m.has_value(); });
    if (has_places && are_places_alone) {
        wrong.refuse(impacts.size() == 1 ? "one impact with a place alone"
                                         : "tracks of one impact each, with a place alone",
                     "a track with two impacts, or speeds or angles: a jump lies between two impacts",
                     "give the impacts of one rock the same track");
    }
}

std::vector<ObservedImpact> read_impacts(Reading& reading) {
    const config::Table table = table_of(observed_impact_columns(), reading.observed().impacts, reading);
    config::RowProblems wrong{table};
    std::vector<ObservedImpact> impacts;
    std::map<std::string, Eigen::Vector2d> last_of_track;
    std::map<std::string, std::size_t> impacts_of_track;
    for (config::Read<ObservedImpactRow>& row : observed_impact_columns().rows(table, wrong)) {
        if (!row.speed_in_mps && !row.speed_out_mps && !row.angle_in_deg && !row.angle_out_deg && !row.x_m &&
            !row.y_m) {
            wrong.refuse(row.row, table.columns().front(), "a row without a figure",
                         "at least one of speed_in_mps, speed_out_mps, angle_in_deg, angle_out_deg, or a "
                         "place on a track",
                         "remove the row, or fill in what was measured");
        }
        take_place(row, last_of_track, wrong);
        ++impacts_of_track[row.track];
        impacts.push_back(std::move(row));
    }
    refuse_tracks_without_jump(impacts, impacts_of_track, wrong);
    wrong.throw_first();
    return impacts;
}

std::vector<ObservedScar> read_scars(Reading& reading) {
    const config::Table table = table_of(observed_scar_columns(), reading.observed().scars, reading);
    config::RowProblems wrong{table};
    std::vector<ObservedScar> scars;
    for (config::Read<ObservedScarRow>& row : observed_scar_columns().rows(table, wrong)) {
        if (row.x_m.has_value() != row.y_m.has_value()) {
            const char* missing = row.x_m ? "y_m" : "x_m";
            wrong.refuse(row.row, missing, joined("no ", missing), "both coordinates of the stem, or none");
        }
        if (row.x_m && row.y_m) {
            row.at_m = Eigen::Vector2d{*row.x_m, *row.y_m};
        }
        scars.push_back(std::move(row));
    }
    wrong.throw_first();
    return scars;
}

std::vector<ObservedTree> read_trees(Reading& reading) {
    const config::Table table = table_of(observed_tree_columns(), reading.observed().trees, reading);
    config::RowProblems wrong{table};
    std::vector<ObservedTree> trees;
    for (config::Read<ObservedTreeRow>& row : observed_tree_columns().rows(table, wrong)) {
        row.line = wrong.place(row.row, "scars").line;
        trees.push_back(std::move(row));
    }
    wrong.throw_first();
    return trees;
}

}  // namespace

const config::Schema<ObservedTreeRow>& observed_tree_columns() {
    using R = ObservedTreeRow;
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "observed_trees", .setting = "observed.trees", .row = "stem", .no_rows = "at least one row"},
        {{"x_m", [](R& row) -> double& { return row.at_m.x(); }, "east, of the stem, as in trees.file"},
         {"y_m", [](R& row) -> double& { return row.at_m.y(); }, "north"},
         {"scars", &R::scars, "number of its wounds; 0: searched, and none found", {.range = {0.0, 1000.0}}},
         {"dbh_cm", &R::dbh_cm, "diameter of the stem at 1.3 m, to find stems that were mistaken", {.range = {0.0, 500.0}, .optional = true}}}};
    // clang-format on
    return columns;
}

const config::Schema<ObservedOutlineRow>& observed_outline_columns() {
    using R = ObservedOutlineRow;
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "observed_outline", .setting = "observed.outline", .row = "area", .no_rows = "at least one polygon"},
        {{"wkt", &R::shape, "around the blocks that came to rest", {.shapes = {config::Shape::Kind::polygon}}}}};
    // clang-format on
    return columns;
}

const config::Schema<ObservedScarRow>& observed_scar_columns() {
    using R = ObservedScarRow;
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "observed_scars", .setting = "observed.scars", .row = "scar", .no_rows = "at least one row"},
        {{"height_m", &R::height_m, "of the middle of the wound above the ground", {.range = {0.0, 60.0}}},
         {"x_m", &R::x_m, "east, of the stem", {.optional = true}},
         {"y_m", &R::y_m, "north", {.optional = true}},
         {"dbh_cm", &R::dbh_cm, "diameter of the stem at 1.3 m", {.range = {0.0, 500.0}, .optional = true}},
         {"group", &R::group, "such as the event", {.optional = true}}}};
    // clang-format on
    return columns;
}

const config::Schema<SearchedAreaRow>& searched_area_columns() {
    using R = SearchedAreaRow;
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "searched_area", .setting = "calibrate.window", .row = "area", .no_rows = "at least one polygon"},
        {{"wkt", &R::shape, "where stops were looked for", {.shapes = {config::Shape::Kind::polygon}}}}};
    // clang-format on
    return columns;
}

const config::Schema<ObservedPassageRow>& observed_passage_columns() {
    using R = ObservedPassageRow;
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "observed_passages", .setting = "observed.passages", .row = "passage"},
        {{"target_id", &R::target_id, "of targets.file", {.may_be_empty = true}},
         {"speed_mps", &R::speed_mps, "at the first arrival", {.range = seen_speeds}},
         {"height_m", &R::height_m, "of the underside above the ground, vertical", {.range = {0.0, 1000.0}}},
         {"energy_kj", &R::energy_kj, "translation and rotation", {.range = seen_energies}},
         {"translational_kj", &R::translational_kj, "translation alone", {.range = seen_energies}},
         {"group", &R::group, "such as the block", {.optional = true}}}};
    // clang-format on
    return columns;
}

const config::Schema<ObservedImpactRow>& observed_impact_columns() {
    using R = ObservedImpactRow;
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "observed_impacts", .setting = "observed.impacts", .row = "impact", .no_rows = "at least one row"},
        {{"ground", &R::ground, "code of the ground type; empty: any", {.range = {0.0, 1e6}}},
         {"speed_in_mps", &R::speed_in_mps, "before it", {.range = seen_speeds}},
         {"speed_out_mps", &R::speed_out_mps, "after it; 0 where the rock stayed", {.range = seen_speeds}},
         {"angle_in_deg", &R::angle_in_deg, "below the face of the ground", {.range = seen_angles}},
         {"angle_out_deg", &R::angle_out_deg, "above the face of the ground", {.range = seen_angles}},
         {"x_m", &R::x_m, "east, where it struck", {.optional = true}},
         {"y_m", &R::y_m, "north", {.optional = true}},
         {"track", &R::track, "the rock; its rows are its impacts in their order", {.optional = true}},
         {"group", &R::group, "such as the block", {.optional = true}}}};
    // clang-format on
    return columns;
}

std::optional<ObservedEvents> read_observed_events(std::span<const rockfall::Target> targets,
                                                   Reading& reading) {
    return reading.attempt([&] {
        ObservedEvents events;
        events.rocks = reading.observed().rocks;
        if (!reading.observed().passages.empty()) {
            events.passages = read_passages(targets, reading);
        }
        if (!reading.observed().impacts.empty()) {
            events.impacts = read_impacts(reading);
        }
        if (!reading.observed().scars.empty()) {
            events.scars = read_scars(reading);
        }
        if (!reading.observed().trees.empty()) {
            events.trees = read_trees(reading);
        }
        if (const std::string& outline = reading.observed().outline; !outline.empty()) {
            for (ObservedOutlineRow& row : rows_of(observed_outline_columns(), outline, reading)) {
                events.outline.push_back(std::move(row.shape));
            }
        }
        if (const std::string& window = reading.scenario().calibrate.window; !window.empty()) {
            for (SearchedAreaRow& row : rows_of(searched_area_columns(), window, reading)) {
                events.window.push_back(std::move(row.shape));
            }
        }
        if (events.rocks > 0 && events.passages.size() > events.rocks * targets.size()) {
            config::fail(config::ExitCode::settings, reading.settings().options->place_of("observed.rocks"),
                         joined("observed.rocks ", std::to_string(events.rocks), " for ",
                                counted(events.passages.size(), "passage")),
                         "not fewer rocks than passed a target", "count all rocks that were released");
        }
        return events;
    });
}

void keep_targets(ObservedEvents& events, std::span<const std::string> given,
                  std::span<const std::string> kept, Reading& reading) {
    std::set<std::string> left_out;
    for (ObservedPassage& passage : events.passages) {
        const std::string& id = given[passage.target];
        const auto found = std::find(kept.begin(), kept.end(), id);
        if (found == kept.end()) {
            left_out.insert(id);
        } else {
            passage.target = static_cast<std::uint32_t>(found - kept.begin());
        }
    }
    if (!left_out.empty() && !kept.empty()) {  // else all targets are refused already
        reading.refuse({reading.shown(reading.observed().passages)},
                       joined("passages at target ", config::in_quotes(*left_out.begin()),
                              ", which lies wholly beyond the terrain"),
                       "targets on the terrain: no simulated rock arrives elsewhere",
                       "take a larger terrain, or remove these rows");
    }
}

void check_observed_grounds(const ObservedEvents& events, std::span<const rockfall::SurfaceType> types,
                            Reading& reading) {
    std::set<int> unknown;
    for (const ObservedImpact& impact : events.impacts) {
        const bool is_known =
            !impact.ground || std::any_of(types.begin(), types.end(), [&](const rockfall::SurfaceType& type) {
                return type.code == *impact.ground;
            });
        if (!is_known) {
            unknown.insert(*impact.ground);
        }
    }
    if (!unknown.empty()) {
        reading.refuse({reading.shown(reading.observed().impacts)},
                       joined("ground ", std::to_string(*unknown.begin()), ", which this run does not have"),
                       "codes of its ground types (0 is that of terrain.ground)",
                       "correct the column ground, or leave it empty to compare with all impacts");
    }
}

}  // namespace coupling
