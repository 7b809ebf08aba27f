#include "coupling/results/figures/drawn_words.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"

namespace coupling {

using config::joined;

std::string name_of(const ParameterDraws::Component& component) {
    using report::page_text;
    if (!component.ground.empty()) {
        return page_text("losses on {ground}", {{"ground", report::in_page_language(component.ground)}});
    }
    if (component.parameter == "losses") {
        return page_text("losses on all grounds");
    }
    if (component.parameter == "friction") {
        return page_text("friction of rolling and sliding");
    }
    if (component.parameter == "stopping") {
        return page_text("stop probabilities");
    }
    if (component.parameter == "jump_angle") {
        return page_text("jump angle");
    }
    if (component.parameter == "sideways") {
        return page_text("turn sideways");
    }
    if (component.parameter == "block_size") {
        return page_text("block sizes");
    }
    return page_text("energy that trees take");
}

std::vector<NamedShare> main_causes(const DrawnFigure& figure, const ParameterDraws& draws) {
    constexpr double least_share = 0.05;
    constexpr std::size_t most_causes = 4;
    std::vector<NamedShare> causes;
    for (std::size_t i = 0; i < figure.shares.size(); ++i) {
        if (figure.shares[i] >= least_share) {
            causes.push_back({name_of(draws.components[i]), figure.shares[i]});
        }
    }
    std::stable_sort(causes.begin(), causes.end(),
                     [](const NamedShare& a, const NamedShare& b) { return a.share > b.share; });
    causes.resize(std::min(causes.size(), most_causes));
    return causes;
}

std::string spread_in_words(const DrawnFigure& figure) {
    const std::string hidden =
        figure.has_spread
            ? ""
            : report::page_text("draws show no spread; the interval holds one that chance could hide");
    const std::string low =
        std::isnan(figure.of_all.low)
            ? report::page_text("the lower end is not known: the interval reaches 0, which no rock has")
            : "";
    return report::join_with_semicolons({hidden, low});
}

std::string main_causes_in_words(const DrawnFigure& figure, const ParameterDraws& draws) {
    std::string words;
    for (const auto& [name, share] : main_causes(figure, draws)) {
        words += joined(words.empty() ? "" : ", ", name, " ", report::fixed(100.0 * share, 0), "\u00a0%");
    }
    return words;
}

}  // namespace coupling
