#pragma once

#include <cstdint>
#include <string>

#include "config/grid/raster.hpp"

namespace coupling::report {

/// The `d` attribute of an SVG path, put together from straight lines on a raster of tenths of a unit.
///
/// A line that goes on where the last one ended only adds its step, and steps of nothing are left out, so
/// that a long path stays short text.
class PathText {
public:
    void line(double x1, double y1, double x2, double y2);
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
    long long x_ = 0;  ///< end of the last line, in tenths
    long long y_ = 0;
    bool begun_ = false;
};

/// Outlines of the cells that are not 0, in cells of `width` x `height` units from the north-western corner:
/// `d` of a path. Runs of edges along a row or column become one stroke.
std::string outlines(const config::Raster<std::uint8_t>& inside, double width, double height);

}  // namespace coupling::report
