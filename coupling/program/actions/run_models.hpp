#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "coupling/run/ranks.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling {

/// Names of the motion models, in the order of their list.
std::vector<std::string> model_names();

/// Throws config::InputError (settings) for a model that does not exist, with the nearest name, and for one
/// that comes twice.
void refuse_unknown_models(const std::vector<std::string>& models);

/// The setting that a run under one of them has beside its own.
std::string setting_of_model(const std::string& model);

/// Runs a scenario under several motion models with the same rocks and trees, each into a folder of its name,
/// and puts the finished runs side by side in the folder around them: a page over a run of today and over a
/// hazard map, for other kinds of runs the folder `comparison` alone. One model is a plain run.
///
/// A model whose run is finished with these settings, these inputs and this version is not run again. What
/// stands in the way is refused before any rock falls. Returns what run_assessment returns. Throws
/// config::InputError; (settings) as refuse_unknown_models.
int run_models(const RunRequest& request, const std::vector<std::string>& models, RankGroup& ranks,
               std::ostream& out);

}  // namespace coupling
