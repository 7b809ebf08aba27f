#include "coupling/results/report/percent_axis.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::joined;

constexpr double all_above = 60.0;
/// Below the smallest value: part of the range of values, at least half a percent.
constexpr double margin_share = 0.15;
constexpr double least_margin = 0.5;

}  // namespace

Axis percent_axis(std::string title, double least, double most) {
    if (!(least > all_above)) {
        return Axis::from_zero(std::move(title), most);
    }
    const double from = least - std::max(least_margin, margin_share * (most - least));
    const double step = nice_step((most - from) / 5.0);
    Axis axis;
    axis.low = std::floor(from / step + 1e-9) * step;
    axis.high = std::ceil(most / step - 1e-9) * step;
    axis.title =
        page_text("{title} (axis from {axis_low} on)", {{"title", title}, {"axis_low", tick_text(axis.low)}});
    return axis;
}

}  // namespace coupling::report
