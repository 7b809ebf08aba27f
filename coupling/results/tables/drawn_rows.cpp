#include "coupling/results/tables/drawn_rows.hpp"

#include <algorithm>
#include <cmath>

#include "config/units/constants.hpp"

namespace coupling {
namespace {

constexpr const char* by_strata = "random-effects estimate over the strata of rocks";

/// A factor of a stratum of rocks.
struct DrawRow {
    std::size_t stratum;
    const ParameterDraws::Component& component;
    double factor;
};

TableOf<DrawRow> draw_table() {
    constexpr const char* from_widths = "run.parameters, else the shipped widths";
    return {"parameter_draws.csv",
            "What was drawn for each stratum of rocks: factors on the laws of the fall.",
            "a parameter of a stratum",
            {{"stratum", "number of the stratum", "definition", &DrawRow::stratum},
             {"parameter", "what is not known, as in parameter_widths", "definition",
              [](const auto& row) { return row.component.parameter; }},
             {"width", "-", 4, "standard deviation of ln(factor)", from_widths,
              [](const auto& row) { return row.component.width; }},
             {"goes_with", "the parameter with which it is correlated; empty: none, or a joint sample",
              from_widths, [](const auto& row) { return row.component.goes_with; }},
             {"correlation", "-", 4, "of the logarithms of the two; 0: independent", from_widths,
              [](const auto& row) { return row.component.correlation; }},
             {"factor", "-", 6, "the factor of the stratum", "Latin hypercube, keyed by the seed",
              &DrawRow::factor}}};
}

}  // namespace

std::optional<DrawnRow> drawn_row(const char* quantity, const char* unit, double factor,
                                  const std::optional<DrawnFigure>& figure, const ParameterDraws& draws) {
    if (!figure) {
        return std::nullopt;
    }
    const auto first = std::max_element(figure->shares.begin(), figure->shares.end());
    const bool has_first = first != figure->shares.end() && *first > 0.0;
    const auto place = static_cast<std::size_t>(first - figure->shares.begin());
    return DrawnRow{quantity,
                    unit,
                    factor,
                    &*figure,
                    has_first ? draws.components[place].parameter : "",
                    has_first ? *first : 0.0};
}

ColumnsOf<DrawnRow> drawn_columns(const char* quantities) {
    return {
        {"quantity", quantities, &DrawnRow::quantity},
        {"unit", "unit of the figure: %, kJ, m or m/s", "definition", &DrawnRow::of_unit},
        {"value", "as the row says", 4, "the figure over all rocks", from_simulation,
         [](const auto& row) { return row.factor * row.figure->value; }},
        {"rocks_low", "as the row says", 4, "lower end of its 95 % interval by the chance of the rocks alone",
         "as in targets.csv", [](const auto& row) { return row.factor * row.figure->of_rocks.low; }},
        {"rocks_high", "as the row says", 4,
         "upper end of its 95 % interval by the chance of the rocks alone", "as in targets.csv",
         [](const auto& row) { return row.factor * row.figure->of_rocks.high; }},
        {"all_low", "as the row says", 4, "lower end of its 95 % interval by rocks and parameters", by_strata,
         [](const auto& row) { return row.factor * row.figure->of_all.low; }},
        {"all_high", "as the row says", 4, "upper end of its 95 % interval by rocks and parameters",
         by_strata, [](const auto& row) { return row.factor * row.figure->of_all.high; }},
        {"all_is",
         "shown: by the spread that draws show; hidden: they show none, and it holds one that chance could "
         "hide. Without all_low the lower end is not known: the interval reaches 0, which no rock has",
         by_strata, [](const auto& row) { return row.figure->has_spread ? "shown" : "hidden"; }},
        {"first_parameter", "the parameter that brings most of the spread", by_strata,
         &DrawnRow::first_parameter},
        {"first_percent", 1, "its share of the spread that parameters bring", by_strata,
         [](const auto& row) { return config::percent * row.first_share; }}};
}

TableLayout draws_layout() {
    return draw_table();
}

WrittenFile write_draws(const ParameterDraws& draws, const std::filesystem::path& folder) {
    return draw_table().write(folder, [&](auto& rows) {
        for (std::size_t stratum = 0; stratum < draws.factors.size(); ++stratum) {
            for (std::size_t i = 0; i < draws.components.size(); ++i) {
                rows.add({stratum, draws.components[i], draws.factors[stratum][i]});
            }
        }
    });
}

}  // namespace coupling
