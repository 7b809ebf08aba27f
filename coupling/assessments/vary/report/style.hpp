#pragma once

#include <string_view>

namespace coupling::vary::report {

/// CSS of the page of a study.
std::string_view page_style();

}  // namespace coupling::vary::report
