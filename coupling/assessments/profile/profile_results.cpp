#include "coupling/assessments/profile/profile_results.hpp"

#include <cmath>

#include "config/text/language.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/profile/profile_layouts.hpp"
#include "coupling/assessments/profile/report/profile_page.hpp"
#include "coupling/inputs/tables/csv_row.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/figures/indicators.hpp"
#include "coupling/results/finish.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling::profile {
namespace {

using config::j_per_kj;
using config::percent;

void add_share(CsvRow& row, const Share& share) {
    row.number<4>(percent * share.value);
    row.number<4>(percent * share.interval.low).number<4>(percent * share.interval.high);
}

/// Lower and upper end of a stretch, the last one cut off at the end of the profile.
double end_of_stretch_m(const ProfileResults& results, std::size_t stretches_passed) {
    const double end_m =
        results.site.first_m() + static_cast<double>(stretches_passed) * results.tally.stretch_m;
    return std::min(end_m, results.site.last_m());
}

}  // namespace

void write_rock_header(std::ostream& out) {
    write_header(out, layout_of(profile_layouts(), "rocks.csv"));
}

void write_rock(std::ostream& out, const rockfall::RockRecord& record) {
    static const std::size_t columns = layout_of(profile_layouts(), "rocks.csv").columns.size();
    CsvRow row{out, columns};
    row.whole(record.rock).number<3>(static_cast<double>(record.diameter_m)).text(name_of(record.reason));
    row.number<2>(record.start_m.x()).number<2>(record.start_m.z());
    row.number<2>(record.end_m.x()).number<2>(record.end_m.z());
    row.number<2>(record.run_out_m()).number<2>(record.path_m).number<2>(record.time_s);
    row.number<3>(record.max_speed_mps).number<3>(record.mean_speed_mps()).number<3>(record.min_speed_mps);
    row.number<3>(record.max_energy_j / j_per_kj);
    row.number<3>(record.max_height_m).number<3>(record.mean_jump_height_m());
    row.whole(record.jumps).number<3>(record.min_jump_length_m).number<3>(record.mean_jump_length_m());
    row.number<3>(record.max_jump_length_m).whole(record.ground_impacts);
    row.end();
}

void write_jumps_by_segment(std::ostream& out, const ProfileResults& results) {
    TableRows row{out, profile_layouts(), "jumps_by_segment.csv"};
    const double whole_m = results.site.slope_length_m(results.site.last_m());
    for (std::size_t i = 0; i < results.tally.segments.size(); ++i) {
        const SegmentTally& segment = results.tally.segments[i];
        const double from_m = static_cast<double>(i) * results.tally.segment_m;
        const double to_m = std::min(whole_m, from_m + results.tally.segment_m);
        row.number<2>(from_m).number<2>(to_m);
        row.number<2>(results.site.distance_at_m(from_m)).number<2>(results.site.distance_at_m(to_m));
        row.whole(segment.length_m.count());
        row.number<3>(segment.length_m.least()).number<3>(segment.length_m.mean());
        row.number<3>(segment.length_m.most()).number<3>(segment.impact_mps.mean());
        row.number<3>(segment.length_m.deviation()).number<3>(segment.height_m.mean());
        row.number<3>(segment.height_m.most());
        row.end();
    }
}

void write_run_out(std::ostream& out, const ProfileResults& results) {
    TableRows row{out, profile_layouts(), "run_out.csv"};
    for (std::size_t i = 0; i < results.tally.ends.size(); ++i) {
        const std::uint64_t beyond = results.tally.ended_beyond(i);
        row.number<2>(end_of_stretch_m(results, i)).whole(beyond);
        add_share(row, share_of(beyond, results.tally.rocks));
        row.end();
    }
}

void write_stations(std::ostream& out, const ProfileResults& results) {
    using namespace rockfall;
    TableRows row{out, profile_layouts(), "stations.csv"};
    for (std::size_t i = 0; i < results.site.stations.size(); ++i) {
        const StationTally& tally = results.tally.stations[i];
        const Spread& energy = tally.energy_j;
        row.text(results.site.stations[i].name).number<2>(results.site.stations[i].distance_m);
        row.whole(energy.moments.count());
        add_share(row, share_of(energy.moments.count(), results.tally.rocks));
        row.number<3>(energy.moments.mean() / j_per_kj).number<3>(energy.moments.deviation() / j_per_kj);
        for (const double share : {0.50, 0.90, 0.95, 0.99}) {
            row.number<3>(energy.quantile(fine_energy_bins, share) / j_per_kj);
        }
        row.number<3>(energy.moments.most() / j_per_kj);
        add_energy_rates(row, rates_of(tally, results.tally.rocks));
        row.number<3>(tally.translational_j.mean() / j_per_kj);
        row.number<3>(tally.speed_mps.moments.mean())
            .number<3>(tally.speed_mps.quantile(fine_speed_bins, 0.95));
        row.number<3>(tally.speed_mps.moments.most());
        row.number<3>(tally.height_m.moments.mean())
            .number<3>(tally.height_m.quantile(fine_height_bins, 0.95));
        row.number<3>(tally.height_m.moments.most());
        row.end();
    }
}

void write_envelope(std::ostream& out, const ProfileResults& results) {
    using namespace rockfall;
    TableRows row{out, profile_layouts(), "envelope.csv"};
    for (std::size_t i = 0; i < results.tally.stretches.size(); ++i) {
        const StretchTally& stretch = results.tally.stretches[i];
        row.number<2>(end_of_stretch_m(results, i)).number<2>(end_of_stretch_m(results, i + 1));
        row.whole(stretch.energy_j.moments.count());
        row.number<3>(stretch.energy_j.moments.mean() / j_per_kj);
        row.number<3>(stretch.energy_j.quantile(energy_bins, 0.95) / j_per_kj);
        row.number<3>(stretch.energy_j.moments.most() / j_per_kj);
        row.number<3>(stretch.height_m.moments.mean());
        row.number<3>(stretch.height_m.quantile(height_bins, 0.95));
        row.number<3>(stretch.height_m.moments.most());
        row.number<3>(stretch.speed_mps.moments.mean());
        row.number<3>(stretch.speed_mps.quantile(fine_speed_bins, 0.95));
        row.number<3>(stretch.speed_mps.moments.most());
        row.end();
    }
}

void write_paths(std::ostream& out, const ProfileResults& results) {
    TableRows row{out, profile_layouts(), "paths.csv"};
    for (const SampledPath& path : results.tally.paths) {
        for (std::size_t i = 0; i < path.points.size(); ++i) {
            const rockfall::PathPoint& point = path.points[i];
            row.whole(path.rock).whole(i).number<2>(point.position_m.x()).number<2>(point.position_m.z());
            row.number<3>(static_cast<double>(point.energy_j) / j_per_kj);
            row.number<2>(static_cast<double>(point.height_m));
            row.end();
        }
    }
}

std::vector<WrittenFile> write_results(const ProfileResults& results, const std::filesystem::path& folder,
                                       const std::vector<WrittenFile>& streamed, const WriteWatch& watch) {
    std::vector<WrittenFile> files{
        {"report.html", "The results as a page: profile, run-out, jumps, energies, settings. Opens offline."},
        {"summary.json", "All figures, settings, input hashes and warnings for scripts."}};
    files.insert(files.end(), streamed.begin(), streamed.end());
    const auto table = [&](const std::string& name, const std::string& sentence, auto write) {
        OutFile file{folder / "tables" / name};
        write(file.stream(), results);
        file.close();
        files.push_back({"tables/" + name, sentence});
    };
    table("jumps_by_segment.csv", "Lengths of the jumps that end in each segment of the slope.",
          write_jumps_by_segment);
    table("run_out.csv", "Share of rocks whose fall ends beyond each distance, with interval.",
          write_run_out);
    table("stations.csv", "Who passes each station: share, energy, speed, height.", write_stations);
    table("envelope.csv", "Energy, height and speed along the profile: mean, 95 %, largest.", write_envelope);
    table("paths.csv", "Sampled paths, corner by corner.", write_paths);

    finish_results(
        folder,
        {.scenario = results.scenario,
         .dictionary = {profile_layouts(), {}},
         .summary = [&](std::ostream& out, const auto& written) { write_summary(out, results, written); },
         .page = [&](std::ostream& out, const auto& written) { write_page(out, results, written); }},
        files, watch);
    return files;
}

}  // namespace coupling::profile
