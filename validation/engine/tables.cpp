#include "validation/engine/tables.hpp"

#include "validation/engine/kinds/model_verdicts.hpp"
#include "validation/engine/kinds/verdict.hpp"
#include "validation/engine/table_columns.hpp"

namespace coupling::validation {

std::string_view word_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::inside:
            return "inside";
        case Verdict::missed:
            return "missed";
        case Verdict::no_criterion:
            break;
    }
    return "";
}

ColumnsOf<OfCase> case_columns() {
    return {{"case", "name of the case", from_case, [](const auto& row) { return row.result.name; }}};
}

ColumnsOf<OfVariant> variant_columns() {
    return {case_columns(),
            {"variant", "set of settings: strict, default, ...", from_case,
             [](const auto& row) { return row.variant.variant; }}};
}

namespace {

/// A figure over all rocks, and its mean and scatter between small series, behind a prefix.
ColumnsOf<Value> value_columns(const std::string& name, const std::string& prefix) {
    return {{name, of_quantity, table_decimals, "value over all rocks", from_simulation, &Value::value},
            {prefix + "series_mean", of_quantity, table_decimals,
             "mean over small series, as the experiment has them", from_series, &Value::series},
            {prefix + "series_deviation", of_quantity, table_decimals, "standard deviation between them",
             from_series, &Value::deviation}};
}

struct JudgedFigure : OfCase {
    const VerdictRow& row;
};

const TableOf<JudgedFigure>& verdict_table() {
    static const ColumnsOf<VerdictRow> judged{
        {"quantity", "name of the figure", from_case, &VerdictRow::quantity},
        {"label", "the figure in words", from_case, &VerdictRow::label},
        {"unit", "its unit", from_case, &VerdictRow::unit},
        {"observed", of_quantity, table_decimals, "what was observed", from_case, &VerdictRow::observed},
        {"observed_source", "where that stands", from_case, &VerdictRow::observed_source},
        {"published", of_quantity, table_decimals, "what a published simulation has", from_case,
         &VerdictRow::published},
        {"published_deviation", of_quantity, table_decimals, "its standard deviation", from_case,
         &VerdictRow::published_deviation},
        {"published_source", "where that stands", from_case, &VerdictRow::published_source},
        {value_columns("strict", "strict_"), &VerdictRow::strict_value},
        {value_columns("default", "default_"), &VerdictRow::default_value},
        {"low", of_quantity, table_decimals, "least value of the criterion; empty: none", from_case,
         &VerdictRow::low},
        {"high", of_quantity, table_decimals, "largest value of the criterion; empty: none", from_case,
         &VerdictRow::high},
        {"rests_on", "independent, or rebuilding: of what was rebuilt for the case", from_case,
         &VerdictRow::rests_on},
        {"rule", "where the criterion comes from", from_case, &VerdictRow::rule},
        {"strict_verdict", "inside or missed; empty: no criterion", from_criterion,
         [](const auto& row) { return word_of(row.strict_verdict); }},
        {"default_verdict", "inside or missed; empty: no criterion", from_criterion,
         [](const auto& row) { return word_of(row.default_verdict); }},
        {"cause", "likely cause of a miss", from_case, &VerdictRow::cause},
        {"strict_scatter", of_quantity, table_decimals, "value of the variant strict_scatter",
         from_simulation, [](const auto& row) {
             return row.scatter_value ? std::optional{row.scatter_value->value} : std::nullopt;
         }}};
    static const TableOf<JudgedFigure> table{
        "verdicts.csv",
        "every figure beside observed and published, with its criterion",
        "a figure of a case",
        {case_columns(), {judged, [](const JudgedFigure& row) -> const VerdictRow& { return row.row; }}}};
    return table;
}

struct FigureRow : OfVariant {
    const std::string& quantity;
    const Value& value;
};

const TableOf<FigureRow>& figure_table() {
    static const TableOf<FigureRow> table{
        "figures.csv",
        "every figure of every variant",
        "a figure of a case with a set of settings",
        {variant_columns(),
         {"quantity", "name of the figure", from_case, [](const auto& row) { return row.quantity; }},
         {value_columns("value", ""), [](const FigureRow& row) -> const Value& { return row.value; }}}};
    return table;
}

struct PlotPoint : OfCase {
    const PlotGroup& group;
    const Plot& plot;
    const PlotSeries& series;
    double x, y, y_low;
};

const TableOf<PlotPoint>& plot_table() {
    static const TableOf<PlotPoint> table{
        "plots.csv",
        "the points of the plots",
        "a point of a plot",
        {case_columns(),
         {"group", "heading over the plot", from_case, [](const auto& row) { return row.group.title; }},
         {"plot", "its title", from_case, [](const auto& row) { return row.plot.title; }},
         {"x_title", "what x is", from_case, [](const auto& row) { return row.plot.x.title; }},
         {"y_title", "what y is", from_case, [](const auto& row) { return row.plot.y.title; }},
         {"series", "name of the series", from_case, [](const auto& row) { return row.series.name; }},
         {"x", "as x_title says", table_decimals, "place along x", from_simulation, &PlotPoint::x},
         {"y", "as y_title says", table_decimals, "value, or upper end of a range", from_simulation,
          &PlotPoint::y},
         {"y_low", "as y_title says", table_decimals, "lower end of a range; empty: a point", from_simulation,
          &PlotPoint::y_low}}};
    return table;
}

struct MovedFigure : OfCase {
    const ChoiceOutcome& choice;
    const VerdictRow& row;

    /// Value of the figure under the moved choice.
    [[nodiscard]] double in(const Values& values) const {
        const auto found = values.find(row.quantity);
        return found != values.end() ? found->second.value : no_entry;
    }
    [[nodiscard]] std::string_view verdict(const Values& values) const {
        return row.low && row.high ? word_of(verdict_of(in(values), {*row.low, *row.high, {}, {}, {}})) : "";
    }
};

struct JudgedModel : OfCase {
    const ModelVerdict& of;
};

const TableOf<JudgedModel>& model_table() {
    const ColumnsOf<QuantityVerdict> counts{
        {"quantity", "what the model is asked for, such as stops or speed", "definition",
         &QuantityVerdict::quantity},
        {"met", "criteria that it meets with its default settings", from_criterion, &QuantityVerdict::met},
        {"missed", "criteria that it misses", from_criterion, &QuantityVerdict::missed},
        {"independent_met", "of those met: nothing was fitted to them or rebuilt with them", from_criterion,
         &QuantityVerdict::independent_met},
        {"independent_missed", "the same of those missed", from_criterion,
         &QuantityVerdict::independent_missed}};
    static const TableOf<JudgedModel> table{
        "models.csv",
        "which motion model meets what",
        "a case, a motion model and a quantity that the case judges",
        {case_columns(),
         {"model", "motion model", "definition", [](const auto& row) { return row.of.model; }},
         {counts, [](const JudgedModel& row) -> const QuantityVerdict& { return row.of.verdict; }}}};
    return table;
}

const TableOf<MovedFigure>& choice_table() {
    static const TableOf<MovedFigure> table{
        "choices.csv",
        "the same figures under every moved choice",
        "a figure of a case under a moved choice",
        {case_columns(),
         {"choice", "what was moved", from_case, [](const auto& row) { return row.choice.choice; }},
         {"overrides", "the settings of it", from_case, [](const auto& row) { return row.choice.overrides; }},
         {"reason", "why it is a choice", from_case, [](const auto& row) { return row.choice.reason; }},
         {"quantity", "name of the figure", from_case, [](const auto& row) { return row.row.quantity; }},
         {"unit", "its unit", from_case, [](const auto& row) { return row.row.unit; }},
         {"low", of_quantity, table_decimals, "least value of the criterion", from_case,
          [](const auto& row) { return row.row.low; }},
         {"high", of_quantity, table_decimals, "largest value of the criterion", from_case,
          [](const auto& row) { return row.row.high; }},
         {"strict", of_quantity, table_decimals, "value with strict settings", from_simulation,
          [](const auto& row) { return row.in(row.choice.strict_values); }},
         {"strict_verdict", "inside or missed; empty: no criterion", from_criterion,
          [](const auto& row) { return row.verdict(row.choice.strict_values); }},
         {"default", of_quantity, table_decimals, "value with default settings", from_simulation,
          [](const auto& row) { return row.in(row.choice.default_values); }},
         {"default_verdict", "inside or missed; empty: no criterion", from_criterion,
          [](const auto& row) { return row.verdict(row.choice.default_values); }}}};
    return table;
}

void add_plots(auto& rows, const CaseResult& result) {
    for (const PlotGroup& group : result.plots) {
        for (const Plot& plot : group.plots) {
            for (const PlotSeries& series : plot.series) {
                for (const report::ChartPoint& point : series.points) {
                    rows.add({{result}, group, plot, series, point.x, point.y, no_entry});
                }
                for (const report::ChartRange& range : series.ranges) {
                    rows.add({{result}, group, plot, series, range.x, range.high, range.low});
                }
            }
        }
    }
}

std::vector<ResultTable> judged_tables() {
    return {
        result_table(verdict_table(),
                     [](auto& rows, const CaseResult& result) {
                         for (const VerdictRow& row : result.rows) {
                             rows.add({{result}, row});
                         }
                     }),
        result_table(model_table(),
                     [](auto& rows, const CaseResult& result) {
                         for (const ModelVerdict& verdict : model_verdicts(result)) {
                             rows.add({{result}, verdict});
                         }
                     }),
        result_table(figure_table(),
                     [](auto& rows, const CaseResult& result) {
                         for (const VariantOutcome& variant : result.variants) {
                             for (const auto& [quantity, value] : variant.values) {
                                 rows.add({{{result}, variant}, quantity, value});
                             }
                         }
                     }),
        result_table(
            choice_table(),
            [](auto& rows, const CaseResult& result) {
                for (const ChoiceOutcome& choice : result.choices) {
                    for (const VerdictRow& row : result.rows) {
                        rows.add({{result}, choice, row});
                    }
                }
            },
            true),
    };
}

}  // namespace

const std::vector<ResultTable>& result_tables() {
    static const std::vector<ResultTable> tables =
        together(judged_tables(), slope_tables(),
                 std::vector{result_table(
                     plot_table(), [](auto& rows, const CaseResult& result) { add_plots(rows, result); })});
    return tables;
}

void write_table(std::ostream& out, std::string_view file, std::span<const CaseResult> cases) {
    for (const ResultTable& table : result_tables()) {
        if (table.layout->file == file) {
            table.write(out, cases);
        }
    }
}

}  // namespace coupling::validation
