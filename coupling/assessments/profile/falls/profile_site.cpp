#include "coupling/assessments/profile/falls/profile_site.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "config/table/schema.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/ground/ground_names.hpp"
#include "coupling/inputs/ground/surface_types.hpp"
#include "coupling/inputs/model_limits.hpp"
#include "coupling/inputs/parameters/parameter_knowledge.hpp"
#include "coupling/inputs/plausible/heights.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/reading/guesses.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/scenario/profile_settings.hpp"
#include "coupling/inputs/scenario/release_settings.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/scenario/terrain_settings.hpp"
#include "coupling/inputs/tables/words.hpp"

namespace coupling::profile {
namespace {

using config::joined;

constexpr config::NumberRange distance_range{.low = -1e5, .high = 1e5};
constexpr config::NumberRange height_range{.low = -1000.0, .high = 10'000.0};
/// Corners nearer to each other are taken for one written twice.
constexpr double least_step_m = 1e-3;

std::vector<rockfall::ProfilePoint> corners_of(const config::Table& table, GroundNames& types) {
    config::RowProblems wrong{table};
    std::vector<rockfall::ProfilePoint> corners;
    if (table.rows() < 2) {
        wrong.refuse(counted(table.rows(), "corner"), "at least two corners of a profile");
    }
    std::uint8_t surface_before = 0;
    for (const config::Read<rockfall::ProfilePoint>& row : corner_columns().rows(table, wrong)) {
        // The last corner carries no ground.
        const bool needs_surface = row.row + 1 < table.rows() || has_value(table, row.row, "surface");
        if (needs_surface) {
            surface_before = types.place_of(table, row.row, "distance_m", wrong).value_or(surface_before);
        }
        if (!corners.empty() && row.distance_m < corners.back().distance_m + least_step_m) {
            wrong.refuse(row.row, "distance_m",
                         joined("distance_m ", table.text(row.row, "distance_m"), " after ",
                                config::to_text(corners.back().distance_m)),
                         "distances that rise from corner to corner, by 0.001 m at least");
        }
        corners.push_back({row.distance_m, row.height_m, surface_before});
    }
    if (!corners.empty() && corners.back().height_m > corners.front().height_m) {
        wrong.refuse(joined("a profile that rises from ", config::to_text(corners.front().height_m), " m to ",
                            config::to_text(corners.back().height_m), " m"),
                     "corners from above to below, distances from the upper end");
    }
    wrong.throw_first();
    return corners;
}

std::string name_of_distance(double distance_m) {
    return config::to_text(distance_m) + " m";
}

/// A station or the start has to lie on the profile.
void check_on_profile(const std::vector<rockfall::ProfilePoint>& corners, double distance_m,
                      const config::Place& place, const std::string& what, config::Problems& problems) {
    if (distance_m < corners.front().distance_m || distance_m > corners.back().distance_m) {
        problems.add(config::ExitCode::data, place,
                     what + " at " + name_of_distance(distance_m) + " beyond the profile",
                     "a distance in [" + config::to_text(corners.front().distance_m) + ", " +
                         config::to_text(corners.back().distance_m) + "] m");
    }
}

std::vector<Station> listed_stations(const Scenario& scenario,
                                     const std::vector<rockfall::ProfilePoint>& corners) {
    config::Problems problems;
    std::vector<Station> stations;
    for (const double distance_m : scenario.profile.stations_m) {
        check_on_profile(corners, distance_m, scenario.options->place_of("profile.stations_m"), "a station",
                         problems);
        stations.push_back({name_of_distance(distance_m), distance_m});
    }
    problems.throw_if_any();
    return stations;
}

std::vector<Station> stations_in(const config::Table& table,
                                 const std::vector<rockfall::ProfilePoint>& corners) {
    config::RowProblems wrong{table};
    std::vector<Station> stations;
    for (const config::Read<Station>& row : station_columns().rows(table, wrong)) {
        check_on_profile(corners, row.distance_m, table.place(row.row, "distance_m"), "a station", wrong);
        stations.push_back({row.name.empty() ? name_of_distance(row.distance_m) : row.name, row.distance_m});
    }
    wrong.throw_first();
    return stations;
}

std::vector<Station> read_stations(Reading& reading, const std::vector<rockfall::ProfilePoint>& corners) {
    const std::string& file = reading.profile().stations;
    std::vector<Station> stations;
    reading.attempt([&] {
        stations = file.empty() ? listed_stations(reading.scenario(), corners)
                                : stations_in(table_of(station_columns(), file, reading), corners);
        return 0;
    });
    std::stable_sort(stations.begin(), stations.end(),
                     [](const Station& a, const Station& b) { return a.distance_m < b.distance_m; });
    return stations;
}

/// Ground types that no cell of the map of ground types may show.
void doubt_narrow_steps(const std::vector<rockfall::ProfilePoint>& corners, Reading& reading) {
    for (std::size_t k = 1; k + 2 < corners.size(); ++k) {
        const double width_m = corners[k + 1].distance_m - corners[k].distance_m;
        if (width_m < rockfall::profile_surface_cell_m && corners[k].surface != corners[k - 1].surface &&
            corners[k].surface != corners[k + 1].surface) {
            reading.note(
                "profile: the ground type at " + name_of_distance(corners[k].distance_m) + " reaches over " +
                config::to_text(std::round(1e4 * width_m) / 1e4) +
                " m only; rocks may meet that of its neighbours there (types are resolved to 0.05 m)");
        }
    }
}

/// A rock at rest on ground that holds it goes nowhere.
void doubt_start(const ProfileSite& site, const Scenario& scenario, Reading& reading) {
    const auto triangle = site.slope.terrain.locate(site.start_m, 0.0);
    const double rise = triangle ? site.slope.terrain.plane_of(*triangle).gradient.x() : 0.0;
    if (rise > 1e-9) {
        reading.warn(scenario.options->place_of("profile.start_m"),
                     "ground that rises with distance at the start, " + name_of_distance(site.start_m) +
                         ": rocks go down it, against the distance",
                     "a start where the ground falls");
    }
}

struct Files {
    std::vector<rockfall::ProfilePoint> corners;
    std::vector<rockfall::SurfaceType> types;
};

std::optional<Files> read_files(Reading& reading) {
    auto own = read_surface_types(rockfall::diameter_range(start_law(reading.release()), {}), reading);
    auto elsewhere = reading.attempt([&] { return uniform_ground(reading); });
    if (!own || !elsewhere) {
        return std::nullopt;  // every type of the profile would be called unknown
    }
    return reading.attempt([&] {
        const config::Table table = table_of(corner_columns(), reading.terrain().profile, reading);
        GroundNames types{std::move(*own), std::move(*elsewhere), *reading.settings().options};
        std::vector<rockfall::ProfilePoint> corners = corners_of(table, types);
        return Files{std::move(corners), std::move(types).list()};
    });
}

}  // namespace

const config::Schema<rockfall::ProfilePoint>& corner_columns() {
    using R = rockfall::ProfilePoint;
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "profile", .setting = "terrain.profile", .row = "corner"},
        {{"distance_m", &R::distance_m, "in plan, rising from corner to corner", {.range = distance_range}},
         {"height_m", &R::height_m, "of the ground", {.range = height_range}},
         {"surface", "from this corner to the next: a shipped ground type or a code of terrain.surface_types; empty: terrain.ground", {.optional = true}}}};
    // clang-format on
    return columns;
}

const config::Schema<Station>& station_columns() {
    // clang-format off
    static const config::Schema<Station> columns{
        {.role = "stations", .setting = "profile.stations", .row = "station"},
        {{"name", &Station::name, "in results; empty: its distance", {.may_be_empty = true}},
         {"distance_m", &Station::distance_m, "in plan, as in the profile", {.range = distance_range}}}};
    // clang-format on
    return columns;
}

double ProfileSite::height_m(double distance_m) const {
    const auto next = std::upper_bound(
        corners.begin() + 1, corners.end() - 1, distance_m,
        [](double x_m, const rockfall::ProfilePoint& corner) { return x_m < corner.distance_m; });
    const rockfall::ProfilePoint& a = *(next - 1);
    const double share = (distance_m - a.distance_m) / (next->distance_m - a.distance_m);
    return a.height_m + std::clamp(share, 0.0, 1.0) * (next->height_m - a.height_m);
}

double ProfileSite::slope_length_m(double distance_m) const {
    double length_m = 0.0;
    for (std::size_t k = 0; k + 1 < corners.size() && corners[k].distance_m < distance_m; ++k) {
        const double step_m = corners[k + 1].distance_m - corners[k].distance_m;
        const double share = std::min(1.0, (distance_m - corners[k].distance_m) / step_m);
        length_m += share * std::hypot(step_m, corners[k + 1].height_m - corners[k].height_m);
    }
    return length_m;
}

double ProfileSite::distance_at_m(double slope_length_m) const {
    double left_m = slope_length_m;
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
        const double step_m = corners[k + 1].distance_m - corners[k].distance_m;
        const double length_m = std::hypot(step_m, corners[k + 1].height_m - corners[k].height_m);
        if (left_m <= length_m) {
            return corners[k].distance_m + std::max(0.0, left_m / length_m) * step_m;
        }
        left_m -= length_m;
    }
    return last_m();
}

namespace {

ProfileSite profile_of(Reading& reading) {
    const Scenario& scenario = reading.scenario();
    reading.note_settings();
    doubt_guesses(reading);
    std::optional<Files> files = read_files(reading);
    if (!files) {
        reading.problems().throw_if_any();
    }
    reading.attempt([&] {
        const auto [low, high] =
            std::minmax_element(files->corners.begin(), files->corners.end(),
                                [](const auto& a, const auto& b) { return a.height_m < b.height_m; });
        plausible::check_height_range(low->height_m, high->height_m, reading.shown(scenario.terrain.profile));
        return true;
    });
    const double start_m = scenario.options->was_set("profile.start_m") ? scenario.profile.start_m
                                                                        : files->corners.front().distance_m;
    check_on_profile(files->corners, start_m, scenario.options->place_of("profile.start_m"),
                     "profile.start_m", reading.problems());
    if (start_m >= files->corners.back().distance_m && reading.problems().empty()) {
        reading.refuse(scenario.options->place_of("profile.start_m"), "a start at the end of the profile",
                       "less than " + name_of_distance(files->corners.back().distance_m));
    }
    std::vector<Station> stations = read_stations(reading, files->corners);
    auto knowledge = reading.attempt([&] { return read_parameter_knowledge(files->types, reading); });
    reading.problems().throw_if_any();
    doubt_narrow_steps(files->corners, reading);

    const rockfall::GroundLaw& law = scenario.rockfall.ground;
    const std::vector<rockfall::ProfilePoint> felt = rockfall::contact_zone(
        files->corners, law.contact_law(rockfall::diameter_range(start_law(scenario.release), {}).mean_m));
    ProfileSite site{.corners = std::move(files->corners),
                     .slope = rockfall::strip_slope(felt, std::move(files->types)),
                     .start_m = start_m,
                     .stations = std::move(stations),
                     .knowledge = std::move(knowledge).value_or(nullptr),
                     .inputs = reading.inputs()};
    add_logo(scenario, site.inputs);
    doubt_start(site, scenario, reading);
    warn_of_model_limits(site.slope, {}, reading);
    reading.finish();
    return site;
}

}  // namespace

ProfileSite open_profile(const Scenario& scenario, config::Warnings& warnings) {
    Reading reading{scenario, warnings};
    return scenario.with_paths([&] { return profile_of(reading); });
}

}  // namespace coupling::profile
