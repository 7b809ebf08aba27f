#include "coupling/assessments/vary/report/tornado.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::vary::report {
namespace {

using config::joined;
using coupling::report::element;
using coupling::report::page_text;
using coupling::report::place;

constexpr double width = 760.0;
constexpr double names_end = 300.0;
constexpr double right = 700.0;
constexpr double row_height = 34.0;
constexpr double top = 14.0;

std::string text(double x, double y, const char* anchor, const std::string& words) {
    return coupling::report::svg_text(x, y, words, {{"text-anchor", anchor}});
}

std::string upright(double x, double y1, double y2, const char* style) {
    return coupling::report::svg_path(style, joined("M", place(x), " ", place(y1), "V", place(y2)));
}

}  // namespace

std::vector<Sway> sways_of(const std::vector<Factor>& factors, const std::vector<Answer>& answers) {
    const double base = answers.front().value;
    std::vector<Sway> sways;
    if (std::isnan(base)) {
        return sways;
    }
    for (std::size_t i = 0; i < factors.size(); ++i) {
        if (factors[i].crossed) {
            continue;
        }
        Sway sway{factors[i].setting, "", "", base, base};
        for (const Answer& moved : answers) {
            if (moved.combination.alone != factors[i].setting || std::isnan(moved.value)) {
                continue;
            }
            if (moved.value < sway.low) {
                sway.low = moved.value;
                sway.low_value = moved.combination.values[i];
            }
            if (moved.value > sway.high) {
                sway.high = moved.value;
                sway.high_value = moved.combination.values[i];
            }
        }
        sways.push_back(std::move(sway));
    }
    std::stable_sort(sways.begin(), sways.end(),
                     [](const Sway& a, const Sway& b) { return a.width() > b.width(); });
    return sways;
}

std::string tornado(const std::vector<Sway>& sways, double answer, const std::string& axis_title) {
    double low = answer;
    double high = answer;
    for (const Sway& sway : sways) {
        low = std::min(low, sway.low);
        high = std::max(high, sway.high);
    }
    const double margin = std::max(0.15 * (high - low), 0.005);
    const coupling::report::Axis axis{axis_title, 100.0 * (low - margin), 100.0 * (high + margin)};
    const auto x_of = [&](double share) {
        return names_end + axis.share_of(100.0 * share) * (right - names_end);
    };
    const double bottom = top + row_height * static_cast<double>(sways.size());
    std::string svg;
    for (const double tick : axis.ticks()) {
        const double x = x_of(0.01 * tick);
        svg += joined(upright(x, top, bottom, "grid"), text(x, bottom + 18.0, "middle", axis.label(tick)));
    }
    svg += text(0.5 * (names_end + right), bottom + 40.0, "middle", axis.title);
    for (std::size_t i = 0; i < sways.size(); ++i) {
        const Sway& sway = sways[i];
        const double y = top + row_height * static_cast<double>(i);
        svg += element("rect", {{"class", "sway"},
                                {"x", x_of(sway.low)},
                                {"y", y + 6.0},
                                {"width", std::max(x_of(sway.high) - x_of(sway.low), 1.0)},
                                {"height", row_height - 12.0}});
        svg += text(0.0, y + 22.0, "start", sway.setting);
        if (sway.width() == 0.0) {
            svg += text(x_of(answer) + 8.0, y + 22.0, "start", page_text("changes nothing here"));
            continue;
        }
        svg += text(x_of(sway.low) - 5.0, y + 22.0, "end", sway.low_value);
        svg += text(x_of(sway.high) + 5.0, y + 22.0, "start", sway.high_value);
    }
    svg += upright(x_of(answer), top - 6.0, bottom, "base");
    return element("svg",
                   {{"viewBox", joined("0 0 ", place(width), " ", place(bottom + 48.0))},
                    {"role", "img"},
                    {"class", "tornado"}},
                   svg);
}

}  // namespace coupling::vary::report
