#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coupling::report {

/// An axis with its title, unit included.
struct Axis {
    std::string title;
    double low = 0.0;
    double high = 1.0;
    bool logarithmic = false;
    bool whole_numbers = false;           ///< ticks at whole numbers only
    std::vector<std::string> names = {};  ///< shown at 1, 2, ... instead of the numbers

    /// From 0 to a round number not below `high`.
    static Axis from_zero(std::string title, double high);
    /// Whole powers of ten around the values. Requires 0 < low <= high.
    static Axis powers_of_ten(std::string title, double low, double high);

    [[nodiscard]] double share_of(double value) const;  ///< place along the axis, 0 to 1, not cut off
    [[nodiscard]] std::vector<double> ticks() const;
    /// What stands at a tick: its name, or the number.
    [[nodiscard]] std::string label(double tick) const;
};

struct ChartPoint {
    double x;
    double y;
};

/// A range at a place.
struct ChartRange {
    double x;
    double low;
    double high;
};

/// A chart as inline SVG: every series has its colour and its line style, so that it reads without colour
/// too.
///
/// Series are named by a class that the page's style knows: "forest" (solid, filled), "bare" (dashed). Bands
/// and dots need a style of their own: "band" and "dot" beside the class of the series. Bars are bands.
///
/// Two short names stand in the drawing; more, or longer ones, in a list above it. The numbers go into the
/// figure too: where scripts run the chart becomes interactive (coupling/page_scripts), in print and without
/// scripts it is the drawing.
class Chart {
public:
    Chart(std::string title, Axis x, Axis y);

    /// Heights over bins; edges has one number more than heights.
    void add_steps(const std::string& series, std::span<const double> edges, std::span<const double> heights);
    void add_line(const std::string& series, std::span<const ChartPoint> points);
    /// The area between the lower and the upper ends of ranges, in the order of x.
    void add_band(const std::string& series, std::span<const ChartRange> ranges);
    /// A vertical stroke with caps at each range.
    void add_whiskers(const std::string& series, std::span<const ChartRange> ranges);
    void add_dots(const std::string& series, std::span<const ChartPoint> points);
    /// A filled rectangle from `range.low` to `range.high`, its left side at `range.x`.
    void add_bar(const std::string& series, const ChartRange& range, double x_right);
    /// A short word around a place inside the drawing, over all series.
    void add_word(const ChartPoint& place, const std::string& word);
    /// A letter or two right of the drawing, at the height where a series ends; letters that would cover each
    /// other move apart.
    void add_end_letter(double y, const std::string& letter);
    /// A thin vertical line with a small label at its top.
    void add_mark(double x, const std::string& label);
    /// A small word that begins at a point.
    void add_label(double x, double y, const std::string& text);
    void add_name(const std::string& series, const std::string& name);
    void add_band_name(const std::string& series, const std::string& name);
    void add_dot_name(const std::string& series, const std::string& name);

    [[nodiscard]] std::string figure(const std::string& caption) const;
    /// The names as a list, for a place outside the figure.
    [[nodiscard]] std::string list_of_names() const;

private:
    [[nodiscard]] double x_of(double value) const;
    [[nodiscard]] double y_of(double value) const;
    [[nodiscard]] std::string axes() const;
    [[nodiscard]] std::string end_letters() const;
    [[nodiscard]] std::string mark_names() const;
    [[nodiscard]] bool names_fit() const;
    [[nodiscard]] std::string names() const;
    /// All that is drawn as numbers, for the script that makes the chart interactive.
    [[nodiscard]] std::string numbers() const;
    void keep(const char* kind, const std::string& series, const std::vector<double>& numbers);
    void note(const char* kind, double x, double y, const std::string& text);

    std::string title_;
    Axis x_;
    Axis y_;
    std::string drawing_;
    std::string marks_;
    std::vector<std::string> parts_;  ///< JSON of each series
    std::vector<std::string> notes_;  ///< JSON of words, labels and marks
    struct EndLetter {
        double y = 0.0;  ///< of the drawing
        double value = 0.0;
        std::string letter;
    };
    std::vector<EndLetter> end_letters_;
    struct MarkName {
        double x = 0.0;  ///< of the drawing
        std::string name;
    };
    std::vector<MarkName> mark_names_;
    enum class Sample : std::uint8_t { line, band, dot };
    struct Name {
        std::string series;
        std::string name;
        Sample sample = Sample::line;
    };
    std::vector<Name> names_;
};

}  // namespace coupling::report
