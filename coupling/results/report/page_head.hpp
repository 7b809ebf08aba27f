#pragma once

#include <string>

#include "coupling/inputs/scenario/report_settings.hpp"

namespace coupling::report {

/// The head of a page: its heading, for whom and by whom it was made, where, when, and a logo. `about` says
/// what the page is about (HTML): the heading, or the line below the title that the user gave.
std::string page_head(const ReportSettings& report, const std::string& about);

/// The title of the window: that of the user, or `about` (HTML).
std::string page_title(const ReportSettings& report, const std::string& about);

}  // namespace coupling::report
