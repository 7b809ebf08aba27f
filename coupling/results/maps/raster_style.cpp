#include "coupling/results/maps/raster_style.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "config/text/numbers.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/messages.hpp"

namespace coupling {
namespace {

using report::element;

struct Step {
    double value;
    std::string label;
    Colour colour;
    int alpha = 255;
};

/// Three digits are enough for a legend.
std::string short_text(double value) {
    if (value == 0.0) {
        return "0";
    }
    const double power = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
    return config::to_text(static_cast<float>(std::round(value / power) * power));
}

void write(std::ostream& out, const std::vector<Step>& steps, const char* kind, double low, double high) {
    std::string items = "\n";
    for (const Step& step : steps) {
        items += element("item", {{"value", std::isinf(step.value) ? "inf" : config::to_text(step.value)},
                                  {"label", step.label},
                                  {"color", to_hex(step.colour)},
                                  {"alpha", std::to_string(step.alpha)}});
        items += '\n';
    }
    const std::string ramp = element(
        "colorrampshader", {{"colorRampType", kind}, {"classificationMode", "1"}, {"clip", "0"}}, items);
    const std::string renderer = element("rasterrenderer",
                                         {{"type", "singlebandpseudocolor"},
                                          {"band", "1"},
                                          {"opacity", "0.8"},
                                          {"alphaBand", "-1"},
                                          {"classificationMin", config::to_text(low)},
                                          {"classificationMax", config::to_text(high)}},
                                         element("rastershader", {}, ramp));
    out << "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
        << element("qgis", {{"version", "3.22"}, {"styleCategories", "AllStyleCategories"}},
                   element("pipe", {}, renderer))
        << '\n';
}

std::string labelled(double value, std::string_view unit) {
    std::string label = short_text(value);
    return label.append(" ").append(report::message_text(unit));
}

std::vector<Step> ramp(const RasterKind& kind, double low, double high, Palette palette, bool logarithmic) {
    const std::size_t count = colours_of(palette).size();
    std::vector<Step> steps;
    if (logarithmic) {
        steps.push_back(
            {0.0, labelled(0.0, kind.unit), colours_of(palette).front(), 0});  // none: see-through
    }
    for (std::size_t i = 0; i < count; ++i) {
        const double place = static_cast<double>(i) / static_cast<double>(count - 1);
        const double value = logarithmic ? low * std::pow(high / low, place) : low + place * (high - low);
        steps.push_back({value, labelled(value, kind.unit), colours_of(palette)[i]});
    }
    return steps;
}

}  // namespace

void write_style(std::ostream& out, const RasterKind& kind, ValueRange range) {
    const double high = range.high > 0.0F ? static_cast<double>(range.high) : 1.0;
    switch (kind.style) {
        case RasterStyle::energy_classes: {
            std::vector<Step> steps;
            for (std::size_t i = 0; i < intensity_class_colours.size(); ++i) {
                const bool last = i == intensity_limits_kj.size();
                std::string label = report::message_text(intensity_class_names[i]);
                steps.push_back({last ? std::numeric_limits<double>::infinity() : intensity_limits_kj[i],
                                 label, intensity_class_colours[i]});
            }
            write(out, steps, "DISCRETE", 0.0, high);
            break;
        }
        case RasterStyle::logarithmic:
            write(out, ramp(kind, 1.0, std::max(high, 10.0), kind.palette, true), "INTERPOLATED", 1.0,
                  std::max(high, 10.0));
            break;
        case RasterStyle::linear:
            write(out, ramp(kind, 0.0, high, kind.palette, false), "INTERPOLATED", 0.0, high);
            break;
    }
}

void write_class_style(std::ostream& out, std::span<const ClassColour> classes) {
    std::vector<Step> steps;
    for (const ClassColour& entry : classes) {
        steps.push_back({entry.value, report::message_text(entry.label), entry.colour});
    }
    write(out, steps, "DISCRETE", steps.front().value, steps.back().value);
}

void write_difference_style(std::ostream& out, const RasterKind& kind, ValueRange range) {
    const auto widest = static_cast<double>(std::max(std::abs(range.low), std::abs(range.high)));
    const double reach = widest > 0.0 ? widest : 1.0;
    write(out, ramp(kind, -reach, reach, Palette::difference, false), "INTERPOLATED", -reach, reach);
}

}  // namespace coupling
