#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "validation/engine/table_columns.hpp"

namespace coupling::validation {
namespace {

using config::joined;

constexpr double height_bin_m = 0.5;

/// A place or number along a distribution, by its index.
struct Bin : OfVariant {
    std::size_t number;

    [[nodiscard]] double from_m() const { return height_bin_m * static_cast<double>(number); }
};

/// Ends of what small series give.
ColumnsOf<Bin> series_columns(double (*low)(const Bin&), double (*high)(const Bin&)) {
    return {{"series_05", "-", table_decimals, "5th percentile over small series", from_series, low},
            {"series_95", "-", table_decimals, "95th percentile over small series", from_series, high}};
}

double height_or_none(const std::vector<CurvePoint>& curve, std::size_t number) {
    return number < curve.size() ? curve[number].y : no_entry;
}

const TableOf<Bin>& run_out_table() {
    static const TableOf<Bin> table{
        "run_out.csv",
        "share of rocks that get further than each distance",
        "a distance and a variant",
        {variant_columns(),
         {"distance_m", table_decimals, "in plan from the start", "definition",
          [](const auto& row) { return row.variant.run_out[row.number].x; }},
         {"share", table_decimals, "of the rocks that get further",
          [](const auto& row) { return row.variant.run_out[row.number].y; }},
         series_columns(
             [](const Bin& row) { return height_or_none(row.variant.run_out_low, row.number); },
             [](const Bin& row) { return height_or_none(row.variant.run_out_high, row.number); })}};
    return table;
}

struct JumpsOfVariant : OfVariant {
    const SegmentJumps& jumps;
};

const TableOf<JumpsOfVariant>& jump_table() {
    static const ColumnsOf<SegmentJumps> segment{
        {"part", "upper or lower half of the slope length", "definition",
         [](const auto& jumps) { return jumps.upper ? "upper" : "lower"; }},
        {"from_m", 1, "begin of the stretch, along the slope", "definition", &SegmentJumps::from_m},
        {"to_m", 1, "its end", "definition", &SegmentJumps::to_m},
        {"jumps", "jumps that end in it", from_simulation, &SegmentJumps::jumps},
        {"shortest_m", table_decimals, "shortest of them, from impact to impact", &SegmentJumps::shortest_m},
        {"mean_m", table_decimals, "their mean length", &SegmentJumps::mean_m},
        {"longest_m", table_decimals, "longest of them", &SegmentJumps::longest_m},
        {"deviation_m", table_decimals, "standard deviation of the lengths", &SegmentJumps::deviation_m},
        {"mean_height_m", table_decimals, "mean of the largest heights above the ground, vertical",
         &SegmentJumps::mean_height_m},
        {"highest_m", table_decimals, "largest of these", &SegmentJumps::highest_m}};
    static const TableOf<JumpsOfVariant> table{
        "jumps.csv",
        "lengths of jumps by 10 m of slope length",
        "a stretch of slope and a variant",
        {variant_columns(),
         {segment, [](const JumpsOfVariant& row) -> const SegmentJumps& { return row.jumps; }}}};
    return table;
}

double share_or_none(const std::vector<double>& shares, std::size_t number) {
    return number < shares.size() ? shares[number] : no_entry;
}

const TableOf<Bin>& tree_hit_table() {
    static const TableOf<Bin> table{
        "tree_hits.csv",
        "share of rocks by number of tree hits",
        "a number of hits and a variant",
        {variant_columns(),
         {"hits", "hits on trees of a rock", "definition", &Bin::number},
         {"share_of_rocks", table_decimals, "share of the rocks with so many",
          [](const auto& row) { return row.variant.tree_hits[row.number]; }},
         series_columns(
             [](const Bin& row) { return share_or_none(row.variant.tree_hits_low, row.number); },
             [](const Bin& row) { return share_or_none(row.variant.tree_hits_high, row.number); })}};
    return table;
}

const TableOf<Bin>& hit_height_table() {
    static const TableOf<Bin> table{
        "hit_heights.csv",
        "share of tree hits by height",
        "a class of height and a variant",
        {variant_columns(),
         {"from_m", 1, "lower end of the class, above the ground", "definition", &Bin::from_m},
         {"to_m", 1, "its upper end", "definition",
          [](const auto& row) { return row.from_m() + height_bin_m; }},
         {"share_of_hits", table_decimals, "share of the hits on trees in it",
          [](const auto& row) { return row.variant.hit_heights[row.number]; }}}};
    return table;
}

ColumnsOf<Estimate> interval_columns(const std::string& name, const char* meaning) {
    return {{name, of_quantity, table_decimals, meaning, from_simulation, &Estimate::value},
            {"low_95", of_quantity, table_decimals, "lower end of its 95 % interval", from_simulation,
             &Estimate::low},
            {"high_95", of_quantity, table_decimals, "upper end of its 95 % interval", from_simulation,
             &Estimate::high}};
}

struct FactorFigure : OfCase {
    const FactorRow& row;
    const std::string& figure;
    const Estimate& estimate;

    [[nodiscard]] std::string settings() const {
        std::string settings;
        for (std::size_t i = 0; i < row.settings.size(); ++i) {
            settings +=
                joined(i == 0 ? "" : " ", result.factor_settings[i], "=", config::to_text(row.settings[i]));
        }
        return settings;
    }
};

const TableOf<FactorFigure>& factor_table() {
    static const TableOf<FactorFigure> table{
        "factors.csv",
        "forest effects over combinations of settings",
        "a figure and a combination of settings",
        {case_columns(),
         {"variant", "strict or default", from_case, [](const auto& row) { return row.row.variant; }},
         {"settings", "the combination, section.key=value", from_case, &FactorFigure::settings},
         {"figure", "name of the figure", from_case, [](const auto& row) { return row.figure; }},
         {interval_columns("value", "its value"),
          [](const FactorFigure& row) -> const Estimate& { return row.estimate; }}}};
    return table;
}

struct DirectionOfCase : OfCase {
    const DirectionRow& row;
};

const TableOf<DirectionOfCase>& direction_table() {
    static const ColumnsOf<DirectionRow> direction{
        {"variant", "strict or default", from_case, &DirectionRow::variant},
        {"figure", "name of the figure", from_case, &DirectionRow::figure},
        {"setting", "what grows", from_case, &DirectionRow::setting},
        {"expected", "rises or falls, in the literature", from_case,
         [](const auto& row) { return row.rises ? "rises" : "falls"; }},
        {"source", "where that stands", from_case, &DirectionRow::source},
        {interval_columns("change", "change of the figure from the first step to the last"),
         &DirectionRow::change},
        {"steps_against", "steps that go the other way by more than their interval", from_simulation,
         &DirectionRow::steps_against},
        {"verdict", "inside or missed; empty: no criterion", from_criterion,
         [](const auto& row) { return word_of(row.verdict); }}};
    static const TableOf<DirectionOfCase> table{
        "directions.csv",
        "how figures go as settings grow, beside the literature",
        "a figure and a setting",
        {case_columns(),
         {direction, [](const DirectionOfCase& row) -> const DirectionRow& { return row.row; }}}};
    return table;
}

/// The same of rows by variant, a row for each of so many bins.
template <class Size>
ResultTable table_of_bins(const TableOf<Bin>& table, Size size) {
    return result_table(
        table,
        [size](auto& rows, const CaseResult& result) {
            for (const VariantOutcome& variant : result.variants) {
                for (std::size_t number = 0; number < size(variant); ++number) {
                    rows.add({{{result}, variant}, number});
                }
            }
        },
        true);
}

}  // namespace

std::vector<ResultTable> slope_tables() {
    return {
        table_of_bins(run_out_table(), [](const VariantOutcome& variant) { return variant.run_out.size(); }),
        result_table(
            jump_table(),
            [](auto& rows, const CaseResult& result) {
                for (const VariantOutcome& variant : result.variants) {
                    for (const SegmentJumps& segment : variant.jumps) {
                        rows.add({{{result}, variant}, segment});
                    }
                }
            },
            true),
        table_of_bins(tree_hit_table(),
                      [](const VariantOutcome& variant) { return variant.tree_hits.size(); }),
        table_of_bins(hit_height_table(),
                      [](const VariantOutcome& variant) { return variant.hit_heights.size(); }),
        result_table(
            factor_table(),
            [](auto& rows, const CaseResult& result) {
                for (const FactorRow& row : result.factors) {
                    for (const auto& [figure, estimate] : row.figures) {
                        rows.add({{result}, row, figure, estimate});
                    }
                }
            },
            true),
        result_table(
            direction_table(),
            [](auto& rows, const CaseResult& result) {
                for (const DirectionRow& row : result.directions) {
                    rows.add({{result}, row});
                }
            },
            true),
    };
}

}  // namespace coupling::validation
