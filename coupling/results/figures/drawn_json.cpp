#include "coupling/results/figures/drawn_json.hpp"

#include <utility>

namespace coupling {

Json json_drawn(const std::optional<DrawnFigure>& figure, const ParameterDraws& draws, double factor) {
    if (!figure) {
        return nullptr;
    }
    Json causes = Json::object();
    for (std::size_t i = 0; i < figure->shares.size(); ++i) {
        causes[draws.components[i].parameter] = json_number(figure->shares[i]);
    }
    return {{"value", json_number(factor * figure->value)},
            {"interval_95_of_rocks", json_interval(figure->of_rocks, factor)},
            {"interval_95_of_all", json_interval(figure->of_all, factor)},
            {"shares_of_parameters", causes}};
}

Json json_draws(const ParameterDraws& draws) {
    Json parameters = Json::array();
    for (const ParameterDraws::Component& component : draws.components) {
        parameters.push_back({{"parameter", component.parameter}, {"width", json_number(component.width)}});
    }
    return {{"strata", draws.falls.size()}, {"parameters", std::move(parameters)}};
}

}  // namespace coupling
