#include "coupling/program/actions/estimate.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <limits>
#include <set>

#include "coupling/assessments/decades/members/judged_cuts.hpp"
#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/inputs/forest/forest_site.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/maps/rasters.hpp"
#include "rockfall/motion/models.hpp"
#include "rockfall/obstacles/stem_index.hpp"
#include "rockfall/tally/cell_histograms.hpp"
#include "rockfall/tally/ensemble_tally.hpp"

namespace coupling {

namespace {

/// Sine of the mean slope of a whole path, near the usual energy-line angle.
constexpr double path_steepness = 0.55;
/// Over years, with the stems of each year put in their places and its figures taken, a metre of path takes
/// so many times as long as in an assessment of today: measured on the examples regimes-small and regimes,
/// whose stands are denser.
constexpr double times_as_long_over_years = 2.0;
/// Time of a year on a patch of forest on one thread, what is kept of it and written included: measured on
/// the same examples.
constexpr double seconds_per_patch_year = 55e-6;
/// Tree records that a patch comes to have, groups of young ones included, measured on the shipped examples.
constexpr std::size_t trees_per_patch = 40;

/// Mean height of the sources over the lowest ground.
double mean_drop_m(const Site& site) {
    double lowest_m = std::numeric_limits<double>::infinity();
    for (const rockfall::Vertex& vertex : site.slope.terrain.vertices()) {
        lowest_m = std::min(lowest_m, vertex.z_m);
    }
    double sum_m = 0.0;
    std::size_t found = 0;
    for (const rockfall::ReleaseSource& source : site.sources) {
        const Eigen::Vector2d middle_m = 0.5 * (source.first_m + source.last_m);
        if (const auto height_m = site.slope.terrain.height_m(middle_m.x(), middle_m.y())) {
            sum_m += *height_m - lowest_m;
            ++found;
        }
    }
    return found == 0 ? 0.0 : sum_m / static_cast<double>(found);
}

/// Slopes over which each rock falls: the bare one, and one with what stands and lies on it.
int covers_of(const Site& site) {
    return site.trees.empty() && site.logs.empty() ? 1 : 2;
}

/// Of net_paths.bin: the terrain and a path of each rock on each slope.
std::uint64_t path_bytes(const Scenario& scenario, const Site& site, std::uint64_t paths) {
    const double of_paths = static_cast<double>(paths) * mean_drop_m(site) *
                            rockfall::description_of(scenario.rockfall.fall.motion.model).path_bytes_per_m;
    return site.slope.terrain.vertices().size() * sizeof(rockfall::Vertex) +
           site.slope.terrain.triangles().size() * sizeof(rockfall::Triangle) +
           static_cast<std::uint64_t>(of_paths);
}

/// While results are written: measured on the examples tyrol and jura, 2000 to 200 000 rocks, maps of 2 to
/// 10 m.
std::uint64_t result_bytes(const Site& site) {
    constexpr std::uint64_t of_page = 12'000'000;
    constexpr std::uint64_t of_tree = 2'200;
    constexpr std::uint64_t of_rock = 250;
    return of_page + of_tree * site.trees.size() + of_rock * site.rocks();
}

/// Grids of a run of today by slope and, with a forest, as difference.
std::size_t rasters_of(const Scenario& scenario, std::uint64_t covers) {
    std::size_t rasters = 0;
    for (const RasterKind& kind : raster_kinds()) {
        if (!kind.percentile || scenario.output.percentiles) {
            rasters += covers + (kind.compared && covers > 1 ? 1U : 0U);
        }
    }
    const bool has_spread = scenario.output.spread_maps;
    return rasters +
           covers * ((scenario.output.repeats > 0 ? 1U : 0U) + (has_spread ? spread_kinds().size() : 0U) +
                     (scenario.hazard.blocks.empty() ? 0U : release_kinds().size()));
}

/// As ESRI ASCII; `reached`: cells on all slopes together in which a number stands.
std::uint64_t raster_bytes(const Scenario& scenario, const Site& site, std::uint64_t covers, double reached) {
    constexpr double of_cell = 6.0;         // "-9999 "
    constexpr double more_of_number = 3.0;  // measured: 8.7 to 9.4 bytes in all
    const auto cells = static_cast<double>(site.map_frame.size());
    return static_cast<std::uint64_t>(
        static_cast<double>(rasters_of(scenario, covers)) *
        (of_cell * cells + more_of_number * reached / static_cast<double>(covers)));
}

/// Time on one thread to write results, measured on the same examples.
double write_seconds_of(const Site& site) {
    constexpr double of_page_s = 0.15;
    constexpr double of_cell_s = 12e-6;
    constexpr double of_rock_s = 20e-6;
    return of_page_s + of_cell_s * static_cast<double>(site.map_frame.size()) +
           of_rock_s * static_cast<double>(site.rocks());
}

/// Of a rock over one slope on one thread, with the flights, the ground and the entries in the maps. By a
/// pilot where the time depends on more than the path.
double seconds_of_rock(const Scenario& scenario, const Site& site, const Pilot& pilot) {
    constexpr double seconds_per_us = 1e-6;
    const double us_per_path_m = rockfall::description_of(scenario.rockfall.fall.motion.model).us_per_path_m;
    if (us_per_path_m > 0.0) {
        return mean_drop_m(site) / path_steepness * seconds_per_us * us_per_path_m;
    }
    return pilot(scenario, site).seconds_per_rock / covers_of(site);
}

/// A forest that lives through its years: trees as they are and as the year changes them.
std::uint64_t living_bytes(std::size_t patches) {
    return patches * trees_per_patch * 2 * sizeof(forest::Tree);
}

/// What a member keeps of its years; all members are in memory when the results are written.
std::uint64_t kept_bytes(const Scenario& scenario, const ForestSite& forest) {
    const ForestSettings& settings = scenario.forest;
    std::set<std::uint32_t> stands;
    for (const forest::Patch& patch : forest.grid.patches()) {
        stands.insert(patch.management_unit);
    }
    const std::size_t units = stands.size() > 1 ? stands.size() + 1 : 1;
    const std::size_t region = forest.parameters.regeneration.outside.species.size();
    const std::size_t species = region > 0 ? region : forest.species.table.size();
    const std::size_t lists = chosen_years(settings.tree_list_years, scenario.run.years).size();
    const std::size_t maps = chosen_years(settings.map_years, scenario.run.years).size();
    return (scenario.run.years + 1) *
               (sizeof(decades::YearRow) + units * (1 + species) * sizeof(decades::StandRow)) +
           lists * forest.grid.size() * trees_per_patch * sizeof(decades::TreeRow) +
           maps * forest.grid.size() * sizeof(decades::PatchRow);
}

}  // namespace

std::uint64_t resident_bytes() {
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    constexpr std::uint64_t bytes_per_kib = 1024;
    return static_cast<std::uint64_t>(use.ru_maxrss) * bytes_per_kib;
}

Estimate estimate_of(const Scenario& scenario, const Site& site, int threads, double read_seconds,
                     const Pilot& pilot) {
    Estimate estimate;
    estimate.rocks = site.rocks();
    estimate.covers = covers_of(site);
    const auto covers = static_cast<std::uint64_t>(estimate.covers);
    estimate.input_bytes = resident_bytes();  // before the pilot takes some
    estimate.result_bytes = result_bytes(site);
    const PilotFalls falls = pilot(scenario, site);
    // Memory that nobody writes to is none: only cells that rocks reach count.
    constexpr double cells_of_tile = rockfall::histogram_tile_side * rockfall::histogram_tile_side;
    const double reached =
        std::min(static_cast<double>(covers * site.map_frame.size()), falls.tiles * cells_of_tile);
    // Every worker has sums, and all of them are added up once more.
    const std::size_t cell_bytes = sizeof(rockfall::CellSums) +
                                   (scenario.output.spread_maps ? sizeof(rockfall::CellSpread) : 0) +
                                   (scenario.hazard.blocks.empty() ? 0 : sizeof(rockfall::CellReleases));
    estimate.map_bytes =
        static_cast<std::uint64_t>(reached * static_cast<double>(cell_bytes) * (threads + 1));
    if (scenario.output.percentiles) {
        const auto most =
            static_cast<double>(covers * rockfall::CellHistograms::largest_bytes(site.map_frame));
        constexpr double bytes_of_cell = rockfall::CellHistograms::bins_per_cell() * sizeof(std::uint32_t);
        estimate.percentile_bytes =
            static_cast<std::uint64_t>(std::min(most, falls.tiles * cells_of_tile * bytes_of_cell));
    }
    estimate.read_seconds = read_seconds;
    estimate.fall_seconds = falls.seconds_per_rock * static_cast<double>(estimate.rocks) / threads;
    estimate.write_seconds = write_seconds_of(site);
    estimate.raster_bytes = raster_bytes(scenario, site, covers, reached);
    if (scenario.nets.keep_paths) {
        estimate.fall_seconds *= 2.0;  // all rocks fall once more
        estimate.path_bytes = path_bytes(scenario, site, estimate.rocks * covers);
    }
    return estimate;
}

Estimate estimate_of_years(const Scenario& scenario, const Site& site, const StudySize& study, int threads,
                           const Pilot& pilot) {
    const ForestSettings& settings = scenario.forest;
    const std::size_t patches = site.forest->grid.size();
    // As the members are lived through: several at a time, or one with its rocks on all threads.
    const std::size_t at_once =
        std::min(static_cast<std::size_t>(threads), std::max<std::size_t>(1, study.missing));
    const std::size_t threads_each = at_once > 1 ? 1 : static_cast<std::size_t>(threads);
    const auto rounds = static_cast<double>((study.missing + at_once - 1) / at_once);

    Estimate estimate;
    estimate.covers = 2;
    estimate.rock_years = decades::rock_years_of(scenario).size();
    estimate.rocks = site.rocks();
    estimate.input_bytes = resident_bytes();
    estimate.forest_bytes =
        at_once * living_bytes(patches) + study.members * kept_bytes(scenario, *site.forest);
    if (has_rocks(scenario)) {
        const std::size_t of_worker = site.map_frame.size() * sizeof(rockfall::CellSums) * rockfall::covers;
        const std::size_t maps = chosen_years(settings.map_years, scenario.run.years).size();
        estimate.map_bytes = of_worker * (at_once * (threads_each + 1) + study.members * maps);
    }
    const double share_of_years = study.missing == 0
                                      ? 0.0
                                      : static_cast<double>(study.missing_years) /
                                            static_cast<double>(study.missing * scenario.run.years);
    // Over the bare slope once for each replicate, through the forest for each member.
    const double rocks_s = times_as_long_over_years * seconds_of_rock(scenario, site, pilot) *
                           static_cast<double>(estimate.rocks * estimate.rock_years);
    estimate.fall_seconds =
        share_of_years *
        (rounds * (static_cast<double>(scenario.run.years * patches) * seconds_per_patch_year +
                   rocks_s / static_cast<double>(threads_each)) +
         static_cast<double>(study.missing_replicates) * rocks_s / threads);
    return estimate;
}

}  // namespace coupling
