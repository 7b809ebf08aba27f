#include "coupling/assessments/today/tables.hpp"

#include <algorithm>
#include <functional>
#include <span>
#include <string>

#include "config/text/numbers.hpp"
#include "coupling/assessments/today/arrival_breakdown.hpp"
#include "coupling/assessments/today/figures/grounds.hpp"
#include "coupling/assessments/today/figures/static_layouts.hpp"
#include "coupling/assessments/today/impact_table.hpp"
#include "coupling/assessments/today/observed_events.hpp"
#include "coupling/assessments/today/observed_stops.hpp"
#include "coupling/assessments/today/rows.hpp"
#include "coupling/inputs/tables/csv_row.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling {
namespace {

/// The rows of one quantity at one target: bins that are not empty.
void add_bins(CsvRow& row, const std::string& target, Cover cover, const char* quantity, const char* unit,
              const rockfall::LogBins& bins, const std::vector<rockfall::BinCounts::Filled>& counts,
              double per_unit) {
    for (const auto& [bin, count] : counts) {
        row.text(target).text(name_of(cover)).text(quantity).text(unit);
        row.number<6>(bins.low_of(bin) / per_unit).number<6>(bins.high_of(bin) / per_unit).whole(count);
        row.end();
    }
}

void write_all_paths(OutFile& points, OutFile& lines, const RunResults& results) {
    write_path_header(points.stream());
    write_path_wkt_header(lines.stream());
    const Eigen::Vector2d origin_m = results.site.origin_m();
    for (const rockfall::PathRecord& path : results.paths) {
        write_path(points.stream(), path.rock, path.cover, origin_m, path.points);
        write_path_wkt(lines.stream(), path.rock, path.cover, origin_m, path.points);
    }
}

void write_left_out_faces(std::ostream& out, const std::vector<LeftOutFace>& faces) {
    TableRows row{out, static_layouts(), "mesh_left_out.csv"};
    for (const LeftOutFace& face : faces) {
        const auto& [a, b, c] = face.corners_m;
        const Eigen::Vector3d middle_m = (a + b + c) / 3.0;
        row.text(face.file).whole(face.number);
        row.number<2>(middle_m.x()).number<2>(middle_m.y()).number<2>(middle_m.z());
        row.number<3>(0.5 * (b - a).cross(c - a).norm());
        std::string wkt = "POLYGON Z ((";
        for (const Eigen::Vector3d& corner : {a, b, c, a}) {
            wkt += (wkt.ends_with('(') ? "" : ",") + config::to_text(corner.x()) + " " +
                   config::to_text(corner.y()) + " " + config::to_text(corner.z());
        }
        row.text(wkt + "))");
        row.end();
    }
}

}  // namespace

void write_targets(std::ostream& out, const Figures& figures, const std::vector<Cover>& covers) {
    TableRows row{out, static_layouts(), "targets.csv"};
    for (const TargetFigures& target : figures.targets) {
        for (const Cover cover : covers) {
            row.text(target.id).text(target.name).text(target.is_area ? "area" : "line").text(name_of(cover));
            add_arrivals(row, target.at(cover));
            row.end();
        }
    }
}

void write_protection(std::ostream& out, const Figures& figures) {
    TableRows row{out, static_layouts(), "protection.csv"};
    for (const TargetFigures& target : figures.targets) {
        const std::uint64_t rocks = target.at(Cover::bare).share.whole;
        row.text(target.id).text(target.name);
        add_protection(row, rocks, target.paired, target.protection, target.reduction);
        !target.protection || target.protection->one_sided ? row.empty() : row.whole(rocks_for_half(rocks));
        row.end();
    }
}

void write_target_distributions(std::ostream& out, const RunResults& results) {
    TableRows row{out, static_layouts(), "target_distributions.csv"};
    for (std::size_t number = 0; number < results.tally.targets.size(); ++number) {
        const std::string& id = results.site.targets[number].id;
        for (const Cover cover : covers_of(results)) {
            const rockfall::ArrivalTally& tally = results.tally.targets[number].by_cover[index_of(cover)];
            add_bins(row, id, cover, "energy", "kJ", rockfall::fine_energy_bins, tally.energy.filled(),
                     1000.0);
            add_bins(row, id, cover, "speed", "m/s", rockfall::fine_speed_bins, tally.speed.filled(), 1.0);
            add_bins(row, id, cover, "height", "m", rockfall::fine_height_bins, tally.height.filled(), 1.0);
        }
    }
}

void write_runs(std::ostream& out, const Figures& figures, const std::vector<Cover>& covers) {
    TableRows row{out, static_layouts(), "runs.csv"};
    for (const Cover cover : covers) {
        row.text(name_of(cover));
        add_slope(row, figures.at(cover));
        row.end();
    }
}

void write_run_out(std::ostream& out, const RunResults& results) {
    TableRows row{out, static_layouts(), "run_out.csv"};
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
            row.text(name_of(cover)).number<0>(low_m);
            bin + 1 == tally.run_out_bins ? row.empty() : row.number<0>(low_m + tally.run_out_bin_m);
            row.whole(tally.run_out[bin]).whole(tally.open_run_out[bin]);
            row.end();
        }
    }
}

void write_tree_hits_per_rock(std::ostream& out, const RunResults& results) {
    TableRows row{out, static_layouts(), "tree_hits_per_rock.csv"};
    const auto& counts = results.tally.runs[index_of(Cover::forest)].tree_hits;
    for (std::size_t hits = 0; hits < counts.size(); ++hits) {
        row.whole(hits).text(hits + 1 == counts.size() ? "yes" : "no").whole(counts[hits]);
        row.end();
    }
}

void write_stems(std::ostream& out, const RunResults& results) {
    TableRows row{out, static_layouts(), "stems.csv"};
    for (std::size_t number = 0; number < results.site.trees.size(); ++number) {
        const TreeRecord& tree = results.site.trees[number];
        const rockfall::StemTally& tally = results.tally.stems[number];
        row.text(tree.id).number<2>(tree.stem.x_m).number<2>(tree.stem.y_m).text(tree.species);
        row.number<1>(tree.stem.dbh_cm).number<1>(tree.stem.height_m).whole(tally.hits).whole(tally.broken);
        row.number<3>(static_cast<double>(tally.energy_j) / 1000.0);
        row.end();
    }
}

void write_logs(std::ostream& out, const RunResults& results) {
    TableRows row{out, static_layouts(), "logs.csv"};
    for (std::size_t number = 0; number < results.site.logs.size(); ++number) {
        const LogRecord& record = results.site.logs[number];
        const rockfall::Log& log = record.log;
        const rockfall::LogTally& tally = results.tally.logs[number];
        row.text(record.id).number<2>(log.x1_m).number<2>(log.y1_m).number<2>(log.x2_m).number<2>(log.y2_m);
        row.text(record.species).number<1>(log.diameter1_cm).number<1>(log.diameter2_cm);
        row.number<2>(log.clearance_m).number<3>(log.strength);
        row.whole(tally.hits).whole(tally.broken).whole(tally.resting);
        row.number<3>(static_cast<double>(tally.energy_j) / 1000.0);
        row.end();
    }
}

std::vector<WrittenFile> write_tables(const RunResults& results, const Figures& figures,
                                      const std::filesystem::path& folder) {
    make_folder(folder / "tables");
    std::vector<WrittenFile> written;
    const auto write = [&](const std::string& name, const std::string& sentence,
                           const std::function<void(std::ostream&)>& fill) {
        written.push_back(write_table(folder, name, sentence, fill));
    };
    const std::vector<Cover> covers = covers_of(results);
    if (!figures.targets.empty()) {
        write("targets.csv",
              "What arrives at each target: share of rocks, energy, speed and height with intervals.",
              [&](std::ostream& out) { write_targets(out, figures, covers); });
        write("target_distributions.csv",
              "Energy, speed and height of the arrivals at each target in fine bins.",
              [&](std::ostream& out) { write_target_distributions(out, results); });
    }
    if (std::any_of(results.breakdown.lines.begin(), results.breakdown.lines.end(),
                    [](const AlongLine& line) { return !line.stretches.empty(); })) {
        write("along_lines.csv",
              "What arrives on each stretch of 10 m of a line: share of rocks, energy, speed and height.",
              [&](std::ostream& out) { write_along_lines(out, results); });
    }
    if (!results.breakdown.zones.empty()) {
        write("by_zone.csv", "What arrives at each target from each release zone.",
              [&](std::ostream& out) { write_by_zone(out, results); });
    }
    if (!results.breakdown.sizes.empty()) {
        write("by_size.csv", "What arrives at each target by block size.",
              [&](std::ostream& out) { write_by_size(out, results); });
    }
    if (!figures.targets.empty() && results.with_forest) {
        write("protection.csv", "Protection effect of the forest at each target with its 95 % interval.",
              [&](std::ostream& out) { write_protection(out, figures); });
    }
    write("runs.csv",
          "All rocks on each slope: where they stopped, run-out, speeds, energies, heights, tree hits.",
          [&](std::ostream& out) { write_runs(out, figures, covers); });
    write("run_out.csv",
          "Rocks by run-out (plan distance from release to end) in bins of 10 m; rocks that left apart.",
          [&](std::ostream& out) { write_run_out(out, results); });
    if (!results.observed_stops.empty()) {
        write("observed_stops.csv", "Where rocks were seen to stop beside where the simulated ones do.",
              [&](std::ostream& out) { write_observed_stops(out, results.observed_stops); });
    }
    if (!results.observed_events.empty()) {
        write("observed_events.csv",
              "Rocks that were seen at targets and single impacts, beside the simulated ones.",
              [&](std::ostream& out) { write_observed_events(out, results.observed_events); });
    }
    if (!results.site.left_out_faces.empty()) {
        write("mesh_left_out.csv", "Faces of the mesh that lay below others and are no part of the terrain.",
              [&](std::ostream& out) { write_left_out_faces(out, results.site.left_out_faces); });
    }
    write("grounds.csv", "The ground types that occur, with the parameters that the motion model uses.",
          [&](std::ostream& out) { write_grounds(out, results); });
    if (results.with_forest && !results.site.logs.empty()) {
        write("logs.csv",
              "Every lying log with the hits it took, the rocks that rest at it and the energy it absorbed.",
              [&](std::ostream& out) { write_logs(out, results); });
    }
    if (results.with_forest && !results.site.trees.empty()) {
        write("tree_hits_per_rock.csv", "Rocks by the number of trees they hit.",
              [&](std::ostream& out) { write_tree_hits_per_rock(out, results); });
        write("stems.csv",
              "Every tree with the hits it took and the energy it absorbed: which trees protect.",
              [&](std::ostream& out) { write_stems(out, results); });
    }
    if (results.scenario.impact_table) {
        write("impacts.csv",
              "Each ground impact of the rocks whose paths are kept: place, speeds and angles, the jump "
              "before.",
              [&](std::ostream& out) { write_impacts(out, results.impacts, results.site.origin_m()); });
    }
    if (!results.paths.empty()) {
        OutFile points{folder / "tables/trajectories.csv"};
        OutFile lines{folder / "tables/trajectories_wkt.csv"};
        write_all_paths(points, lines, results);
        points.close();
        lines.close();
        written.push_back(
            {"tables/trajectories.csv", "Sampled paths point by point with energy and height."});
        written.push_back({"tables/trajectories_wkt.csv", "Sampled paths as lines (WKT) for QGIS."});
    }
    return written;
}

}  // namespace coupling
