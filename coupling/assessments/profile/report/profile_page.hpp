#pragma once

#include <optional>
#include <ostream>
#include <vector>

#include "coupling/assessments/profile/profile_results.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling::profile {

/// The results as one self-contained HTML page: no script, no outside address, same bytes from the same
/// results.
void write_page(std::ostream& out, const ProfileResults& results, const std::vector<WrittenFile>& files);

// What profile_page.html is filled with.

/// The profile at true vertical scale with ground types, stations and sampled paths.
report::PageFields drawing(const ProfileResults& results);
/// Run-out, envelopes of height and energy, jump lengths by segment.
report::PageFields charts_along(const ProfileResults& results);
/// Energies at the stations: a histogram each, for those that rocks pass.
std::optional<report::PageFields> charts_at_stations(const ProfileResults& results);

}  // namespace coupling::profile
