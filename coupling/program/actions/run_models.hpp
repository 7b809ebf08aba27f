#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "coupling/run/ranks.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling {

/// Names of the motion models, in the order of their list.
std::vector<std::string> model_names();

/// Runs a scenario under several motion models with the same rocks and trees, each into a folder of its name,
/// and puts the finished runs side by side in the folder `comparison` beside them.
///
/// A model whose run is finished with these settings, these inputs and this version is not run again. Returns
/// what run_assessment returns. Throws config::InputError; (settings) for a model that does not exist or
/// comes twice.
int run_models(const RunRequest& request, const std::vector<std::string>& models, RankGroup& ranks,
               std::ostream& out);

}  // namespace coupling
