#include "coupling/results/report/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "config/text/joined.hpp"
#include "coupling/page_scripts/json_text.hpp"
#include "coupling/results/report/map/outlines.hpp"
#include "coupling/results/tables/text_layout.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::report {
namespace {

using config::joined;

constexpr double left_edge = 72.0;
constexpr double right_edge = 408.0;
constexpr double top = 34.0;
constexpr double bottom = 262.0;
/// Of an axis: more cannot be read [choice].
constexpr std::size_t most_ticks = 20;
/// Between the names of two series in the drawing.
constexpr double name_width = 140.0;
/// Of a name that leaves room for its neighbour.
constexpr std::size_t short_name = 16;

/// What of the figure is seen: 430 wide, from here down to 310.
constexpr double view_width = 430.0;
constexpr double view_top = 18.0;
constexpr double view_bottom = 310.0;
/// Of the wider fonts, in the size of the page's style.
constexpr double letter_of_titles = 0.6 * 13.0;
constexpr double letter_of_numbers = 0.6 * 12.0;

/// A title around `middle`, moved where it would reach out of [from, to], and as long as that where it is
/// longer: no font of a reader or a printer cuts it off.
struct TitlePlace {
    double middle;
    std::optional<double> length;
};
TitlePlace place_title(const std::string& title, double middle, double from, double to) {
    constexpr double rim = 4.0;
    const double room = to - from - 2.0 * rim;
    const double width = letter_of_titles * static_cast<double>(width_of(title));
    if (width > room) {
        return {0.5 * (from + to), room};
    }
    return {std::clamp(middle, from + rim + 0.5 * width, to - rim - 0.5 * width), std::nullopt};
}

Attributes attributes_of_title(const TitlePlace& place) {
    Attributes attributes{{"class", "axis-title"}, {"text-anchor", "middle"}};
    if (place.length) {
        attributes.push_back({"textLength", *place.length});
        attributes.push_back({"lengthAdjust", "spacingAndGlyphs"});
    }
    return attributes;
}

std::string dot_at(const std::string& series, double x, double y) {
    return element("circle", {{"class", joined("dot ", series)}, {"cx", x}, {"cy", y}, {"r", 4.0}});
}

std::vector<double> numbers_of(std::span<const ChartPoint> points) {
    std::vector<double> numbers;
    for (const ChartPoint& point : points) {
        numbers.insert(numbers.end(), {point.x, point.y});
    }
    return numbers;
}

std::vector<double> numbers_of(std::span<const ChartRange> ranges) {
    std::vector<double> numbers;
    for (const ChartRange& range : ranges) {
        numbers.insert(numbers.end(), {range.x, range.low, range.high});
    }
    return numbers;
}

std::string json_of(const Axis& axis) {
    page_scripts::JsonObject json;
    json.text("title", axis.title)
        .number("low", axis.low)
        .number("high", axis.high)
        .flag("logarithmic", axis.logarithmic)
        .add("ticks", page_scripts::json_numbers(axis.ticks()));
    if (!axis.names.empty()) {
        std::string names;
        for (const double tick : axis.ticks()) {
            names += joined(names.empty() ? "" : ",", page_scripts::json_string(axis.label(tick)));
        }
        json.add("names", joined("[", names, "]"));
    }
    return json.json();
}

}  // namespace

Axis Axis::from_zero(std::string title, double high) {
    const double step = nice_step((high > 0.0 ? high : 1.0) / 6.0);
    return {std::move(title), 0.0, std::ceil((high > 0.0 ? high : 1.0) / step - 1e-9) * step};
}

Axis Axis::powers_of_ten(std::string title, double low, double high) {
    const double first = std::floor(std::log10(low) + 1e-9);
    const double last = std::max(first + 1.0, std::ceil(std::log10(high) - 1e-9));
    return {std::move(title), std::pow(10.0, first), std::pow(10.0, last), true};
}

double Axis::share_of(double value) const {
    if (logarithmic) {
        return value > 0.0 ? std::log(value / low) / std::log(high / low) : -1.0;
    }
    return (value - low) / (high - low);
}

std::vector<double> Axis::ticks() const {
    std::vector<double> values;
    if (logarithmic) {
        // Over many powers of ten every second, third ... has a tick.
        const double powers = std::log10(high) - std::log10(low);
        const double each = std::pow(10.0, std::max(1.0, std::ceil(powers / most_ticks)));
        for (double tick = low; tick <= high * 1.0001 && values.size() < most_ticks; tick *= each) {
            values.push_back(tick);
        }
        return values;
    }
    const double step = std::max(nice_step((high - low) / 6.0), whole_numbers ? 1.0 : 0.0);
    const double first = std::ceil(low / step - 1e-9) * step;
    // Six steps give seven ticks at most; numbers that no chart can show give none.
    for (std::size_t i = 0; i < most_ticks && first + static_cast<double>(i) * step <= high + 1e-9 * step;
         ++i) {
        values.push_back(first + static_cast<double>(i) * step);
    }
    return values;
}

std::string Axis::label(double tick) const {
    if (names.empty()) {
        return tick_text(tick);
    }
    const auto number = static_cast<std::size_t>(std::max(0L, std::lround(tick)));
    return number >= 1 && number <= names.size() ? names[number - 1] : "";
}

Chart::Chart(std::string title, Axis x, Axis y)
    : title_{std::move(title)}, x_{std::move(x)}, y_{std::move(y)} {}

double Chart::x_of(double value) const {
    return left_edge + std::clamp(x_.share_of(value), 0.0, 1.0) * (right_edge - left_edge);
}

double Chart::y_of(double value) const {
    return bottom - std::clamp(y_.share_of(value), 0.0, 1.0) * (bottom - top);
}

void Chart::add_steps(const std::string& series, std::span<const double> edges,
                      std::span<const double> heights) {
    PathText area;
    double y = bottom;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const double next = y_of(heights[i]);
        area.line(x_of(edges[i]), y, x_of(edges[i]), next);
        area.line(x_of(edges[i]), next, x_of(edges[i + 1]), next);
        y = next;
    }
    area.line(x_of(edges[heights.size()]), y, x_of(edges[heights.size()]), bottom);
    drawing_ += svg_path(joined("area ", series), area.text());
    std::vector<double> bins;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        bins.insert(bins.end(), {edges[i], edges[i + 1], heights[i]});
    }
    keep("steps", series, bins);
}

void Chart::add_line(const std::string& series, std::span<const ChartPoint> points) {
    PathText line;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        line.line(x_of(points[i].x), y_of(points[i].y), x_of(points[i + 1].x), y_of(points[i + 1].y));
    }
    if (const std::string text = line.text(); !text.empty()) {
        drawing_ += svg_path(joined("line ", series), text);
    }
    keep("line", series, numbers_of(points));
}

void Chart::add_band(const std::string& series, std::span<const ChartRange> ranges) {
    if (ranges.empty()) {
        return;
    }
    PathText rim;
    for (std::size_t i = 0; i + 1 < ranges.size(); ++i) {
        rim.line(x_of(ranges[i].x), y_of(ranges[i].high), x_of(ranges[i + 1].x), y_of(ranges[i + 1].high));
    }
    const ChartRange& last = ranges.back();
    rim.line(x_of(last.x), y_of(last.high), x_of(last.x), y_of(last.low));
    for (std::size_t i = ranges.size(); i-- > 1;) {
        rim.line(x_of(ranges[i].x), y_of(ranges[i].low), x_of(ranges[i - 1].x), y_of(ranges[i - 1].low));
    }
    drawing_ += svg_path(joined("band ", series), rim.text());
    keep("band", series, numbers_of(ranges));
}

void Chart::add_whiskers(const std::string& series, std::span<const ChartRange> ranges) {
    std::string strokes;
    for (const ChartRange& range : ranges) {
        const std::string cap = joined("M", place(x_of(range.x) - 3.0), " ");
        strokes +=
            joined("M", place(x_of(range.x)), " ", place(y_of(range.low)), "V", place(y_of(range.high)), cap,
                   place(y_of(range.low)), "h6", cap, place(y_of(range.high)), "h6");
    }
    drawing_ += svg_path(joined("whiskers ", series), strokes);
    keep("whiskers", series, numbers_of(ranges));
}

void Chart::add_dots(const std::string& series, std::span<const ChartPoint> points) {
    for (const ChartPoint& point : points) {
        drawing_ += dot_at(series, x_of(point.x), y_of(point.y));
    }
    keep("dots", series, numbers_of(points));
}

void Chart::add_bar(const std::string& series, const ChartRange& range, double x_right) {
    const double x = x_of(range.x);
    drawing_ += svg_path(joined("band ", series),
                         joined("M", place(x), " ", place(y_of(range.low)), "V", place(y_of(range.high)), "H",
                                place(x_of(x_right)), "V", place(y_of(range.low)), "z"));
    keep("bar", series, {range.x, x_right, range.low, range.high});
}

void Chart::add_word(const ChartPoint& at, const std::string& word) {
    const double half = 4.0 * static_cast<double>(word.size());
    marks_ += svg_text(std::clamp(x_of(at.x), left_edge + half, right_edge - half), y_of(at.y) + 4.5, word,
                       {{"class", "word"}});
    note("word", at.x, at.y, word);
}

void Chart::add_end_letter(double y, const std::string& letter) {
    end_letters_.push_back({y_of(y), y, letter});
}

std::string Chart::end_letters() const {
    constexpr double apart = 13.0;
    std::vector<EndLetter> letters = end_letters_;
    std::stable_sort(letters.begin(), letters.end(),
                     [](const EndLetter& a, const EndLetter& b) { return a.y < b.y; });
    // Down where they are too close, then up from the foot of the drawing.
    for (std::size_t i = 1; i < letters.size(); ++i) {
        letters[i].y = std::max(letters[i].y, letters[i - 1].y + apart);
    }
    double lowest = bottom;
    std::string svg;
    for (std::size_t i = letters.size(); i-- > 0; lowest = letters[i].y - apart) {
        letters[i].y = std::min(letters[i].y, lowest);
        svg += svg_text(right_edge + 5.0, letters[i].y + 4.5, letters[i].letter, {{"class", "letter"}});
    }
    return svg;
}

void Chart::add_mark(double x, const std::string& label) {
    if (x_.share_of(x) <= 0.0 || x_.share_of(x) >= 1.0) {
        return;
    }
    marks_ += svg_path("mark", joined("M", place(x_of(x)), " ", place(top), "V", place(bottom)));
    mark_names_.push_back({x_of(x) + 3.0, label});
    note("mark", x, y_.low, label);
}

std::string Chart::mark_names() const {
    constexpr double letter = 6.5;  // of the small font
    constexpr double apart = 13.0;
    std::vector<MarkName> names = mark_names_;
    std::stable_sort(names.begin(), names.end(),
                     [](const MarkName& a, const MarkName& b) { return a.x < b.x; });
    // Each in the first row in which it lies over no other.
    std::vector<double> ends;
    std::string svg;
    for (const MarkName& name : names) {
        const auto row = std::find_if(ends.begin(), ends.end(), [&](double end) { return end <= name.x; });
        const auto index = static_cast<double>(row - ends.begin());
        const double end = name.x + letter * static_cast<double>(width_of(name.name));
        if (row == ends.end()) {
            ends.push_back(end);
        } else {
            *row = end;
        }
        svg += svg_text(name.x, top + 10.0 + apart * index, name.name, {{"class", "small"}});
    }
    return svg;
}

void Chart::add_label(double x, double y, const std::string& text) {
    marks_ += svg_text(x_of(x) + 4.0, y_of(y) + 4.0, text, {{"class", "small"}});
    note("label", x, y, text);
}

void Chart::add_name(const std::string& series, const std::string& name) {
    names_.push_back({series, name, Sample::line});
}

void Chart::add_band_name(const std::string& series, const std::string& name) {
    names_.push_back({series, name, Sample::band});
}

void Chart::add_dot_name(const std::string& series, const std::string& name) {
    names_.push_back({series, name, Sample::dot});
}

bool Chart::names_fit() const {
    return names_.size() <= 2 && std::all_of(names_.begin(), names_.end(), [](const Name& name) {
               return name.sample == Sample::line && name.name.size() <= short_name;
           });
}

std::string Chart::axes() const {
    std::string grid;
    std::string labels;
    for (const double tick : x_.ticks()) {
        grid += joined("M", place(x_of(tick)), " ", place(bottom), "v5");
        const std::string label = x_.label(tick);
        const double half = 0.5 * letter_of_numbers * static_cast<double>(width_of(label));
        labels += svg_text(std::min(x_of(tick), view_width - half), bottom + 19.0, label,
                           {{"class", "axis-number"}, {"text-anchor", "middle"}});
    }
    std::string lines;
    for (const double tick : y_.ticks()) {
        lines += joined("M", place(left_edge), " ", place(y_of(tick)), "H", place(right_edge));
        labels += svg_text(left_edge - 6.0, y_of(tick) + 4.0, tick_text(tick),
                           {{"class", "axis-number"}, {"text-anchor", "end"}});
    }
    const TitlePlace below = place_title(x_.title, 0.5 * (left_edge + right_edge), 0.0, view_width);
    const TitlePlace beside = place_title(y_.title, 0.5 * (top + bottom), view_top, view_bottom);
    Attributes upwards = attributes_of_title(beside);
    upwards.push_back({"transform", joined("translate(14 ", place(beside.middle), ")rotate(-90)")});
    return joined(
        svg_path("grid", lines),
        svg_path("axis", joined("M", place(left_edge), " ", place(bottom), "H", place(right_edge), grid)),
        labels, svg_text(below.middle, bottom + 40.0, x_.title, attributes_of_title(below)),
        element("text", upwards, escaped(y_.title)));
}

std::string Chart::names() const {
    std::string svg;
    double x = left_edge;
    for (const Name& name : names_) {
        svg += svg_path(joined("line ", name.series), joined("M", place(x), " 16h26"));
        svg += svg_text(x + 32.0, 20.0, name.name);
        x += name_width;
    }
    return svg;
}

std::string Chart::list_of_names() const {
    std::string items;
    for (const Name& name : names_) {
        std::string sample;
        if (name.sample == Sample::line) {
            sample = svg_path(joined("line ", name.series), "M1 7h28");
        } else if (name.sample == Sample::band) {
            sample = svg_path(joined("band ", name.series), "M1 2h28v10h-28z");
        } else {
            sample = dot_at(name.series, 15.0, 7.0);
        }
        items += legend_item(sample, escaped(name.name));
    }
    return element("ul", {{"class", "names"}}, items);
}

void Chart::keep(const char* kind, const std::string& series, const std::vector<double>& numbers) {
    parts_.push_back(page_scripts::JsonObject{}
                         .text("kind", kind)
                         .text("of", series)
                         .add("numbers", page_scripts::json_numbers(numbers))
                         .json());
}

void Chart::note(const char* kind, double x, double y, const std::string& text) {
    notes_.push_back(page_scripts::JsonObject{}
                         .text("kind", kind)
                         .number("x", x)
                         .number("y", y)
                         .text("text", text)
                         .json());
}

std::string Chart::numbers() const {
    constexpr std::array samples{"line", "band", "dot"};
    std::vector<std::string> names;
    for (const Name& name : names_) {
        names.push_back(page_scripts::JsonObject{}
                            .text("of", name.series)
                            .text("name", name.name)
                            .text("sample", samples[static_cast<std::size_t>(name.sample)])
                            .json());
    }
    std::vector<std::string> letters;
    for (const EndLetter& letter : end_letters_) {
        letters.push_back(
            page_scripts::JsonObject{}.number("y", letter.value).text("text", letter.letter).json());
    }
    using page_scripts::json_array;
    return page_scripts::JsonObject{}
        .text("title", title_)
        .add("x", json_of(x_))
        .add("y", json_of(y_))
        .add("parts", json_array(parts_))
        .add("notes", json_array(notes_))
        .add("letters", json_array(letters))
        .add("names", json_array(names))
        .json();
}

std::string Chart::figure(const std::string& caption) const {
    const bool fit = names_fit();
    return filled_template(
        "chart.html",
        {{"title", title_},
         {"names", fit ? "" : list_of_names()},
         {"view", fit ? "0 0 430 310" : "0 18 430 292"},  // without names it begins lower
         {"drawing", joined(axes(), drawing_, marks_, mark_names(), end_letters(), fit ? names() : "")},
         {"numbers", numbers()},
         {"has_caption", !caption.empty()},
         {"caption", caption}});
}

}  // namespace coupling::report
