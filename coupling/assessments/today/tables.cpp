#include "coupling/assessments/today/tables.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "config/text/numbers.hpp"
#include "coupling/assessments/nets/figures/net_tables.hpp"
#include "coupling/assessments/today/arrival_breakdown.hpp"
#include "coupling/assessments/today/bound_falls.hpp"
#include "coupling/assessments/today/drawn_tables.hpp"
#include "coupling/assessments/today/figures/grounds.hpp"
#include "coupling/assessments/today/figures/path_series.hpp"
#include "coupling/assessments/today/figures/target_design.hpp"
#include "coupling/assessments/today/impact_table.hpp"
#include "coupling/assessments/today/observed_events.hpp"
#include "coupling/assessments/today/observed_stops.hpp"
#include "coupling/assessments/today/rows.hpp"
#include "coupling/assessments/works/work_tables.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling {
namespace {

struct TargetRow {
    const TargetFigures& target;
    Cover cover;
};

constexpr auto name_of_target = [](const auto& row) { return TargetName{row.target.id, row.target.name}; };
constexpr auto cover_of_row = [](const auto& row) { return name_of(row.cover); };

TableOf<TargetRow> target_table() {
    return {"targets.csv",
            "What arrives at each target: share of rocks, energy, speed and height with intervals.",
            "a target on one slope",
            {{target_columns(), name_of_target},
             {"kind", "line: a rock arrives when it crosses it; area: when it enters it",
              "input targets.file", [](const auto& row) { return row.target.is_area ? "area" : "line"; }},
             {cover_column(), cover_of_row},
             {arrival_columns(), [](const auto& row) { return &row.target.at(row.cover); }}}};
}

TableOf<TargetFigures> protection_table() {
    return {"protection.csv",
            "Protection effect of the forest at each target with its 95 % interval.",
            "a target",
            {{target_columns(),
              [](const auto& of) {
                  return TargetName{of.id, of.name};
              }},
             {protection_columns(),
              [](const auto& of) {
                  return ProtectionFigures{of.at(Cover::bare).share.whole, of.paired, of.protection,
                                           of.reduction};
              }},
             {"rocks_for_half_interval",
              "rocks that would halve the interval of the protection effect; empty where it is one-sided",
              "widths shrink with the square root of the number of rocks", [](const auto& of) {
                  return !of.protection || of.protection->one_sided
                             ? std::nullopt
                             : std::optional{rocks_for_half(of.at(Cover::bare).share.whole)};
              }}}};
}

/// A bin of a quantity at a target that is not empty.
struct BinRow {
    const std::string& target;
    Cover cover;
    const char* quantity;
    const char* of_unit;
    double low;
    double high;
    std::uint64_t rocks;
};

TableOf<BinRow> distribution_table() {
    return {
        "target_distributions.csv",
        "Energy, speed and height of the arrivals at each target in fine bins.",
        "a filled bin of a quantity at a target on one slope",
        {{target_id_column(), [](const auto& row) { return &row.target; }},
         {cover_column(), cover_of_row},
         {"quantity", "energy, speed or height at the first arrival", &BinRow::quantity},
         {"unit", "unit of the bin: kJ, m/s or m", "definition", &BinRow::of_unit},
         {"bin_low", "as the row says", 6, "lower end of the bin", "128 bins to a doubling", &BinRow::low},
         {"bin_high", "as the row says", 6, "upper end of the bin", "128 bins to a doubling", &BinRow::high},
         {"rocks", "rocks that arrived in this bin", from_counting, &BinRow::rocks}}};
}

void add_distributions(auto& rows, const RunResults& results) {
    for (std::size_t number = 0; number < results.tally.targets.size(); ++number) {
        for (const Cover cover : covers_of(results)) {
            const auto add = [&](const char* quantity, const char* unit, const rockfall::LogBins& bins,
                                 const auto& counts, double per_unit) {
                for (const auto& [bin, count] : counts.filled()) {
                    rows.add({results.site.targets[number].id, cover, quantity, unit,
                              bins.low_of(bin) / per_unit, bins.high_of(bin) / per_unit, count});
                }
            };
            const rockfall::ArrivalTally& tally = results.tally.targets[number].by_cover[index_of(cover)];
            add("energy", "kJ", rockfall::fine_energy_bins, tally.energy, 1000.0);
            add("speed", "m/s", rockfall::fine_speed_bins, tally.speed, 1.0);
            add("height", "m", rockfall::fine_height_bins, tally.height, 1.0);
        }
    }
}

struct SlopeOfRun : SlopeFigures {
    Cover cover;
};

TableOf<SlopeOfRun> run_table() {
    return {"runs.csv",
            "All rocks on each slope: where they stopped, run-out, speeds, energies, heights, tree hits.",
            "a slope",
            {{cover_column(), cover_of_row}, slope_columns()}};
}

/// A bin of run-out.
struct RunOutRow {
    Cover cover;
    double low_m;
    std::optional<double> high_m;
    std::uint64_t rocks;
    std::uint64_t not_stopped;
};

TableOf<RunOutRow> run_out_table() {
    return {"run_out.csv",
            "Rocks by run-out (plan distance from release to end) in bins of 10 m; rocks that left apart.",
            "a bin of run-out on one slope",
            {{cover_column(), cover_of_row},
             {"run_out_low_m", 0, "lower end of the bin of the plan distance from release to end",
              "bins of 10 m", &RunOutRow::low_m},
             {"run_out_high_m", 0, "upper end of the bin; empty: everything further", "bins of 10 m",
              &RunOutRow::high_m},
             {"rocks", "rocks that stopped on the terrain in this bin", from_counting, &RunOutRow::rocks},
             {"not_stopped",
              "rocks that left the terrain or were given up in this bin: their run-out is at least so long",
              from_counting, &RunOutRow::not_stopped}}};
}

void add_run_outs(auto& rows, const RunResults& results) {
    for (const Cover cover : covers_of(results)) {
        const rockfall::RunTally& tally = results.tally.runs[index_of(cover)];
        const auto filled = [](const auto& counts) {
            const auto last =
                std::find_if(counts.rbegin(), counts.rend(), [](std::uint64_t count) { return count > 0; });
            return static_cast<std::size_t>(counts.rend() - last);
        };
        const std::size_t bins = std::max(filled(tally.run_out), filled(tally.open_run_out));
        for (std::size_t bin = 0; bin < bins; ++bin) {
            const double low_m = static_cast<double>(bin) * tally.run_out_bin_m;
            const bool open = bin + 1 == tally.run_out_bins;
            rows.add({cover, low_m, open ? std::nullopt : std::optional{low_m + tally.run_out_bin_m},
                      tally.run_out[bin], tally.open_run_out[bin]});
        }
    }
}

struct HitCount {
    std::size_t hits;
    bool or_more;
    std::uint64_t rocks;
};

TableOf<HitCount> hit_count_table() {
    return {
        "tree_hits_per_rock.csv",
        "Rocks by the number of trees they hit.",
        "a number of tree hits",
        {{"tree_hits", "trees hit by one rock", &HitCount::hits},
         {"or_more", "yes: the row takes all higher numbers too", "definition", &HitCount::or_more},
         {"rocks", "rocks with so many hits, on the slope with forest", from_counting, &HitCount::rocks}}};
}

struct StemRow : rockfall::Stem, rockfall::StemTally {
    const TreeRecord& tree;
};

constexpr auto kj_taken = [](const auto& row) { return static_cast<double>(row.energy_j) / 1000.0; };

TableOf<StemRow> stem_table() {
    constexpr const char* from_list = "input trees.file, or drawn from stands.records";
    return {"stems.csv",
            "Every tree with the hits it took and the energy it absorbed: which trees protect.",
            "a tree",
            {{"tree_id", "name of the tree", from_list, [](const auto& row) { return row.tree.id; }},
             {"x_m", 2, "easting of the stem", from_list, &StemRow::x_m},
             {"y_m", 2, "northing of the stem", from_list, &StemRow::y_m},
             {"species", "species as the list of trees names it", from_list,
              [](const auto& row) { return row.tree.species; }},
             {"dbh_cm", 1, "diameter at breast height", from_list, &StemRow::dbh_cm},
             {"height_m", 1, "height of the tree",
              "input trees.file or stands.records, or estimated where they have none", &StemRow::height_m},
             {"hits", "hits by rocks", from_counting, &StemRow::hits},
             {"broken", "hits with more energy than the tree can take", from_counting, &StemRow::broken},
             {"energy_kj", 3, "energy it took from all rocks", kj_taken}}};
}

struct LogRow : rockfall::Log, rockfall::LogTally {
    const LogRecord& record;
};

TableOf<LogRow> log_table() {
    constexpr const char* from_list = "input trees.logs";
    return {"logs.csv",
            "Every lying log with the hits it took, the rocks that rest at it and the energy it absorbed.",
            "a lying log",
            {{"log_id", "name of the log", from_list, [](const auto& row) { return row.record.id; }},
             {"x1_m", 2, "easting of the first end", from_list, &LogRow::x1_m},
             {"y1_m", 2, "northing of the first end", from_list, &LogRow::y1_m},
             {"x2_m", 2, "easting of the second end", from_list, &LogRow::x2_m},
             {"y2_m", 2, "northing of the second end", from_list, &LogRow::y2_m},
             {"species", "species as the list of logs names it", from_list,
              [](const auto& row) { return row.record.species; }},
             {"diameter1_cm", 1, "diameter at the first end", from_list, &LogRow::diameter1_cm},
             {"diameter2_cm", 1, "diameter at the second end", from_list, &LogRow::diameter2_cm},
             {"clearance_m", 2, "from the ground to the underside, normal to the ground", from_list,
              &LogRow::clearance_m},
             {"strength", 3, "share of the strength of fresh wood, falls with decay, 0 to 1", from_list,
              &LogRow::strength},
             {"hits", "hits by rocks", from_counting, &LogRow::hits},
             {"broken", "hits that break it", from_counting, &LogRow::broken},
             {"resting", "rocks that rest upslope of it", from_counting, &LogRow::resting},
             {"energy_kj", 3, "energy it took from all rocks", kj_taken}}};
}

std::string wkt_of(const LeftOutFace& face) {
    const auto& [a, b, c] = face.corners_m;
    std::string wkt = "POLYGON Z ((";
    for (const Eigen::Vector3d& corner : {a, b, c, a}) {
        wkt += (wkt.ends_with('(') ? "" : ",") + config::to_text(corner.x()) + " " +
               config::to_text(corner.y()) + " " + config::to_text(corner.z());
    }
    return wkt + "))";
}

TableOf<LeftOutFace> left_out_table() {
    constexpr const char* from_mesh = "input terrain.mesh";
    return {"mesh_left_out.csv",
            "Faces of the mesh that lay below others and are no part of the terrain.",
            "a face of the mesh that lay below another one",
            {{"mesh", "file of the face", from_mesh, &LeftOutFace::file},
             {"face", "number of the face in the file, from 1", from_mesh, &LeftOutFace::number},
             {place_columns("", "the middle of the face"),
              [](const auto& face) -> Eigen::Vector3d {
                  const auto& [a, b, c] = face.corners_m;
                  return (a + b + c) / 3.0;
              }},
             {"area_m2", 3, "area of the face in space", from_mesh,
              [](const auto& face) {
                  const auto& [a, b, c] = face.corners_m;
                  return 0.5 * (b - a).cross(c - a).norm();
              }},
             {"wkt", "the face as POLYGON Z in metres", from_mesh, wkt_of}}};
}

std::vector<WrittenFile> write_paths(const RunResults& results, const std::filesystem::path& folder) {
    const Eigen::Vector2d origin_m = results.site.origin_m();
    return {path_table().write(folder,
                               [&](auto& rows) {
                                   for (const rockfall::PathRecord& path : results.paths) {
                                       for (std::size_t i = 0; i < path.points.size(); ++i) {
                                           rows.add({path.rock, path.cover, i, origin_m, path.points[i]});
                                       }
                                   }
                               }),
            wkt_table().write(folder, [&](auto& rows) {
                for (const rockfall::PathRecord& path : results.paths) {
                    if (const auto whole = whole_path(path.rock, path.cover, origin_m, path.points)) {
                        rows.add(*whole);
                    }
                }
            })};
}

/// What trees and logs took.
void write_obstacles(const RunResults& results, const std::filesystem::path& folder,
                     std::vector<WrittenFile>& written) {
    if (results.with_forest && !results.site.logs.empty()) {
        written.push_back(log_table().write(folder, [&](auto& rows) {
            for (std::size_t i = 0; i < results.site.logs.size(); ++i) {
                rows.add({results.site.logs[i].log, results.tally.logs[i], results.site.logs[i]});
            }
        }));
    }
    if (results.with_forest && !results.site.trees.empty()) {
        written.push_back(hit_count_table().write(folder, [&](auto& rows) {
            const auto& counts = results.tally.runs[index_of(Cover::forest)].tree_hits;
            for (std::size_t hits = 0; hits < counts.size(); ++hits) {
                rows.add({hits, hits + 1 == counts.size(), counts[hits]});
            }
        }));
        written.push_back(stem_table().write(folder, [&](auto& rows) {
            for (std::size_t i = 0; i < results.site.trees.size(); ++i) {
                rows.add({results.site.trees[i].stem, results.tally.stems[i], results.site.trees[i]});
            }
        }));
    }
}

/// What arrives at the targets.
void write_arrivals(const RunResults& results, const Figures& figures, const std::filesystem::path& folder,
                    std::vector<WrittenFile>& written) {
    const std::vector<Cover> covers = covers_of(results);
    if (!figures.targets.empty()) {
        written.push_back(target_table().write(folder, [&](auto& rows) {
            for (const TargetFigures& target : figures.targets) {
                for (const Cover cover : covers) {
                    rows.add({target, cover});
                }
            }
        }));
        written.push_back(
            distribution_table().write(folder, [&](auto& rows) { add_distributions(rows, results); }));
    }
    write_breakdown(results, folder, written);
    write_target_designs(results, folder, written);
    if (!figures.targets.empty() && results.with_forest) {
        written.push_back(
            protection_table().write(folder, [&](auto& rows) { rows.add_all(figures.targets); }));
    }
}

}  // namespace

const std::vector<TableLayout>& static_layouts() {
    static const std::vector<TableLayout> layouts =
        together(std::vector<TableLayout>{target_table(), protection_table(), distribution_table(),
                                          run_table(), run_out_table(), hit_count_table(), ground_layout(),
                                          stem_table(), log_table()},
                 row_layouts(), std::vector<TableLayout>{observed_stops_layout(), impact_layout()},
                 breakdown_layouts(),
                 std::vector<TableLayout>{target_design_layout(), left_out_table(), observed_events_layout()},
                 path_series_layouts(), drawn_layouts(), std::vector<TableLayout>{bounds_layout()},
                 net_layouts(), work_layouts());
    return layouts;
}

std::vector<WrittenFile> write_tables(const RunResults& results, const Figures& figures,
                                      const std::filesystem::path& folder) {
    std::vector<WrittenFile> written;
    write_arrivals(results, figures, folder, written);
    written.push_back(run_table().write(folder, [&](auto& rows) {
        for (const Cover cover : covers_of(results)) {
            rows.add({figures.at(cover), cover});
        }
    }));
    written.push_back(run_out_table().write(folder, [&](auto& rows) { add_run_outs(rows, results); }));
    const std::vector<WrittenFile> of_draws = write_drawn(results, figures, folder);
    written.insert(written.end(), of_draws.begin(), of_draws.end());
    const std::vector<WrittenFile> of_bounds = write_bounds(results, folder);
    written.insert(written.end(), of_bounds.begin(), of_bounds.end());
    if (!results.observed_stops.empty()) {
        written.push_back(write_observed_stops(folder, results.observed_stops));
    }
    if (!results.observed_events.empty()) {
        written.push_back(write_observed_events(folder, results.observed_events));
    }
    if (!results.site.left_out_faces.empty()) {
        written.push_back(
            left_out_table().write(folder, [&](auto& rows) { rows.add_all(results.site.left_out_faces); }));
    }
    written.push_back(write_grounds(folder, results));
    write_obstacles(results, folder, written);
    if (results.scenario.output.impact_table) {
        written.push_back(write_impacts(folder, results.impacts, results.site.origin_m()));
    }
    if (!results.paths.empty()) {
        const std::vector<WrittenFile> paths = write_paths(results, folder);
        written.insert(written.end(), paths.begin(), paths.end());
        write_path_series(results, folder, written);
    }
    return written;
}

}  // namespace coupling
