#include "coupling/decades/report/regime_chart.hpp"

#include <algorithm>

#include "coupling/decades/report/page_parts.hpp"
#include "coupling/results/joined.hpp"

namespace coupling::decades {

namespace {

/// The highest point drawn.
double most_of(std::span<const RegimeCurve> curves, bool with_bands) {
    double most = 0.0;
    for (const RegimeCurve& curve : curves) {
        for (const report::ChartPoint& point : curve.means) {
            most = std::max(most, point.y);
        }
        for (const report::ChartRange& range : curve.ranges) {
            most = std::max(most, with_bands ? range.high : most);
        }
    }
    return most;
}

std::string regime_chart(const std::string& title, const RegimeAxes& axes,
                         std::span<const RegimeCurve> curves, double most, const std::string& caption) {
    const bool with_bands = curves.size() <= most_bands;
    report::Chart chart{title,
                        report::Axis{"Years since the start", 0.0,
                                     static_cast<double>(std::max<std::size_t>(axes.years, 1)), false, true},
                        report::Axis::from_zero(axes.y_title, most)};
    for (const RegimeCurve& curve : curves) {
        if (with_bands) {
            chart.add_band(line_of_regime(curve.line), curve.ranges);
        }
    }
    bool any_band = false;
    for (const RegimeCurve& curve : curves) {
        chart.add_line(line_of_regime(curve.line), curve.means);
        chart.add_name(line_of_regime(curve.line), curve.name);
        if (!curve.means.empty()) {
            chart.add_end_letter(curve.means.back().y, curve.letter);
        }
        any_band = any_band || (with_bands && !curve.ranges.empty());
    }
    if (any_band) {
        chart.add_band_name(line_of_regime(curves.front().line), "nine in ten replicates");
    }
    return chart.figure(caption);
}

}  // namespace

std::string regime_charts(const RegimeAxes& axes, std::span<const RegimeCurve> curves,
                          const std::string& caption) {
    if (axes.climates.empty()) {
        return regime_chart(axes.title, axes, curves, most_of(curves, curves.size() <= most_bands), caption);
    }
    std::vector<std::vector<RegimeCurve>> by_climate(axes.climates.size());
    for (const RegimeCurve& curve : curves) {
        by_climate[curve.climate].push_back(curve);
    }
    double most = 0.0;
    for (const std::vector<RegimeCurve>& of_climate : by_climate) {
        most = std::max(most, most_of(of_climate, of_climate.size() <= most_bands));
    }
    std::string html;
    for (std::size_t climate = 0; climate < by_climate.size(); ++climate) {
        if (!by_climate[climate].empty()) {
            html += regime_chart(joined(axes.title, ", climate ", axes.climates[climate]), axes,
                                 by_climate[climate], most, caption);
        }
    }
    return html;
}

}  // namespace coupling::decades
