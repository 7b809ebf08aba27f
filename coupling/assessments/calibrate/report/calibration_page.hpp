#pragma once

#include <ostream>
#include <vector>

#include "coupling/assessments/calibrate/outcome/calibration.hpp"

namespace coupling::calibrate {

/// The calibration as a page: verdict, observed beside predicted, map of stops, what was learned.
void write_page(std::ostream& out, const Calibration& calibration, const std::vector<WrittenFile>& files);

/// A curve of each observation: shares below a value, observed and predicted.
std::string curve_charts(const Calibration& calibration);
/// Factors before and after, by the number of the row in the table.
std::string factor_chart(const Calibration& calibration);
/// Observed stops over those of the sets. Definitions of maps included.
std::string stop_map(const Calibration& calibration);

/// An observation in the language of the page: "stops", "speed at the road".
std::string name_on_page(const Observation& observation, const Site& site);

}  // namespace coupling::calibrate
