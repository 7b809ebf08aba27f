#pragma once

#include <ostream>

#include "coupling/assessments/nets/siting/siting.hpp"
#include "coupling/inputs/scenario/report_settings.hpp"

namespace coupling::siting {

/// The page: where works are needed and which, a map, what comes to each line against the position along it,
/// the candidates, and how they were found. Head and language are those of the run.
void write_siting_page(std::ostream& out, const SitingResults& results, const rockfall::Terrain& terrain,
                       const ReportSettings& head);

}  // namespace coupling::siting
