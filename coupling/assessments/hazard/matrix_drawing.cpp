#include "coupling/assessments/hazard/matrix_drawing.hpp"

#include <algorithm>

#include "coupling/assessments/hazard/hazard_colours.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::hazard {

using report::message_text;

std::string matrix_drawing(const HazardResults& results) {
    constexpr double left = 120.0;
    constexpr double width = 150.0;
    constexpr double height = 40.0;
    constexpr double least_width = 1000.0;  // so that the lettering is that of the text around it
    const Matrix& matrix = results.matrix;
    const auto rows = static_cast<double>(matrix.intensities());
    std::string svg;
    const auto text = [&](double x, double y, const char* anchor, const std::string& words) {
        svg += report::svg_text(x, y, words, {{"font-size", "13"}, {"text-anchor", anchor}});
    };
    for (std::size_t i = 0; i < matrix.intensities(); ++i) {
        const double y = height * (rows - 1.0 - static_cast<double>(i));
        text(left - 8.0, y + 0.6 * height, "end", message_text(matrix.intensity_name(i)));
        for (std::size_t k = 0; k < matrix.frequencies(); ++k) {
            const Level level = matrix.at(i, k);
            const Colour colour = level_colours()[static_cast<std::size_t>(level)].colour;
            const double x = left + width * static_cast<double>(k);
            svg += report::element("rect", {{"x", x},
                                            {"y", y},
                                            {"width", width},
                                            {"height", height},
                                            {"fill", to_hex(colour)},
                                            {"stroke", "#555"}});
            svg += report::svg_text(x + 0.5 * width, y + 0.6 * height, message_text(level_name(level)),
                                    {{"font-size", "14"},
                                     {"font-weight", "600"},
                                     {"text-anchor", "middle"},
                                     {"fill", luminance(colour) < 0.3 ? "#fff" : "#111"}});
        }
    }
    for (std::size_t k = 0; k < matrix.frequencies(); ++k) {
        const double x = left + width * (static_cast<double>(k) + 0.5);
        text(x, height * rows + 18.0, "middle", message_text(matrix.frequency_name(k)));
        if (results.scenario.hazard.rule != HazardRule::release) {
            continue;  // the return periods of places are many
        }
        std::vector<std::string> here;
        for (const FinishedPeriod& period : results.periods) {
            if (matrix.frequency_of(period.return_period_years) == k) {
                here.push_back(report::exact(period.return_period_years));
            }
        }
        text(x, height * rows + 38.0, "middle",
             here.empty() ? report::page_text("no rocks")
                          : report::page_text("rocks of {here}", {{"here", report::join_with_commas(here)}}));
    }
    return report::svg_drawing(
        std::max(least_width, left + width * static_cast<double>(matrix.frequencies())), height * rows + 52.0,
        report::page_text("hazard matrix"), svg);
}

}  // namespace coupling::hazard
