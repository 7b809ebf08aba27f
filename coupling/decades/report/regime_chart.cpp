#include "coupling/decades/report/regime_chart.hpp"

#include <algorithm>

#include "coupling/decades/report/page_parts.hpp"

namespace coupling::decades {

std::string regime_chart(const std::string& title, const std::string& y_title, std::size_t years,
                         std::span<const RegimeCurve> curves, const std::string& caption) {
    const bool with_bands = curves.size() <= most_bands;
    double most = 0.0;
    for (const RegimeCurve& curve : curves) {
        for (const report::ChartPoint& point : curve.means) {
            most = std::max(most, point.y);
        }
        for (const report::ChartRange& range : curve.ranges) {
            most = std::max(most, with_bands ? range.high : most);
        }
    }
    report::Chart chart{title,
                        report::Axis{"Years since the start", 0.0,
                                     static_cast<double>(std::max<std::size_t>(years, 1)), false, true},
                        report::Axis::from_zero(y_title, most)};
    for (const RegimeCurve& curve : curves) {
        if (with_bands) {
            chart.add_band(line_of_regime(curve.regime), curve.ranges);
        }
    }
    bool any_band = false;
    for (const RegimeCurve& curve : curves) {
        chart.add_line(line_of_regime(curve.regime), curve.means);
        chart.add_name(line_of_regime(curve.regime), curve.name);
        if (!curve.means.empty()) {
            chart.add_end_letter(curve.means.back().y, curve.letter);
        }
        any_band = any_band || (with_bands && !curve.ranges.empty());
    }
    if (any_band) {
        chart.add_band_name(line_of_regime(curves.front().regime), "nine in ten replicates");
    }
    return chart.figure(caption);
}

}  // namespace coupling::decades
