#pragma once

#include <string>

namespace coupling::report {

/// What the maps of a page show as outlines and lines.
struct OnMaps {
    bool sources = true;
    bool targets = false;
    bool nets = false;
    bool works = false;
};

/// What they stand for. Ready HTML.
std::string map_key(const OnMaps& drawn);

}  // namespace coupling::report
