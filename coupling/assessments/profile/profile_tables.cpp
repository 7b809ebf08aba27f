#include <algorithm>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/profile/profile_results.hpp"
#include "coupling/results/tables/drawn_rows.hpp"
#include "coupling/results/tables/figure_columns.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::profile {
namespace {

using config::j_per_kj;
using config::joined;

constexpr const char* from_fine_bins = "simulated; fine bins, at most 0.4 % from the value";
constexpr const char* from_wide_bins = "simulated; bins, at most 3.2 % from the value";
constexpr const char* from_profile = "input terrain.profile";

Column rock_number_column() {
    return {"rock", "-", "number of the rock", from_simulation};
}

/// Lower and upper end of a stretch, the last one cut off at the end of the profile.
double end_of_stretch_m(const ProfileResults& results, std::size_t stretches_passed) {
    const double end_m =
        results.site.first_m() + static_cast<double>(stretches_passed) * results.tally.stretch_m;
    return std::min(end_m, results.site.last_m());
}

struct SegmentRow : SegmentTally {
    const ProfileSite& site;
    double from_m;  ///< along the slope
    double to_m;
};

TableOf<SegmentRow> segment_table() {
    return {
        "jumps_by_segment.csv",
        "Lengths of the jumps that end in each segment of the slope.",
        "a segment of the slope",
        {{"from_m", 2, "slope length from the upper end of the profile to the begin of the segment",
          "profile.segment_m", [](const auto& row) { return row.from_m; }},
         {"to_m", 2, "slope length to its end", "profile.segment_m",
          [](const auto& row) { return row.to_m; }},
         {"from_distance_m", 2, "plan distance of its begin", from_profile,
          [](const auto& row) { return row.site.distance_at_m(row.from_m); }},
         {"to_distance_m", 2, "plan distance of its end", from_profile,
          [](const auto& row) { return row.site.distance_at_m(row.to_m); }},

         {"jumps", "jumps that end in it", from_counting, [](const auto& s) { return s.length_m.count(); }},
         {"min_length_m", 3, "shortest jump, straight from impact to impact",
          [](const auto& s) { return s.length_m.least(); }},
         {"mean_length_m", 3, "mean length of the jumps", [](const auto& s) { return s.length_m.mean(); }},
         {"max_length_m", 3, "longest jump", [](const auto& s) { return s.length_m.most(); }},
         {"mean_impact_speed_mps", 3, "mean speed before the impact that ends a jump",
          [](const auto& s) { return s.impact_mps.mean(); }},
         {"sd_length_m", 3, "standard deviation of the lengths",
          [](const auto& s) { return s.length_m.deviation(); }},
         {"mean_height_m", 3, "mean of the jumps' largest heights above the ground, vertical",
          [](const auto& s) { return s.height_m.mean(); }},
         {"max_height_m", 3, "largest of these heights", [](const auto& s) { return s.height_m.most(); }}}};
}

struct DistanceRow {
    double distance_m;
    Share beyond;
};

TableOf<DistanceRow> run_out_table() {
    return {"run_out.csv",
            "Share of rocks whose fall ends beyond each distance, with interval.",
            "a distance along the profile",
            {{"distance_m", 2, "plan distance along the profile", from_profile, &DistanceRow::distance_m},
             {ColumnsOf<Share>{
                  {"rocks_beyond",
                   "rocks whose fall ended beyond it; those that left over the lower end are beyond all",
                   from_counting, &Share::part},
                  share_columns("beyond", "their share of all rocks")},
              &DistanceRow::beyond}}};
}

struct StationRow : Station, StationTally {
    std::uint64_t rocks;  ///< that fell
};

/// How rocks pass a station, the energies first.
ColumnsOf<StationTally> station_energy_columns() {
    const auto quantile = [](double share) {
        return [share](const StationTally& tally) {
            return tally.energy_j.quantile(rockfall::fine_energy_bins, share) / j_per_kj;
        };
    };
    return {{"energy_mean_kj", 3,
             joined("mean kinetic energy (", rockfall::what_energies_count(), ") at the first passage"),
             [](const auto& tally) { return tally.energy_j.moments.mean() / j_per_kj; }},
            {"energy_sd_kj", 3, "its standard deviation",
             [](const auto& tally) { return tally.energy_j.moments.deviation() / j_per_kj; }},
            {"energy_50_kj", 3, "its median", from_fine_bins, quantile(0.50)},
            {"energy_90_kj", 3, "its 90th percentile (empty: fewer than 10 rocks)", from_fine_bins,
             quantile(0.90)},
            {"energy_95_kj", 3, "its 95th percentile (empty: fewer than 20 rocks)", from_fine_bins,
             quantile(0.95)},
            {"energy_99_kj", 3, "its 99th percentile (empty: fewer than 100 rocks)", from_fine_bins,
             quantile(0.99)},
            {"energy_max_kj", 3, "its largest value",
             [](const auto& tally) { return tally.energy_j.moments.most() / j_per_kj; }}};
}

/// Mean, 95th percentile and largest value of a quantity: speed_mean_mps, ...
ColumnsOf<Spread> spread_columns(const std::string& name, const std::string& ending, const char* mean,
                                 const rockfall::LogBins& bins, const char* from_bins, double per_unit) {
    return {{joined(name, "_mean_", ending), 3, mean,
             [per_unit](const Spread& spread) { return spread.moments.mean() / per_unit; }},
            {joined(name, "_95_", ending), 3, "its 95th percentile (empty: fewer than 20 rocks)", from_bins,
             [&bins, per_unit](const Spread& spread) { return spread.quantile(bins, 0.95) / per_unit; }},
            {joined(name, "_max_", ending), 3, "its largest value",
             [per_unit](const Spread& spread) { return spread.moments.most() / per_unit; }}};
}

TableOf<StationRow> station_table() {
    return {
        "stations.csv",
        "Who passes each station: share, energy, speed, height.",
        "a station",
        {{"station", "name of the station", "input profile.stations", &Station::name},
         {"distance_m", 2, "plan distance along the profile", "input profile.stations", &Station::distance_m},
         {ColumnsOf<Share>{{"rocks", "rocks that pass it at least once", from_counting, &Share::part},
                           share_columns("reached", "their share of all rocks")},
          [](const auto& row) { return share_of(row.energy_j.moments.count(), row.rocks); }},
         station_energy_columns(),
         {energy_rate_columns(), [](const auto& row) { return rates_of(row, row.rocks); }},
         {"translational_mean_kj", 3, "mean of its translational part",
          [](const auto& row) { return row.translational_j.mean() / j_per_kj; }},
         {spread_columns("speed", "mps", "mean speed at the first passage", rockfall::fine_speed_bins,
                         from_fine_bins, 1.0),
          &StationTally::speed_mps},
         {spread_columns("height", "m",
                         "mean height of the underside above the ground, vertical, at the first passage",
                         rockfall::fine_height_bins, from_fine_bins, 1.0),
          [](const auto& row) { return &row.height_m; }}}};
}

struct StretchRow : StretchTally {
    double from_m;
    double to_m;
};

TableOf<StretchRow> envelope_table() {
    return {"envelope.csv",
            "Energy, height and speed along the profile: mean, 95 %, largest.",
            "a stretch of the profile",
            {{"from_distance_m", 2, "plan distance of its begin", from_profile, &StretchRow::from_m},
             {"to_distance_m", 2, "plan distance of its end", from_profile, &StretchRow::to_m},
             {"rocks", "rocks that passed it", from_counting,
              [](const auto& row) { return row.energy_j.moments.count(); }},
             {spread_columns("energy", "kj", "mean of each rock's largest kinetic energy in it",
                             rockfall::energy_bins, from_wide_bins, j_per_kj),
              [](const auto& row) { return &row.energy_j; }},
             {spread_columns("height", "m", "mean of each rock's largest height in it, normal to the slope",
                             rockfall::height_bins, from_wide_bins, 1.0),
              [](const auto& row) { return &row.height_m; }},
             {spread_columns("speed", "mps", "mean of each rock's highest speed in it",
                             rockfall::fine_speed_bins, from_fine_bins, 1.0),
              &StretchTally::speed_mps}}};
}

struct CornerRow {
    std::uint64_t rock;
    std::size_t number;
    const rockfall::PathPoint& point;
};

TableOf<CornerRow> corner_table() {
    return {
        "paths.csv",
        "Sampled paths, corner by corner.",
        "a corner of a sampled path",
        {{rock_number_column(), [](const auto& row) { return row.rock; }},
         {"point", "number of the corner along the path, from 0", [](const auto& row) { return row.number; }},
         {"distance_m", 2, "plan distance along the profile",
          [](const auto& row) { return row.point.position_m.x(); }},
         {"height_m", 2, "height of the rock's underside above sea",
          [](const auto& row) { return row.point.position_m.z(); }},
         {"energy_kj", 3, joined("kinetic energy, ", rockfall::what_energies_count()),
          [](const auto& row) { return static_cast<double>(row.point.energy_j) / j_per_kj; }},
         {"height_above_ground_m", 2, "height of the underside above the ground, vertical",
          [](const auto& row) { return row.point.height_m; }}}};
}

struct IntervalRow {
    std::string station;  ///< "" of all rocks
    DrawnRow drawn;
};

TableOf<IntervalRow> interval_table() {
    return {"intervals.csv",
            "Main figures with two 95 % intervals: of the rocks alone, and of all that is not known.",
            "a figure of a station, or of all rocks",
            {{"station", "name of the station; empty: all rocks", "input profile.stations",
              &IntervalRow::station},
             {drawn_columns("reached, energy_mean, energy_95, speed_mean, height_95 or run_out_mean"),
              &IntervalRow::drawn}}};
}

void add_intervals(auto& rows, const ProfileResults& results) {
    const auto add = [&](const std::string& station, const char* quantity, const char* unit, double factor,
                         const std::optional<DrawnFigure>& figure) {
        if (const auto row = drawn_row(quantity, unit, factor, figure, results.draws)) {
            rows.add({station, *row});
        }
    };
    add("", "run_out_mean", "m", 1.0, results.intervals->run_out_mean_m);
    for (std::size_t i = 0; i < results.site.stations.size(); ++i) {
        const ProfileIntervals::AtStation& at = results.intervals->stations[i];
        const std::string& name = results.site.stations[i].name;
        add(name, "reached", "%", config::percent, at.share);
        add(name, "energy_mean", "kJ", 1.0, at.energy_mean_kj);
        add(name, "energy_95", "kJ", 1.0, at.energy_95_kj);
        add(name, "speed_mean", "m/s", 1.0, at.speed_mean_mps);
        add(name, "height_95", "m", 1.0, at.height_95_m);
    }
}

void add_segments(auto& rows, const ProfileResults& results) {
    const double whole_m = results.site.slope_length_m(results.site.last_m());
    for (std::size_t i = 0; i < results.tally.segments.size(); ++i) {
        const double from_m = static_cast<double>(i) * results.tally.segment_m;
        rows.add({results.tally.segments[i], results.site, from_m,
                  std::min(whole_m, from_m + results.tally.segment_m)});
    }
}

}  // namespace

TableOf<rockfall::RockRecord> rock_table() {
    using Record = rockfall::RockRecord;
    return {"rocks.csv",
            "Every rock: where it ended and why, speed, energy, height.",
            "a rock",
            {{rock_number_column(), &Record::rock},
             {"diameter_m", 3, "diameter of the rock", "drawn as release.diameter_kind says",
              &Record::diameter_m},
             {"stop_reason", "at_rest, caught (by the roughness of the ground), left_terrain or gave_up",
              [](const Record& record) { return name_of(record.reason); }},
             {"start_distance_m", 2, "plan distance of the release along the profile",
              [](const Record& record) { return record.start_m.x(); }},
             {"start_height_m", 2, "height of the release above sea",
              [](const Record& record) { return record.start_m.z(); }},
             {"end_distance_m", 2, "plan distance of the end along the profile",
              [](const Record& record) { return record.end_m.x(); }},
             {"end_height_m", 2, "height of the end above sea",
              [](const Record& record) { return record.end_m.z(); }},
             {"run_out_m", 2, "plan distance from release to end", &Record::run_out_m},
             motion_columns()}};
}

const std::vector<TableLayout>& profile_layouts() {
    static const std::vector<TableLayout> layouts{rock_table(),     segment_table(),  run_out_table(),
                                                  station_table(),  envelope_table(), corner_table(),
                                                  interval_table(), draws_layout()};
    return layouts;
}

std::vector<WrittenFile> write_tables(const ProfileResults& results, const std::filesystem::path& folder) {
    const ProfileTally& tally = results.tally;
    std::vector<WrittenFile> files{
        segment_table().write(folder, [&](auto& rows) { add_segments(rows, results); }),
        run_out_table().write(
            folder,
            [&](auto& rows) {
                for (std::size_t i = 0; i < tally.ends.size(); ++i) {
                    rows.add({end_of_stretch_m(results, i), share_of(tally.ended_beyond(i), tally.rocks)});
                }
            }),
        station_table().write(folder,
                              [&](auto& rows) {
                                  for (std::size_t i = 0; i < results.site.stations.size(); ++i) {
                                      rows.add({results.site.stations[i], tally.stations[i], tally.rocks});
                                  }
                              }),
        envelope_table().write(folder,
                               [&](auto& rows) {
                                   for (std::size_t i = 0; i < tally.stretches.size(); ++i) {
                                       rows.add({tally.stretches[i], end_of_stretch_m(results, i),
                                                 end_of_stretch_m(results, i + 1)});
                                   }
                               }),
        corner_table().write(folder, [&](auto& rows) {
            for (const SampledPath& path : tally.paths) {
                for (std::size_t i = 0; i < path.points.size(); ++i) {
                    rows.add({path.rock, i, path.points[i]});
                }
            }
        })};
    if (results.intervals) {
        files.push_back(interval_table().write(folder, [&](auto& rows) { add_intervals(rows, results); }));
        files.push_back(write_draws(results.draws, folder));
    }
    return files;
}

}  // namespace coupling::profile
