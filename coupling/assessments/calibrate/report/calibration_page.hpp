#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "coupling/assessments/calibrate/outcome/calibration.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling::calibrate {

/// The calibration as a page: verdict, observed beside predicted, map of stops, what was learned.
void write_page(std::ostream& out, const Calibration& calibration, const std::vector<WrittenFile>& files);

std::string share_or_dash(double share);
std::string range_or_dash(double from, double to);

/// A curve of each observation: shares below a value, observed and predicted.
std::string curve_charts(const Calibration& calibration);
/// Factors before and after, by the number of the row in the table.
std::string factor_chart(const Calibration& calibration);
/// Observed stops, and an outline, over stops of the sets, a map for each site. Definitions of maps included.
std::string stop_map(const Calibration& calibration);

/// An observation in the language of the page: "stops", "speed at the road"; of several sites with the name
/// of its site.
std::string name_on_page(const Observation& observation, const Calibration& calibration);
/// With the name of a site, where there are several.
std::string at_site(const std::string& what, const Calibration& calibration, std::size_t site);

/// Observations that alone are too far away, in a sentence; "" of none.
std::string far_in_words(const Calibration& calibration, const std::vector<FarAlone>& rows);

/// The sites, and what others predict for each of them, as fields of the page; nothing with one site.
std::optional<report::PageFields> site_fields(const Calibration& calibration);

}  // namespace coupling::calibrate
