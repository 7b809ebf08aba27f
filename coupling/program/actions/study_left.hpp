#pragma once

#include <filesystem>
#include <ostream>

#include "coupling/assessments/decades/members/management.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/program/actions/estimate.hpp"

namespace coupling {

/// Members of a run and their years, as far as an earlier one has left none of the same content in its
/// folder.
StudySize study_left(const std::filesystem::path& out, const Scenario& scenario, const Site& site,
                     const decades::Management& management);

/// What earlier runs have left of a study that grows; nothing where there is nothing.
void say_what_is_left(const Scenario& scenario, const StudySize& study, std::ostream& out);

}  // namespace coupling
