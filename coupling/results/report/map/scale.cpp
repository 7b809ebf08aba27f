#include "coupling/results/report/map/scale.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/report/map/energy_classes.hpp"
#include "coupling/results/tables/text_layout.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::joined;

constexpr int ramp_steps = 64;

std::string colour_field(double x, double y, double width, std::string_view fill) {
    return element("rect", {{"x", x},
                            {"y", y},
                            {"width", width},
                            {"height", 14.0},
                            {"fill", fill},
                            {"stroke", "#555"},
                            {"stroke-width", 0.5}});
}

std::string legend_drawing(std::string_view style, double height, std::string_view content) {
    return element("svg",
                   {{"class", style},
                    {"viewBox", joined("0 0 400 ", place(height))},
                    {"role", "img"},
                    {"aria-label", page_text("legend")}},
                   content);
}

std::string class_legend(const std::vector<ClassColour>& classes) {
    return class_legend_of(
        classes.size(), classes.size() > 4 ? 2 : std::max<std::size_t>(3, classes.size()), "",
        [&](std::size_t i) {
            return LegendEntry{colour_field(0.0, -12.0, 26.0, to_hex(classes[i].colour)), classes[i].label};
        });
}

}  // namespace

std::string class_legend_of(std::size_t count, std::size_t a_row, const std::string& style,
                            const std::function<LegendEntry(std::size_t)>& entry_of) {
    constexpr double width = 396.0;
    constexpr double name_at = 31.0;
    constexpr double letter = 7.4;  // about that of the type of page.css
    std::vector<LegendEntry> entries;
    double widest = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        entries.push_back(entry_of(i));
        widest = std::max(widest, name_at + letter * static_cast<double>(width_of(entries.back().name)));
    }
    while (a_row > 1 && widest > width / static_cast<double>(a_row)) {
        --a_row;
    }
    const std::size_t rows = (count + a_row - 1) / a_row;
    const double apart = width / static_cast<double>(a_row);
    std::string svg;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string there = joined("translate(", place(4.0 + apart * static_cast<double>(i % a_row)),
                                         " ", place(18.0 + 26.0 * static_cast<double>(i / a_row)), ")");
        svg += element("g", {{"transform", there}},
                       joined(entries[i].sample, svg_text(name_at, 0.0, entries[i].name)));
    }
    return legend_drawing(joined("legend", style), 26.0 * static_cast<double>(rows), svg);
}

ColourScale::ColourScale(Kind kind, Palette palette, double low, double high, std::string unit)
    : kind_{kind}, palette_{palette}, low_{low}, high_{high}, unit_{std::move(unit)} {}

ColourScale ColourScale::energy_classes() {
    ColourScale scale{Kind::energy, Palette::deposits, 0.0, 0.0, "kJ"};
    for (std::size_t i = 0; i < energy_class_colours.size(); ++i) {
        scale.classes_.push_back({static_cast<double>(i), energy_class_name(i), energy_class_colours[i]});
    }
    return scale;
}

ColourScale ColourScale::classes(std::vector<ClassColour> classes) {
    ColourScale scale{Kind::classes, Palette::deposits, 0.0, 0.0, ""};
    scale.classes_ = std::move(classes);
    return scale;
}

ColourScale ColourScale::linear(Palette palette, double high, std::string unit) {
    return {Kind::linear, palette, 0.0, nice_step(high > 0.0 ? high : 1.0), std::move(unit)};
}

ColourScale ColourScale::logarithmic(Palette palette, double low, double high, std::string unit) {
    return {Kind::logarithmic, palette, low, nice_step(std::max(high, 10.0 * low)), std::move(unit)};
}

ColourScale ColourScale::difference(double reach, std::string unit) {
    const double round_reach = nice_step(reach > 0.0 ? reach : 1.0);
    return {Kind::difference, Palette::difference, -round_reach, round_reach, std::move(unit)};
}

double ColourScale::place_of(double value) const {
    const double share = kind_ == Kind::logarithmic
                             ? std::log(std::max(value, low_) / low_) / std::log(high_ / low_)
                             : (value - low_) / (high_ - low_);
    return std::clamp(share, 0.0, 1.0);
}

std::uint8_t ColourScale::index_of(float value) const {
    if (std::isnan(value)) {
        return 0;
    }
    if (kind_ == Kind::energy) {
        return static_cast<std::uint8_t>(1 + energy_class(static_cast<double>(value)));
    }
    if (kind_ == Kind::classes) {
        const auto found = std::find_if(classes_.begin(), classes_.end(), [&](const ClassColour& entry) {
            return entry.value == static_cast<double>(value);
        });
        return found == classes_.end() ? std::uint8_t{0}
                                       : static_cast<std::uint8_t>(1 + (found - classes_.begin()));
    }
    return static_cast<std::uint8_t>(1 +
                                     std::lround(place_of(static_cast<double>(value)) * (ramp_steps - 1)));
}

std::vector<Colour> ColourScale::palette() const {
    std::vector<Colour> colours{Colour{255, 255, 255}};
    if (!classes_.empty()) {
        for (const ClassColour& entry : classes_) {
            colours.push_back(entry.colour);
        }
        return colours;
    }
    for (int i = 0; i < ramp_steps; ++i) {
        colours.push_back(colour_at(palette_, static_cast<double>(i) / (ramp_steps - 1)));
    }
    return colours;
}

std::vector<double> ColourScale::ticks() const {
    std::vector<double> values;
    if (kind_ == Kind::logarithmic) {
        for (double tick = std::pow(10.0, std::ceil(std::log10(low_) - 1e-9)); tick <= high_ * 1.0001;
             tick *= 10.0) {
            values.push_back(tick);
        }
        if (place_of(values.back()) < 0.85) {
            values.push_back(high_);
        }
        return values;
    }
    const int parts = kind_ == Kind::difference ? 4 : 5;
    for (int i = 0; i <= parts; ++i) {
        values.push_back(low_ + (high_ - low_) * i / parts);
    }
    return values;
}

std::string ColourScale::legend(const std::string& id) const {
    if (!classes_.empty()) {
        return class_legend(classes_);
    }
    constexpr double left = 26.0;
    constexpr double width = 310.0;
    std::string stops;
    const auto colours = colours_of(palette_);
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(colours.size() - 1);
        stops += element("stop",
                         {{"offset", joined(place(100.0 * share), "%")}, {"stop-color", to_hex(colours[i])}});
    }
    std::string svg = joined(element("linearGradient", {{"id", id}}, stops),
                             colour_field(left, 6.0, width, joined("url(#", id, ")")));
    for (const double tick : ticks()) {
        const double x = left + width * place_of(tick);
        const std::string sign = kind_ == Kind::difference && tick > 0.0 ? "+" : "";
        svg += svg_path("tick", joined("M", place(x), " 20v4"));
        svg += svg_text(x, 37.0, joined(sign, tick_text(tick)),
                        {{"class", "axis-number"}, {"text-anchor", "middle"}});
    }
    return legend_drawing("legend", 44.0,
                          joined(svg, svg_text(344.0, 18.0, translated(unit_).value_or(unit_))));
}

}  // namespace coupling::report
