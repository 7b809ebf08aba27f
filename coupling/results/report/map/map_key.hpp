#pragma once

#include <string>

namespace coupling::report {

/// What outlines and lines on the maps of a page stand for: sources always, targets and nets where there are
/// any. Ready HTML.
std::string map_key(bool with_targets, bool with_nets);

}  // namespace coupling::report
