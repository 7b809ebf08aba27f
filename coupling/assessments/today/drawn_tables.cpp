#include "coupling/assessments/today/drawn_tables.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "config/units/constants.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling {
namespace {

using config::percent;

/// A figure with both intervals.
struct IntervalRow {
    std::string target_id;  ///< "" of all rocks of a slope
    std::string cover;
    const char* quantity;
    const char* of_unit;
    double factor;
    const DrawnFigure& figure;
    std::string first_parameter;
    double first_share;
};

constexpr const char* by_strata = "random-effects estimate over the strata of rocks";

TableOf<IntervalRow> interval_table() {
    return {
        "intervals.csv",
        "Main figures with two 95 % intervals: of the rocks alone, and of all that is not known.",
        "a figure of a target, or of all rocks of a slope",
        {{"target_id", "short name of the target; empty: all rocks", "input targets.file",
          &IntervalRow::target_id},
         {cover_column(), [](const auto& row) { return row.cover; }},
         {"quantity", "reached, energy_mean, energy_95, height_95, protection, run_out_mean or run_out_95",
          &IntervalRow::quantity},
         {"unit", "unit of the figure: %, kJ or m", "definition", &IntervalRow::of_unit},
         {"value", "as the row says", 4, "the figure over all rocks", from_simulation,
          [](const auto& row) { return row.factor * row.figure.value; }},
         {"rocks_low", "as the row says", 4,
          "lower end of its 95 % interval by the chance of the rocks alone", "as in targets.csv",
          [](const auto& row) { return row.factor * row.figure.of_rocks.low; }},
         {"rocks_high", "as the row says", 4,
          "upper end of its 95 % interval by the chance of the rocks alone", "as in targets.csv",
          [](const auto& row) { return row.factor * row.figure.of_rocks.high; }},
         {"all_low", "as the row says", 4, "lower end of its 95 % interval by rocks and parameters",
          by_strata, [](const auto& row) { return row.factor * row.figure.of_all.low; }},
         {"all_high", "as the row says", 4, "upper end of its 95 % interval by rocks and parameters",
          by_strata, [](const auto& row) { return row.factor * row.figure.of_all.high; }},
         {"first_parameter", "the parameter that brings most of the spread", by_strata,
          &IntervalRow::first_parameter},
         {"first_percent", 1, "its share of the spread that parameters bring", by_strata,
          [](const auto& row) { return percent * row.first_share; }}}};
}

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
             {"factor", "-", 6, "the factor of the stratum", "Latin hypercube, keyed by the seed",
              &DrawRow::factor}}};
}

class IntervalRows {
public:
    explicit IntervalRows(const RunResults& results) : draws_{*results.draws} {}

    void add(auto& rows, const std::string& target, const std::string& cover, const char* quantity,
             const char* unit, double factor, const std::optional<DrawnFigure>& figure) const {
        if (!figure) {
            return;
        }
        const auto first = std::max_element(figure->shares.begin(), figure->shares.end());
        const bool has_first = first != figure->shares.end() && *first > 0.0;
        const auto place = static_cast<std::size_t>(first - figure->shares.begin());
        rows.add({target, cover, quantity, unit, factor, *figure,
                  has_first ? draws_.components[place].parameter : "", has_first ? *first : 0.0});
    }

private:
    const ParameterDraws& draws_;
};

void add_intervals(auto& rows, const RunResults& results, const DrawnFigures& drawn) {
    const IntervalRows add_row{results};
    for (std::size_t i = 0; i < drawn.targets.size(); ++i) {
        const std::string& id = results.site.targets[i].id;
        for (const Cover cover : covers_of(results)) {
            const DrawnArrivals& at = drawn.targets[i].by_cover[index_of(cover)];
            add_row.add(rows, id, name_of(cover), "reached", "%", percent, at.share);
            add_row.add(rows, id, name_of(cover), "energy_mean", "kJ", 1.0, at.energy_mean_kj);
            add_row.add(rows, id, name_of(cover), "energy_95", "kJ", 1.0, at.energy_95_kj);
            add_row.add(rows, id, name_of(cover), "height_95", "m", 1.0, at.height_95_m);
        }
        add_row.add(rows, id, name_of(Cover::forest), "protection", "%", percent,
                    drawn.targets[i].protection);
    }
    for (const Cover cover : covers_of(results)) {
        const DrawnRunOut& run_out = drawn.run_outs[index_of(cover)];
        add_row.add(rows, "", name_of(cover), "run_out_mean", "m", 1.0, run_out.mean_m);
        add_row.add(rows, "", name_of(cover), "run_out_95", "m", 1.0, run_out.p95_m);
    }
}

}  // namespace

std::vector<WrittenFile> write_drawn(const RunResults& results, const Figures& figures,
                                     const std::filesystem::path& folder) {
    if (!figures.drawn) {
        return {};
    }
    return {interval_table().write(folder, [&](auto& rows) { add_intervals(rows, results, *figures.drawn); }),
            draw_table().write(folder, [&](auto& rows) {
                for (std::size_t stratum = 0; stratum < results.draws->factors.size(); ++stratum) {
                    for (std::size_t i = 0; i < results.draws->components.size(); ++i) {
                        rows.add({stratum, results.draws->components[i], results.draws->factors[stratum][i]});
                    }
                }
            })};
}

std::vector<TableLayout> drawn_layouts() {
    return {interval_table(), draw_table()};
}

}  // namespace coupling
