#include "coupling/assessments/decades/report/regime_chart.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/assessments/decades/report/series.hpp"
#include "coupling/results/report/percent_axis.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using config::joined;

/// The lowest and the highest point drawn.
struct Extent {
    double least = INFINITY;
    double most = 0.0;
    void add(double low, double high) {
        least = std::min(least, low);
        most = std::max(most, high);
    }
};
Extent extent_of(std::span<const RegimeCurve> curves) {
    const bool with_bands = curves.size() <= most_bands;
    Extent extent;
    for (const RegimeCurve& curve : curves) {
        for (const report::ChartPoint& point : curve.means) {
            extent.add(point.y, point.y);
        }
        for (std::size_t i = 0; with_bands && i < curve.ranges.size(); ++i) {
            extent.add(curve.ranges[i].low, curve.ranges[i].high);
        }
    }
    return extent;
}

std::string regime_chart(const std::string& title, const RegimeAxes& axes,
                         std::span<const RegimeCurve> curves, const Extent& extent,
                         const std::string& caption) {
    const bool with_bands = curves.size() <= most_bands;
    report::Chart chart{title,
                        report::Axis{report::page_text("Years since the start"), 0.0,
                                     static_cast<double>(std::max<std::size_t>(axes.years, 1)), false, true},
                        axes.may_begin_above_0 && std::isfinite(extent.least)
                            ? report::percent_axis(axes.y_title, extent.least, extent.most)
                            : report::Axis::from_zero(axes.y_title, extent.most)};
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
        chart.add_band_name(line_of_regime(curves.front().line),
                            report::page_text("90 % interval of the mean"));
    }
    return chart.figure(caption);
}

}  // namespace

report::ChartRange range_at(double x, const Band& band) {
    return band.has_interval() ? report::ChartRange{x, band.low, band.high}
                               : report::ChartRange{x, band.mean, band.mean};
}

std::string regime_charts(const RegimeAxes& axes, std::span<const RegimeCurve> curves,
                          const std::string& caption) {
    if (axes.climates.empty()) {
        return regime_chart(axes.title, axes, curves, extent_of(curves), caption);
    }
    std::vector<std::vector<RegimeCurve>> by_climate(axes.climates.size());
    for (const RegimeCurve& curve : curves) {
        by_climate[curve.climate].push_back(curve);
    }
    Extent extent;
    for (const std::vector<RegimeCurve>& of_climate : by_climate) {
        const Extent here = extent_of(of_climate);
        extent.add(here.least, here.most);
    }
    std::string html;
    for (std::size_t climate = 0; climate < by_climate.size(); ++climate) {
        if (!by_climate[climate].empty()) {
            html += regime_chart(
                report::page_text("{axes_title}, climate {climates_climate}",
                                  {{"axes_title", axes.title}, {"climates_climate", axes.climates[climate]}}),
                axes, by_climate[climate], extent, caption);
        }
    }
    return html;
}

std::string series_charts(const Names& names, const Series& series, RegimeAxes axes,
                          const std::string& caption) {
    const std::vector<std::int32_t> years = years_of(series);
    std::vector<RegimeCurve> curves;
    for (std::size_t course = 0; course < names.courses(); ++course) {
        const CourseLook look = look_of(names, course);
        RegimeCurve curve{look.line, names.climate_of(course), look.title_in_chart(), look.letter};
        for (const std::int32_t year : years) {
            if (const auto v = over_replicates(series, course, year)) {
                const auto x = static_cast<double>(year);
                curve.means.push_back({x, std::max(0.0, v->band.mean)});
                if (v->replicates > 1) {
                    const report::ChartRange range = range_at(x, v->band);
                    curve.ranges.push_back({x, std::max(0.0, range.low), std::max(0.0, range.high)});
                }
            }
        }
        if (!curve.means.empty()) {
            curves.push_back(std::move(curve));
        }
    }
    axes.years = static_cast<std::size_t>(years.back());
    axes.climates = splits_charts(names) ? names.climates : std::vector<std::string>{};
    return regime_charts(axes, curves, caption);
}

}  // namespace coupling::decades
