#include "validation/engine/slope/recipe.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <utility>

#include "config/grid/ascii_grid.hpp"
#include "config/options/ini.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/forest/species_table.hpp"
#include "coupling/inputs/scenario/ground_changes.hpp"
#include "coupling/inputs/scenario/start_settings.hpp"

namespace coupling::validation {
namespace {

using config::joined;

constexpr const char* slope_recipe_file = "case.ini";

const std::vector<std::pair<std::string, CaseKind>>& kinds() {
    static const std::vector<std::pair<std::string, CaseKind>> names{
        {"slope", CaseKind::slope},
        {"profile", CaseKind::profile},
        {"factors", CaseKind::factors},
        {"field", CaseKind::field},
        {"collapse", CaseKind::collapse},
        {"forest_production", CaseKind::forest_production},
        {"forest_light", CaseKind::forest_light},
        {"forest_years", CaseKind::forest_years}};
    return names;
}

void declare_rock(config::Options& options, Recipe& r) {
    options.number("rock.diameter_m", r.diameter_m,
                   {.unit = "m", .low = 0.01, .high = 20.0, .meaning = "diameter of every rock"});
    declare_density(options, "rock", r.density_kgpm3);
    declare_start(options, "rock", {r.start_height_m, r.start_speed_mps, r.start_dip_deg});
}

void declare_series(config::Options& options, Recipe& r) {
    options.count("series.seed", r.seed,
                  {.low = 0.0, .high = 9007199254740992.0, .meaning = "key of all random numbers"});
    options.count("series.rocks", r.rocks,
                  {.low = 1.0, .high = 1e7, .meaning = "rocks of the one large ensemble"});
    options.count("series.series", r.series,
                  {.low = 0.0, .high = 1e5, .meaning = "small series, as an experiment has them"});
    options.count("series.rocks_per_series", r.rocks_per_series,
                  {.low = 1.0, .high = 1e6, .meaning = "rocks of a small series"});
    options.count("series.choice_rocks", r.choice_rocks,
                  {.low = 1.0, .high = 1e7, .meaning = "rocks for each moved choice"});
}

void declare_terrain(config::Options& options, Recipe& r) {
    options.text("terrain.profile", r.profile, {.meaning = "file of the profile"});
    options.number("terrain.width_m", r.width_m,
                   {.unit = "m", .low = 1.0, .high = 5000.0, .meaning = "width of the slope"});
    options.number("terrain.channel_depth_m", r.channel_depth_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = 500.0,
                    .meaning = "cross-section: height + depth * min(|y| / half width, 1)^2"});
    options.number("terrain.channel_half_width_m", r.channel_half_width_m,
                   {.unit = "m", .low = 0.1, .high = 2500.0, .meaning = "half width of the channel"});
    options.number("terrain.cell_m", r.cell_m,
                   {.unit = "m", .low = 0.1, .high = 100.0, .meaning = "cell size of the rebuilt DEM"});
    options.number("terrain.relief_m", r.relief_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = 10.0,
                    .meaning = "standard deviation of independent normal heights added at each grid node"});
    options.count(
        "terrain.relief_seed", r.relief_seed,
        {.low = 0.0, .high = 9007199254740992.0, .meaning = "key of the random heights of the relief"});
    options.text(
        "terrain.relief_file", r.relief_file,
        {.meaning = "grid of heights to lay on the slope: the relief of a real one; columns run down "
                    "the slope, and its mirror image goes on beyond the grid"});
    options.number("terrain.relief_shift_m", r.relief_shift_m,
                   {.unit = "m",
                    .low = -10'000.0,
                    .high = 10'000.0,
                    .meaning = "how far down the slope that grid is moved"});
    options.number("terrain.relief_across_m", r.relief_across_m,
                   {.unit = "m",
                    .low = -10'000.0,
                    .high = 10'000.0,
                    .meaning = "how far to the left that grid is moved"});
    options.number("terrain.slope_change_deg", r.slope_change_deg,
                   {.unit = "deg",
                    .low = -14.0,
                    .high = 14.0,
                    .meaning = "added to every piece of the profile steeper than 15 deg"});
}

void declare_stand(config::Options& options, Recipe& r) {
    options.number("stand.stems_per_ha", r.stems_per_ha,
                   {.unit = "1/ha", .low = 0.0, .high = 20'000.0, .meaning = "trees; 0: none"});
    options.number("stand.dbh_mean_cm", r.dbh_mean_cm,
                   {.unit = "cm", .low = 1.0, .high = 200.0, .meaning = "mean DBH"});
    options.number("stand.dbh_deviation_cm", r.dbh_deviation_cm,
                   {.unit = "cm",
                    .low = 0.0,
                    .high = 100.0,
                    .meaning = "standard deviation of the DBH (gamma distribution)"});
    options.text("stand.species", r.species_text,
                 {.meaning = "shares of the basal area in percent, such as ABAL:72, FASY:28"});
    options.number("stand.from_m", r.stand_from_m,
                   {.unit = "m",
                    .low = -10.0,
                    .high = 10'000.0,
                    .meaning = "plan distance it begins at; the slope goes on for 10 m above the start"});
    options.number("stand.to_m", r.stand_to_m,
                   {.unit = "m", .low = 0.0, .high = 10'000.0, .meaning = "plan distance it ends at"});
    options.number("stand.spacing_m", r.spacing_m,
                   {.unit = "m", .low = 0.0, .high = 20.0, .meaning = "smallest distance between stems"});
    options.count("stand.stands", r.stands,
                  {.low = 1.0, .high = 10'000.0, .meaning = "stands in the ensemble of stands"});
}

void declare_rest(config::Options& options, Recipe& r) {
    options.text("stations.names", r.station_names,
                 {.meaning = "lines across the slope, names between commas"});
    options.numbers("stations.distances_m", r.station_distances_m,
                    {.unit = "m", .low = 0.0, .high = 10'000.0, .meaning = "their plan distances"});
    options.number("surfaces.p_stop_factor", r.p_stop_factor,
                   {.low = 0.0, .high = 100.0, .meaning = "multiplies p_stop of every ground type"});
    options.number("surfaces.rt_change", r.rt_change,
                   {.low = -0.5, .high = 0.5, .meaning = "added to r_t of every ground type"});
    options.number("surfaces.rn_change", r.rn_change,
                   {.low = -0.5, .high = 0.5, .meaning = "added to r_n of every ground type"});
    options.text("rockfall.preset", r.preset,
                 {.meaning = "default, or a named set: strict, paper_rebound, paper_initial"});
    rockfall::declare(options, r.rockfall);
    options.free_section("factors");
    GroundChanges::declare(options);
}

/// The relief that a recipe names.
Relief read_relief(const CaseFiles& files, const Recipe& recipe) {
    if (recipe.relief_file.empty()) {
        return {};
    }
    const auto text = files.texts.find(recipe.relief_file);
    if (text == files.texts.end()) {
        config::fail(config::ExitCode::file, recipe.options->place_of("terrain.relief_file"),
                     joined("no file ", path_in_quotes(recipe.relief_file), " in ", files.folder),
                     "a grid of heights");
    }
    auto heights = std::make_shared<const config::Raster<double>>(
        config::read_ascii_grid(text->second, files.shown(recipe.relief_file)));
    if (std::any_of(heights->values.begin(), heights->values.end(),
                    [](double height_m) { return std::isnan(height_m); })) {
        config::fail(config::ExitCode::data, {files.shown(recipe.relief_file)}, "cells without a height",
                     "a height in each cell: the relief is repeated over the slope");
    }
    return {std::move(heights), recipe.relief_shift_m, recipe.relief_across_m};
}

/// The words between commas, without blanks around them; an empty text has none.
std::vector<std::string> between_commas(std::string_view text) {
    std::vector<std::string> words;
    while (!config::trimmed(text).empty()) {
        const std::size_t comma = std::min(text.find(','), text.size());
        words.emplace_back(config::trimmed(text.substr(0, comma)));
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
    return words;
}

/// Adds what settings that are each legal get wrong together.
class RecipeCheck {
public:
    explicit RecipeCheck(Recipe& recipe) : recipe_{recipe} {}

    void run() {
        check_head();
        read_stations();
        if (recipe_.has_stand()) {
            read_species();
            check_stand();
        }
        problems_.throw_if_any();
    }

private:
    void refuse(const std::string& key, std::string found, std::string expected) {
        problems_.add(config::ExitCode::settings, recipe_.options->place_of(key), std::move(found),
                      std::move(expected));
    }

    void check_head() {
        if (is_forest(recipe_.head.kind)) {
            refuse("case.kind", "a kind of the forest for a case with rocks", "the kind of its case.ini");
        }
        if (recipe_.head.title.empty()) {
            refuse("case.title", "no case.title", "one line on what the case is");
        }
        const std::vector<config::FreeEntry>& entries = recipe_.options->free_entries();
        const auto factor = std::find_if(entries.begin(), entries.end(), [](const config::FreeEntry& entry) {
            return entry.section == "factors";
        });
        if (recipe_.head.kind != CaseKind::factors && factor != entries.end()) {
            problems_.add(config::ExitCode::settings, factor->place, "section [factors]",
                          "case.kind = factors");
        }
        if (recipe_.head.kind == CaseKind::profile && recipe_.has_stand()) {
            refuse("stand.stems_per_ha", "a stand on a profile", "case.kind = slope for trees");
        }
        if (recipe_.head.kind == CaseKind::profile) {
            refuse_what_profiles_lack();
        }
    }

    /// A setting that would change nothing is worse than none.
    void refuse_what_profiles_lack() {
        std::vector<std::string> lacking = rockfall::sideways_settings();
        lacking.insert(lacking.end(), {"terrain.width_m", "terrain.channel_depth_m",
                                       "terrain.channel_half_width_m", "terrain.cell_m", "terrain.relief_m",
                                       "terrain.relief_seed", "rockfall.vertical_tolerance_m"});
        for (const std::string& key : lacking) {
            if (recipe_.options->was_set(key)) {
                refuse(key, joined(key, " on a profile"), "case.kind = slope for it");
            }
        }
    }

    void read_stations() {
        const std::vector<std::string> names = between_commas(recipe_.station_names);
        const std::vector<double>& distances_m = recipe_.station_distances_m;
        if (names.size() != distances_m.size()) {
            refuse("stations.names",
                   joined(std::to_string(names.size()), " stations and ", std::to_string(distances_m.size()),
                          " distances"),
                   "one distance for each station");
            return;
        }
        for (std::size_t i = 0; i < names.size(); ++i) {
            const bool again = std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i),
                                         names[i]) != names.begin() + static_cast<std::ptrdiff_t>(i);
            if (again || names[i].empty()) {
                refuse("stations.names", joined("station ", config::in_quotes(names[i])),
                       "a name of its own for each station");
            }
            recipe_.stations.push_back({names[i], distances_m[i]});
        }
    }

    void read_species() {
        const SpeciesTable known = SpeciesTable::shipped();
        double sum = 0.0;
        for (const std::string& entry : between_commas(recipe_.species_text)) {
            const std::size_t colon = std::min(entry.find(':'), entry.size());
            const std::string code{config::trimmed(entry.substr(0, colon))};
            const auto share_percent = config::parse_number(
                config::trimmed(std::string_view{entry}.substr(std::min(colon + 1, entry.size()))));
            const Species* species = known.find(code);
            if (species == nullptr) {
                const std::string nearest = known.nearest(code);
                refuse("stand.species", joined("species ", config::in_quotes(code)),
                       joined("a code of the species table", nearest.empty() ? "" : " (", nearest,
                              nearest.empty() ? "" : "?)"));
            } else if (!share_percent || *share_percent <= 0.0 || *share_percent > 100.0) {
                refuse("stand.species", config::in_quotes(entry),
                       "a species and its share in percent, such as ABAL:72");
            } else {
                recipe_.species.push_back({species->code, *share_percent, species->fracture_energy});
                sum += *share_percent;
            }
        }
        if (sum <= 0.0) {
            refuse("stand.species", "no species", "shares of the basal area, such as ABAL:72, FASY:28");
            return;
        }
        for (SpeciesShare& species : recipe_.species) {
            species.share /= sum;
        }
    }

    void check_stand() {
        if (recipe_.stand_to_m <= recipe_.stand_from_m) {
            refuse("stand.to_m", joined("stand.to_m ", config::to_text(recipe_.stand_to_m)),
                   "a distance beyond stand.from_m");
        }
        // Random places with a smallest distance jam at a cover of 0.547 by discs of that diameter.
        constexpr double pi_quarter = 0.785398163397448;
        const double cover = recipe_.stems_per_ha * 1e-4 * pi_quarter * recipe_.spacing_m * recipe_.spacing_m;
        if (cover > 0.4) {
            refuse("stand.spacing_m",
                   joined("stand.spacing_m ", config::to_text(recipe_.spacing_m), " for ",
                          config::to_text(recipe_.stems_per_ha), " stems/ha"),
                   "a distance that leaves room for all stems");
        }
    }

    Recipe& recipe_;
    config::Problems problems_;
};

}  // namespace

void declare(config::Options& options, CaseHead& head) {
    options.text("case.title", head.title, {.meaning = "one line on what the case is"});
    options.text("case.citation", head.citation, {.meaning = "where its figures were published"});
    options.choice("case.kind", head.kind, kinds(),
                   {.meaning = "three dimensions, a profile without deviation and trees, factors, or a part "
                               "of the forest"});
    options.text("case.rebuilt", head.rebuilt,
                 {.meaning = "what is rebuilt, and what that means for the verdicts"});
}

void declare(config::Options& options, Recipe& recipe) {
    declare(options, recipe.head);
    declare_rock(options, recipe);
    declare_series(options, recipe);
    declare_terrain(options, recipe);
    declare_stand(options, recipe);
    declare_rest(options, recipe);
}

std::unique_ptr<Recipe> read_recipe(const CaseFiles& files, const std::vector<std::string>& overrides) {
    auto recipe = std::make_unique<Recipe>();
    recipe->options = std::make_unique<config::Options>();
    declare(*recipe->options, *recipe);
    std::istringstream in{files.texts.at(slope_recipe_file)};
    recipe->options->read(in, files.shown(slope_recipe_file), overrides, "rockfall.preset");
    RecipeCheck{*recipe}.run();
    recipe->relief = read_relief(files, *recipe);
    if (recipe->head.kind == CaseKind::profile) {
        rockfall::stay_in_plane(recipe->rockfall);
    }
    rockfall::take_over(recipe->rockfall, *recipe->options);
    return recipe;
}

namespace {

/// The nearest by spelling, or the kind of which the word is the end, as `production` of forest_production.
std::string kind_meant_by(const std::string& word, const std::vector<std::string>& names) {
    const auto of_forest = std::find(names.begin(), names.end(), joined("forest_", word));
    return of_forest != names.end() ? *of_forest : config::nearest_word(word, names);
}

}  // namespace

void require_kind(const CaseFiles& files) {
    config::Problems reported;  // by the reader of the kind
    std::istringstream in{files.texts.at(slope_recipe_file)};
    std::vector<std::string> names;
    std::string list;
    for (const auto& [name, kind] : kinds()) {
        names.push_back(name);
        list += joined(list.empty() ? "" : ", ", name);
    }
    bool has_terrain = files.has("profile.csv");
    for (const config::IniEntry& entry : config::read_ini(in, files.shown(slope_recipe_file), reported)) {
        has_terrain = has_terrain || entry.key().starts_with("terrain.");
        if (entry.key() != "case.kind") {
            continue;
        }
        if (std::find(names.begin(), names.end(), entry.value) == names.end()) {
            const std::string nearest = kind_meant_by(entry.value, names);
            config::fail(config::ExitCode::settings, entry.value_place,
                         joined("case.kind ", config::in_quotes(entry.value)),
                         nearest.empty() ? joined("one of ", list) : config::in_quotes(nearest),
                         "validation/README.md says which files each kind has");
        }
        return;
    }
    if (!has_terrain) {
        config::fail(config::ExitCode::settings, {files.shown(slope_recipe_file)},
                     "no case.kind, and no slope for rocks",
                     joined("a line `kind = ` under [case] with one of ", list),
                     "add it: validation/README.md says which files each kind has");
    }
}

CaseHead head_of(const CaseFiles& files) {
    config::Problems ignored;
    std::istringstream in{files.texts.at(slope_recipe_file)};
    CaseHead head;
    for (const config::IniEntry& entry : config::read_ini(in, files.shown(slope_recipe_file), ignored)) {
        if (entry.key() == "case.title") {
            head.title = entry.value;
        }
        for (const auto& [name, kind] : kinds()) {
            if (entry.key() == "case.kind" && entry.value == name) {
                head.kind = kind;
            }
        }
    }
    return head;
}

}  // namespace coupling::validation
