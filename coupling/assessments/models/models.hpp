#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "coupling/run/run_request.hpp"

namespace coupling::models {

/// Finished runs of a scenario under several motion models, each in a folder of its name.
struct ModelsRequest {
    const RunRequest& run;     ///< what is asked of each of them
    const Scenario& scenario;  ///< as the run names it, whatever its motion model is
    std::filesystem::path folder;
    std::vector<std::string> models;             ///< in the order of columns
    std::vector<double> return_periods_years{};  ///< of a hazard map; none: a run of today
};

/// Before any rock falls: refuses a folder with results of another command or with files of the user under
/// the names of what is written here. Throws config::InputError (settings).
void look_at_models_folder(const std::filesystem::path& folder);

/// Puts the finished runs side by side: models.csv, model_ranges.csv, of a hazard map model_levels.csv,
/// report.html, results.gpkg where the scenario wants one, data_dictionary.csv and summary.json in the folder
/// around them, and the distributions and maps side by side (`bannwald compare`) in its folder `comparison`.
/// What an earlier call wrote there is replaced. Prints the main ranges. Throws config::InputError.
void put_side_by_side(const ModelsRequest& request, std::ostream& screen);

}  // namespace coupling::models
