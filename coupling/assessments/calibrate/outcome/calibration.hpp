#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/assessments/calibrate/search/judgement.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling::calibrate {

/// A finished calibration, ready to be written.
struct Calibration {
    const Scenario& scenario;
    const Site& site;
    const config::Warnings& warnings;
    const Space& space;
    const std::vector<Observation>& observations;
    const std::vector<SightLine>& lines;
    const SearchPlan& plan;
    const SearchState& state;
    const Judgement& judgement;
    std::string version;
};

/// The table that `run.parameters` reads: the sets that were kept, with their weights.
inline constexpr const char* sample_file = "posterior.csv";
/// The scenario with that table.
inline constexpr const char* calibrated_file = "calibrated.ini";

/// All tables. Those of the sample are the parameters of the site.
std::vector<TableLayout> calibration_layouts(const Space& space);
/// The same without the columns of parameters.
const std::vector<TableLayout>& common_calibration_layouts();
std::vector<WrittenFile> write_tables(const Calibration& calibration, const std::filesystem::path& folder);

/// All figures, settings, warnings and inputs for scripts, as other kinds of runs write them.
void write_summary(std::ostream& out, const Calibration& calibration, const std::vector<WrittenFile>& files);

/// Why the sets may not be called calibrated; "" if they may. An English sentence of messages.csv.
std::string reason_against(const Judgement& judgement, const SearchState& state);

}  // namespace coupling::calibrate
