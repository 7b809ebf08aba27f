#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "coupling/inputs/drawing/undrawn.hpp"
#include "coupling/inputs/scenario/calibrate_settings.hpp"
#include "coupling/inputs/scenario/design_settings.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"
#include "coupling/inputs/scenario/hazard_settings.hpp"
#include "coupling/inputs/scenario/net_settings.hpp"
#include "coupling/inputs/scenario/observed_settings.hpp"
#include "coupling/inputs/scenario/output_settings.hpp"
#include "coupling/inputs/scenario/profile_settings.hpp"
#include "coupling/inputs/scenario/release_settings.hpp"
#include "coupling/inputs/scenario/report_settings.hpp"
#include "coupling/inputs/scenario/run_settings.hpp"
#include "coupling/inputs/scenario/scenario_file.hpp"
#include "coupling/inputs/scenario/target_settings.hpp"
#include "coupling/inputs/scenario/terrain_settings.hpp"
#include "coupling/inputs/scenario/tree_settings.hpp"
#include "rockfall/parameters.hpp"

namespace coupling {

/// The settings of a run as the user wrote them: texts, numbers and file names, not yet opened. Rooms that
/// need one section take that section.
struct Scenario : ScenarioFile {
    RunSettings run;
    TerrainSettings terrain;
    ProfileSettings profile;
    TreeSettings trees;
    ReleaseSettings release;
    TargetSettings targets;
    ObservedSettings observed;
    CalibrateSettings calibrate;
    NetSettings nets;
    WorkSettings works;
    DesignSettings design;
    HazardSettings hazard;
    RiskSettings risk;
    ReportSettings report;
    OutputSettings output;

    std::vector<Undrawn> undrawn;  ///< layers of run.drawing that were taken out of the settings above

    std::string preset = "default";  ///< [rockfall] and the sections of the motion models
    rockfall::Parameters rockfall;

    /// Of a simulation over years: [forest], [stands], [soil], [climate] and parts of [run], [output].
    ForestSettings forest;
};

/// Declares every setting of a scenario. The options keep references into it: it must not move after.
void declare(config::Options& options, Scenario& scenario);

/// Reads a scenario file and `section.key=value` overrides. Throws InputError with every problem found, such
/// as (data) files outside of `inputs_within` unless that is empty.
std::unique_ptr<Scenario> read_scenario(const std::filesystem::path& file,
                                        const std::vector<std::string>& overrides,
                                        const std::filesystem::path& inputs_within = {});

/// Whether a run lets the rocks of all return periods fall, for a hazard map.
bool wants_hazard_map(const Scenario& scenario);

/// Whether rocks fall: always today, over years unless run.rockfall_every is 0.
bool has_rocks(const Scenario& scenario);

}  // namespace coupling
