#include "coupling/run/run_request.hpp"

#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling {

std::filesystem::path output_folder_of(const RunRequest& request, const Scenario& scenario) {
    return request.out.empty() ? scenario.file.parent_path() / "out" : request.out;
}

}  // namespace coupling
