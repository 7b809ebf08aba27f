#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/assessments/profile/falls/profile_tally.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"

namespace coupling::profile {

/// A finished run along a profile, ready to be written.
struct ProfileResults {
    const Scenario& scenario;
    const ProfileSite& site;
    const ProfileTally& tally;
    const config::Warnings& warnings;
    std::string version;
};

/// tables/rocks.csv, row by row while rocks fall.
void write_rock_header(std::ostream& out);
void write_rock(std::ostream& out, const rockfall::RockRecord& record);

// One row an observation, the unit in the name of each column; empty fields: no rock, or too few to know.
// README.md of this room describes every column.

void write_jumps_by_segment(std::ostream& out, const ProfileResults& results);
void write_run_out(std::ostream& out, const ProfileResults& results);
void write_stations(std::ostream& out, const ProfileResults& results);
void write_envelope(std::ostream& out, const ProfileResults& results);
void write_paths(std::ostream& out, const ProfileResults& results);

/// All figures, settings, warnings and inputs for scripts. In the same form as those
/// of other kinds of runs.
void write_summary(std::ostream& out, const ProfileResults& results, const std::vector<WrittenFile>& files);

/// Writes all of them into tables/, summary.json and report.html into an existing folder. `streamed`: tables
/// that were written while rocks fell. A file that cannot be written throws config::InputError (file).
std::vector<WrittenFile> write_results(const ProfileResults& results, const std::filesystem::path& folder,
                                       const std::vector<WrittenFile>& streamed, const WriteWatch& watch);

}  // namespace coupling::profile
