#pragma once

#include <string>
#include <vector>

#include "coupling/results/report/chart.hpp"

namespace coupling::validation {

/// A line, dots or a band of a plot. `style` is a class of the page's style.
struct PlotSeries {
    enum class Form : std::uint8_t { line, dots, band };

    std::string name;
    std::string style;
    Form form = Form::line;
    std::vector<report::ChartPoint> points;  ///< of a line or dots
    std::vector<report::ChartRange> ranges;  ///< of a band
};

/// A word in a plot, beginning at a point of its axes.
struct PlotLabel {
    double x = 0.0;
    double y = 0.0;
    std::string text;
};

/// Numbers of a case as a drawing: for the page and for plots.csv.
struct Plot {
    std::string title;
    report::Axis x;  ///< titles with units
    report::Axis y;
    std::vector<PlotSeries> series;  ///< later ones are drawn over earlier ones
    std::vector<PlotLabel> labels;
    std::string caption;
};

/// Plots that are looked at side by side; two or more share the names of their series.
struct PlotGroup {
    std::string title;
    std::vector<Plot> plots;
    bool small = false;  ///< three in a row instead of two
};

/// A table for the page. All texts are plain.
struct PlainTable {
    std::string caption;
    std::vector<std::string> head;  ///< with units
    std::vector<std::vector<std::string>> rows;
};

}  // namespace coupling::validation
