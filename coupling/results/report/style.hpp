#pragma once

#include <string_view>

namespace coupling::report {

/// The style that the pages of all kinds of runs share: CSS.
std::string_view style();

}  // namespace coupling::report
