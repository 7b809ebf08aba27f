#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/assessments/profile/profile_results.hpp"

namespace coupling::profile {

/// The results as one self-contained HTML page: no script, no outside address, same bytes from the same
/// results.
void write_page(std::ostream& out, const ProfileResults& results, const std::vector<WrittenFile>& files);

// The parts of the page, each a piece of HTML.

/// The profile at true vertical scale with ground types, stations and sampled paths.
std::string drawing(const ProfileResults& results);
/// Run-out, envelopes of height and energy, jump lengths by segment.
std::string charts_along(const ProfileResults& results);
/// Energies at the stations: a histogram each, for those that rocks pass.
std::string charts_at_stations(const ProfileResults& results);
/// What the page needs beside the style of all reports.
std::string_view style_of_profile();

}  // namespace coupling::profile
