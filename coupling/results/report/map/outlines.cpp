#include "coupling/results/report/map/outlines.hpp"

#include <cmath>

#include "coupling/results/text/markup.hpp"

namespace coupling::report {
namespace {

/// A step or place in tenths; a separating blank where the text needs one.
void append(std::string& text, char command, long long x, long long y) {
    text += command;
    text += place(static_cast<double>(x) / 10.0);
    const std::string second = place(static_cast<double>(y) / 10.0);
    text += second.starts_with('-') ? "" : " ";
    text += second;
}

}  // namespace

void PathText::line(double x1, double y1, double x2, double y2) {
    const long long from_x = std::llround(10.0 * x1);
    const long long from_y = std::llround(10.0 * y1);
    const long long to_x = std::llround(10.0 * x2);
    const long long to_y = std::llround(10.0 * y2);
    if (!begun_ || from_x != x_ || from_y != y_) {
        append(text_, 'M', from_x, from_y);
        begun_ = true;
        x_ = from_x;
        y_ = from_y;
    }
    if (to_x != x_ || to_y != y_) {
        append(text_, 'l', to_x - x_, to_y - y_);
        x_ = to_x;
        y_ = to_y;
    }
}

std::string outlines(const config::Raster<std::uint8_t>& inside, double width, double height) {
    const config::GridFrame& frame = inside.frame;
    const auto is_in = [&](int column, int row) {
        return frame.contains({column, row}) && inside.at({column, row}) != 0;
    };
    PathText path;
    for (int row = 0; row <= frame.rows; ++row) {
        for (int column = 0; column < frame.columns; ++column) {
            const int first = column;
            while (column < frame.columns && is_in(column, row - 1) != is_in(column, row)) {
                ++column;
            }
            if (column > first) {
                path.line(first * width, row * height, column * width, row * height);
            }
        }
    }
    for (int column = 0; column <= frame.columns; ++column) {
        for (int row = 0; row < frame.rows; ++row) {
            const int first = row;
            while (row < frame.rows && is_in(column - 1, row) != is_in(column, row)) {
                ++row;
            }
            if (row > first) {
                path.line(column * width, first * height, column * width, row * height);
            }
        }
    }
    return path.text();
}

}  // namespace coupling::report
