#include "coupling/inputs/site.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/inputs/forest/forest_site.hpp"
#include "coupling/inputs/forest/log_input.hpp"
#include "coupling/inputs/forest/stand_trees.hpp"
#include "coupling/inputs/forest/tree_input.hpp"
#include "coupling/inputs/ground/surface_types.hpp"
#include "coupling/inputs/model_limits.hpp"
#include "coupling/inputs/nets/net_input.hpp"
#include "coupling/inputs/observed/observed_events_input.hpp"
#include "coupling/inputs/observed/observed_input.hpp"
#include "coupling/inputs/parameters/parameter_knowledge.hpp"
#include "coupling/inputs/picture/ground_picture.hpp"
#include "coupling/inputs/places/target_input.hpp"
#include "coupling/inputs/plausible/heights.hpp"
#include "coupling/inputs/reading/drawing_input.hpp"
#include "coupling/inputs/reading/guesses.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/reading/stands_of_today.hpp"
#include "coupling/inputs/release/release_input.hpp"
#include "coupling/inputs/release/source_places.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/terrain/contact_notes.hpp"
#include "coupling/inputs/terrain/mesh_input.hpp"
#include "coupling/inputs/terrain/sampled_heights.hpp"
#include "coupling/inputs/terrain/surface_input.hpp"
#include "coupling/inputs/terrain/terrain_input.hpp"
#include "coupling/inputs/works/barriers_at_targets.hpp"
#include "coupling/inputs/works/work_input.hpp"
#include "coupling/inputs/works/work_places.hpp"
#include "rockfall/draws/strata.hpp"

namespace coupling {
namespace {

config::GridFrame relative_to(const config::GridFrame& frame, const Eigen::Vector2d& origin_m) {
    config::GridFrame relative = frame;
    relative.x_west_m -= origin_m.x();
    relative.y_south_m -= origin_m.y();
    return relative;
}

/// The ground types on another frame, by the cell that each centre lies in.
config::Raster<std::uint8_t> on_frame(const config::Raster<std::uint8_t>& ids,
                                      const config::GridFrame& frame) {
    if (ids.frame == frame) {
        return ids;
    }
    config::Raster<std::uint8_t> result{frame, GroundMap::none};
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        const config::Cell place = frame.cell_of(i);
        const config::Cell cell =
            ids.frame.cell_at(frame.x_centre_m(place.column), frame.y_centre_m(place.row));
        if (ids.frame.contains(cell)) {
            result.values[i] = ids.at(cell);
        }
    }
    return result;
}

/// Everything as read from the files; what could not be read is missing.
struct SiteFiles {
    std::optional<HeightInput> heights;
    std::optional<std::vector<rockfall::SurfaceType>> types;
    std::optional<GroundCover> cover;
    std::optional<SourceInput> sources;
    std::optional<std::vector<TreeRecord>> trees;
    std::optional<std::vector<LogRecord>> logs;
    std::optional<GivenTargets> targets;
    std::optional<GivenNets> nets;
    std::optional<GivenWorks> works;
    std::optional<std::vector<ObservedStop>> observed;
    std::optional<ObservedEvents> events;
};

SiteFiles read_site_files(Reading& reading) {
    const Scenario& scenario = reading.scenario();
    SiteFiles files;
    files.heights = read_heights(reading);
    files.trees.emplace();
    if (scenario.run.years == 0) {
        files.trees = read_trees(reading);
    }
    if (has_rocks(scenario)) {
        files.sources = read_sources(reading);
        files.types = read_surface_types(diameters_of(files.sources, scenario.release), reading);
        files.cover = read_ground_cover(reading);
        files.logs = read_logs(reading);
        files.targets = read_targets(reading);
        files.nets = read_nets(reading);
        files.works = read_works(reading);
        files.observed = read_observed_stops(reading);
        if (files.targets) {
            files.events = read_observed_events(files.targets->targets, reading);
        }
    }
    return files;
}

/// What `of` makes of the heights for a forest: of the grid as read, of points those of their terrain in
/// cells of 5 m [choice].
template <class Of>
auto on_cells(const HeightInput& heights, const rockfall::Terrain& terrain, const Of& of) {
    if (heights.grid) {
        return of(*heights.grid);
    }
    HeightInput cells;
    cells.map_frame = frame_over(heights.points, 5.0);
    return of(heights_on_map(cells, terrain));
}

/// The ground at the listed trees, in absolute coordinates, and the rules on heights for a terrain that is no
/// grid; a grid was held against them when it was read.
void check_ground(const HeightInput& heights, const rockfall::Terrain& terrain,
                  const std::vector<TreeRecord>& trees, Reading& reading) {
    std::vector<plausible::terrain::ListedTree> listed;
    for (const TreeRecord& tree : trees) {
        listed.push_back({tree.stem.x_m, tree.stem.y_m, tree.stem.height_m});
    }
    if (terrain.triangles().empty()) {
        return;
    }
    if (heights.grid) {
        plausible::check_ground_at_trees(*heights.grid, listed, heights.file, reading);
        return;
    }
    const config::Raster<double> samples = plausible::sampled_heights(heights, terrain);
    plausible::check_sampled_heights(samples, heights.file, reading);
    plausible::check_ground_at_trees(samples, listed, heights.file, reading);
}

std::vector<std::string> ids_of(const std::vector<rockfall::Target>& targets) {
    std::vector<std::string> ids;
    for (const rockfall::Target& target : targets) {
        ids.push_back(target.id);
    }
    return ids;
}

/// Takes the obstacles that rocks cannot meet out of the forest.
void drop_off_terrain(ForestSite& forest, const rockfall::Terrain& terrain, Reading& reading) {
    forest.obstacles = on_terrain(std::move(forest.obstacles), terrain, reading, forest.listed.size());
}

}  // namespace

config::GridFrame Site::map_frame_on_terrain() const {
    return relative_to(map_frame, origin_m());
}

std::vector<rockfall::Stem> Site::stems() const {
    std::vector<rockfall::Stem> stems;
    stems.reserve(trees.size());
    for (const TreeRecord& tree : trees) {
        stems.push_back(tree.stem);
    }
    return stems;
}

std::vector<rockfall::Log> Site::lying_logs() const {
    std::vector<rockfall::Log> lying;
    lying.reserve(logs.size());
    for (const LogRecord& record : logs) {
        lying.push_back(record.log);
    }
    return lying;
}

std::vector<rockfall::Net> Site::standing_nets() const {
    std::vector<rockfall::Net> standing;
    standing.reserve(nets.size());
    for (const NetRecord& record : nets) {
        standing.push_back(record.net);
    }
    for (const WorkRecord& work : works) {
        // Rocks pass over the lowest edge there is: an outline only counts them.
        standing.push_back(
            work.kind == WorkKind::wall
                ? rockfall::Net{work.line_m, work.height_m, 0.0, work.capacity_j}
                : rockfall::Net{work.counted_m, 0.0, 0.0, std::numeric_limits<double>::infinity()});
    }
    return standing;
}

void add_logo(const Scenario& scenario, std::vector<InputFile>& inputs) {
    const ReportSettings& report = scenario.report;
    if (!report.logo.empty()) {
        inputs.push_back({role_of_logo, scenario.shown(report.logo), hash_text(report.picture.bytes),
                          static_cast<std::uint64_t>(report.picture.bytes.size())});
    }
}

namespace {

/// Maps of the spread need sources whose rocks are shared evenly among the strata.
void check_rocks_for_spread(const std::vector<rockfall::ReleaseSource>& sources, Reading& reading) {
    const std::uint64_t all = sources.empty() ? 0 : sources.back().first_rock + sources.back().rocks;
    const std::uint32_t strata = rockfall::strata_for(all);
    const auto fewest = std::min_element(
        sources.begin(), sources.end(),
        [](const rockfall::ReleaseSource& a, const rockfall::ReleaseSource& b) { return a.rocks < b.rocks; });
    if (fewest != sources.end() && fewest->rocks < strata) {
        reading.problems().add(config::ExitCode::settings, {"output.spread_maps"},
                               config::joined("a source of ", std::to_string(fewest->rocks), " rocks"),
                               config::joined("at least ", std::to_string(strata), " rocks of each source"),
                               "raise release.rocks_per_source or release.rocks, or leave these maps out");
    }
}

Site site_of(Reading& reading) {
    const Scenario& scenario = reading.scenario();
    reading.note_settings();
    note_drawing(reading);
    doubt_guesses(reading);
    SiteFiles files = read_site_files(reading);
    if (!files.heights) {
        reading.problems().throw_if_any();
    }
    if (!reading.check_systems()) {
        reading.problems().throw_if_any();  // nothing else means anything then
    }
    // What lies on the terrain is checked even where another file is wrong: the user sees all of it at once.
    if (files.heights->has_codes && files.types) {
        meshes::name_ground(*files.heights, *files.types, reading);
    }
    const rockfall::ContactLaw contact =
        scenario.rockfall.ground.contact_law(diameters_of(files.sources, scenario.release).mean_m);
    std::optional<rockfall::Terrain> built = reading.attempt([&] {
        return build_terrain(*files.heights, scenario.rockfall.ground,
                             diameters_of(files.sources, scenario.release).mean_m,
                             scenario.terrain.longest_edge_m, reading);
    });
    if (!built) {
        reading.problems().throw_if_any();  // nothing lies on a terrain that there is not
    }
    rockfall::Terrain& terrain = *built;
    check_ground(*files.heights, terrain, files.trees.value_or(std::vector<TreeRecord>{}), reading);
    std::optional<GroundMap> ground;
    if (files.cover && files.types) {
        ground = match_ground(*files.heights, terrain, *files.cover, std::move(*files.types), reading);
    }
    const bool is_right = reading.problems().empty();  // wrong heights have no noise to speak of
    if (ground && is_right && has_rocks(scenario) && !scenario.terrain.plane.is_given()) {
        note_contact_zone(*files.heights, *ground, contact, reading);
    }
    std::optional<std::vector<rockfall::ReleaseSource>> sources;
    if (files.sources) {
        sources = place_sources(*files.sources, *files.heights, terrain, reading);
    }
    if (sources && scenario.output.spread_maps && scenario.run.parameter_draws && scenario.run.years == 0) {
        check_rocks_for_spread(*sources, reading);
    }
    // Behind the sources: the same rocks start with works and without.
    std::vector<WorkRecord> works;
    if (files.works && ground) {
        works = place_works(std::move(*files.works), sources.value_or(std::vector<rockfall::ReleaseSource>{}),
                            ground->types, terrain, reading);
    }
    if (has_stands_of_today(scenario.run, scenario.trees, scenario.forest)) {
        files.trees = on_cells(*files.heights, terrain, [&](const config::Raster<double>& heights_m) {
            return trees_of_stands(heights_m, files.heights->file, terrain, reading);
        });
    }
    if (files.trees) {
        files.trees = on_terrain(std::move(*files.trees), terrain, reading);
    }
    if (files.logs) {
        files.logs = on_terrain(std::move(*files.logs), terrain, reading);
    }
    if (files.trees && files.logs) {
        clear_ground_of(works, *files.trees, *files.logs, terrain.origin_m(), reading);
    }
    std::vector<rockfall::Target> targets;
    if (files.targets) {
        const std::vector<std::string> given = ids_of(files.targets->targets);
        targets = on_terrain(std::move(*files.targets), terrain, reading);
        if (files.events) {
            keep_targets(*files.events, given, ids_of(targets), reading);
        }
        put_under_roofs(works, targets, reading);
    }
    if (files.observed && sources) {
        check_observed_stops(*files.observed, *sources, terrain, reading);
    }
    if (files.events && ground) {
        check_observed_grounds(*files.events, ground->types, reading);
    }
    std::optional<std::shared_ptr<const ParameterKnowledge>> knowledge;
    if (ground && has_rocks(scenario)) {
        knowledge = reading.attempt([&] { return read_parameter_knowledge(ground->types, reading); });
    }
    std::vector<NetRecord> nets;
    if (files.nets) {
        nets = on_terrain(std::move(*files.nets), terrain, reading);
    }
    judge_barriers_at_targets(nets, works, targets, reading);
    if (sources && files.targets && files.nets) {
        plausible::judge_source_places(
            {terrain, plausible::spacing_of(*files.heights), *sources, targets, nets}, files.sources->file,
            reading);
    }
    const std::shared_ptr<const GroundPicture> picture =
        read_ground_picture(files.heights->map_frame, reading);
    std::shared_ptr<ForestSite> forest;
    if (scenario.run.years > 0) {
        forest = on_cells(*files.heights, terrain, [&](const config::Raster<double>& heights_m) {
            return open_forest(heights_m, files.heights->file, reading);
        });
        if (forest) {
            drop_off_terrain(*forest, terrain, reading);
        }
    }
    reading.check_systems();
    reading.finish();

    if (!has_rocks(scenario)) {
        ground = GroundMap{.types = {},
                           .ids = config::Raster<std::uint8_t>{files.heights->frame(), GroundMap::none}};
    }
    rockfall::SurfaceMap surface = surface_map(*ground, terrain.origin_m());
    config::Raster<double> heights = heights_on_map(*files.heights, terrain);
    std::vector<InputFile> inputs = reading.inputs();
    add_logo(scenario, inputs);
    rockfall::Slope slope{std::move(terrain), std::move(surface), std::move(ground->types)};
    if (has_rocks(scenario)) {
        warn_of_model_limits(slope, *sources, reading);
    }
    return {.slope = std::move(slope),
            .heights = std::move(heights),
            .surface = on_frame(ground->ids, files.heights->map_frame),
            .projection = std::move(files.heights->projection),
            .map_frame = files.heights->map_frame,
            .trees = std::move(*files.trees),
            .logs = std::move(files.logs).value_or(std::vector<LogRecord>{}),
            .sources = std::move(sources).value_or(std::vector<rockfall::ReleaseSource>{}),
            .targets = std::move(targets),
            .nets = std::move(nets),
            .inputs = std::move(inputs),
            .forest = std::move(forest),
            .observed_stops = std::move(files.observed).value_or(std::vector<ObservedStop>{}),
            .observed_events = std::move(files.events).value_or(ObservedEvents{}),
            .knowledge = std::move(knowledge).value_or(nullptr),
            .left_out_faces = std::move(files.heights->left_out),
            .picture = picture,
            .works = std::move(works)};
}

}  // namespace

Site open_site(const Scenario& scenario, config::Warnings& warnings) {
    Reading reading{scenario, warnings};
    return scenario.with_paths([&] { return site_of(reading); });
}

}  // namespace coupling
