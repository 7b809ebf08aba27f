#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/assessments/profile/falls/profile_intervals.hpp"
#include "coupling/assessments/profile/falls/profile_tally.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"
#include "coupling/results/tables/table_of.hpp"

namespace coupling::profile {

/// A finished run along a profile, ready to be written.
struct ProfileResults {
    const Scenario& scenario;
    const ProfileSite& site;
    const ProfileTally& tally;
    const ParameterDraws& draws;
    std::optional<ProfileIntervals> intervals;  ///< nothing where all rocks fell by the same laws
    const config::Warnings& warnings;
    std::string version;
};

/// rocks.csv, which is written row by row while rocks fall.
TableOf<rockfall::RockRecord> rock_table();

/// All tables of a run along a profile. One row an observation, the unit in the name of each column; empty
/// fields: no rock, or too few to know. README.md of this room describes every column.
const std::vector<TableLayout>& profile_layouts();
/// Writes the others into tables/ of a folder.
std::vector<WrittenFile> write_tables(const ProfileResults& results, const std::filesystem::path& folder);

/// All figures, settings, warnings and inputs for scripts. In the same form as those
/// of other kinds of runs.
void write_summary(std::ostream& out, const ProfileResults& results, const std::vector<WrittenFile>& files);

/// Writes all of them into tables/, summary.json and report.html into an existing folder. `streamed`: tables
/// that were written while rocks fell. A file that cannot be written throws config::InputError (file).
std::vector<WrittenFile> write_results(const ProfileResults& results, const std::filesystem::path& folder,
                                       const std::vector<WrittenFile>& streamed, const WriteWatch& watch);

}  // namespace coupling::profile
