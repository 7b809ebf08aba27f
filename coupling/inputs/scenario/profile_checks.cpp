#include "coupling/inputs/scenario/profile_checks.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/inputs/scenario/scenario.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::profile {
namespace {

/// A key, or the beginning of several, and why it has no meaning along a profile.
struct Meaningless {
    std::string_view key;
    std::string_view instead;
};

constexpr std::array meaningless{
    Meaningless{"terrain.dem", "one of the two: the profile is all the terrain there is"},
    Meaningless{"terrain.points", "one of the two: the profile is all the terrain there is"},
    Meaningless{"terrain.mesh", "one of the two: the profile is all the terrain there is"},
    Meaningless{"terrain.meshes", "one of the two: the profile is all the terrain there is"},
    Meaningless{"terrain.plane_width_m", "one of the two: the profile is all the terrain there is"},
    Meaningless{"terrain.plane_length_m", "one of the two: the profile is all the terrain there is"},
    Meaningless{"terrain.plane_elevation_m", "heights in the profile"},
    Meaningless{"terrain.plane_slope_deg", "heights in the profile"},
    Meaningless{"terrain.plane_aspect_deg", "nothing: a profile faces nowhere"},
    Meaningless{"terrain.extent_m", "nothing: a profile is no part of a map"},
    Meaningless{"terrain.fill_holes_m2", "nothing: a profile has no holes"},
    Meaningless{"terrain.longest_edge_m", "nothing: a profile has no triangles to leave out"},
    Meaningless{"terrain.surface", "ground types in the column surface of the profile"},
    Meaningless{"terrain.surface_polygons", "ground types in the column surface of the profile"},
    Meaningless{"terrain.slope_grounds", "ground types in the column surface of the profile"},
    Meaningless{"terrain.picture", "nothing: a profile has no maps"},
    Meaningless{"trees.", "nothing: rocks meet no trees along a profile"},
    Meaningless{"release.source", "profile.start_m"},
    Meaningless{"release.source_shapes", "profile.start_m"},
    Meaningless{"release.steeper_than_deg", "profile.start_m"},
    Meaningless{"release.rocks_per_source", "release.rocks"},
    Meaningless{"release.random_place", "nothing: all rocks start at profile.start_m"},
    Meaningless{"release.start_scatter_deg", "nothing: rocks are not turned sideways along a profile"},
    Meaningless{"observed.", "nothing: observed stops are compared on maps alone"},
    Meaningless{"targets.", "profile.stations_m or profile.stations"},
    Meaningless{"output.cell_size_m", "nothing: a profile has no maps"},
    Meaningless{"output.shapefile", "nothing: a profile has no layers"},
    Meaningless{"output.kml", "nothing: a profile has no layers"},
    Meaningless{"output.gpx", "nothing: a profile has no layers"},
    Meaningless{"output.percentiles", "nothing: a profile has no maps"},
    Meaningless{"output.arrivals", "nothing: a profile has stations, whose rocks are in rocks.csv"},
    Meaningless{"output.tree_hit_table", "nothing: rocks meet no trees along a profile"},
    Meaningless{"rockfall.vertical_tolerance_m", "nothing: a profile is not thinned"},
    Meaningless{"tree_impact.", "nothing: rocks meet no trees along a profile"},
    Meaningless{"log_impact.", "nothing: rocks meet no logs along a profile"},
    Meaningless{"forest.", "nothing: no forest grows along a profile"},
    Meaningless{"stands.", "nothing: no forest grows along a profile"},
    Meaningless{"soil.", "nothing: no forest grows along a profile"},
    Meaningless{"climate.", "nothing: no forest grows along a profile"},
};

const Meaningless turning{"", "nothing: rocks are not turned sideways along a profile"};

const Meaningless* found_for(const std::string& key) {
    static const std::vector<std::string> sideways = rockfall::sideways_settings();
    if (std::find(sideways.begin(), sideways.end(), key) != sideways.end()) {
        return &turning;
    }
    const auto found = std::find_if(meaningless.begin(), meaningless.end(), [&](const Meaningless& entry) {
        return entry.key.ends_with('.') ? key.starts_with(entry.key) : key == entry.key;
    });
    return found == meaningless.end() ? nullptr : &*found;
}

void check_without_profile(const config::Options& options, config::Problems& problems) {
    for (const config::ParameterRow& row : options.rows()) {
        if (row.key.starts_with("profile.") && options.was_set(row.key)) {
            problems.add(config::ExitCode::settings, options.place_of(row.key),
                         row.key + " without terrain.profile", "a profile in terrain.profile");
        }
    }
}

}  // namespace

bool plays_no_part(const std::string& key) {
    return found_for(key) != nullptr;
}

void check_settings(const Scenario& scenario, config::Problems& problems) {
    const config::Options& options = *scenario.options;
    if (scenario.terrain.profile.empty()) {
        check_without_profile(options, problems);
        return;
    }
    for (const config::ParameterRow& row : options.rows()) {
        const Meaningless* entry = found_for(row.key);
        if (entry != nullptr && options.was_set(row.key)) {
            problems.add(config::ExitCode::settings, options.place_of(row.key),
                         row.key + " beside terrain.profile", std::string{entry->instead});
        }
    }
    if (!scenario.profile.stations.empty() && !scenario.profile.stations_m.empty()) {
        problems.add(config::ExitCode::settings, options.place_of("profile.stations"),
                     "profile.stations beside profile.stations_m", "only one of them");
    }
}

void turn_deviation_off(Scenario& scenario) {
    rockfall::stay_in_plane(scenario.rockfall);
}

}  // namespace coupling::profile
