#include "validation/engine/screen.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/results/tables/text_layout.hpp"
#include "validation/engine/case/coverage.hpp"
#include "validation/engine/case/factor_names.hpp"
#include "validation/engine/kinds/verdict.hpp"
#include "validation/engine/paper_variants.hpp"

namespace coupling::validation {
namespace {

using config::joined;

int decimals_of(double value, const std::string& unit) {
    const double size = std::abs(value);
    return unit == "-" && size <= 1.0 ? 3 : size < 10.0 ? 2 : size < 100.0 ? 1 : 0;
}

std::string fixed_text(double value, int decimals) {
    constexpr double too_long = 1e7;  // nobody counts the digits of 759267036943571200
    char text[64];
    if (std::abs(value) >= too_long) {
        std::snprintf(text, sizeof text, "%.3g", value);
    } else {
        std::snprintf(text, sizeof text, "%.*f", decimals, value);
    }
    return text;
}

std::string value_text(std::optional<double> value, const std::string& unit) {
    return value ? figure_text(*value, unit) : "";
}

/// "13.2±0.7": without blanks, which the table has no room for.
std::string with_deviation(double value, std::optional<double> deviation, const std::string& unit) {
    if (!deviation || !std::isfinite(value)) {
        return figure_text(value, unit);
    }
    return joined(figure_text(value, unit), "±", fixed_text(*deviation, decimals_of(value, unit)));
}

std::string with_deviation(const Value& value, const std::string& unit) {
    return with_deviation(value.value, value.deviation, unit);
}

std::string printed_criterion(const VerdictRow& row) {
    return row.low && row.high
               ? joined(config::to_text(*row.low), " to ", config::to_text(*row.high), mark_of(row))
               : "";
}

std::string verdict_text(Verdict verdict) {
    switch (verdict) {
        case Verdict::inside:
            return "in";
        case Verdict::missed:
            return "MISS";
        case Verdict::no_criterion:
            break;
    }
    return "";
}

/// The lines of a figure: a label that is too wide goes on below.
void add_figure(AlignedTable& table, const VerdictRow& row, bool has_strict) {
    const std::size_t label_columns = has_strict ? 32 : 52;
    const std::vector<std::string> label = wrapped(row.label, label_columns);
    std::vector<std::string> cells{label.empty() ? row.quantity : label.front(), row.unit};
    if (has_strict) {
        cells.push_back(value_text(row.observed, row.unit));
    }
    cells.push_back(row.published ? with_deviation(*row.published, row.published_deviation, row.unit) : "");
    if (has_strict) {
        cells.push_back(with_deviation(row.strict_value, row.unit));
        cells.push_back(verdict_text(row.strict_verdict));
    }
    cells.push_back(with_deviation(row.default_value, row.unit));
    cells.push_back(verdict_text(row.default_verdict));
    cells.push_back(printed_criterion(row));
    table.add(std::move(cells));
    for (std::size_t k = 1; k < label.size(); ++k) {
        table.add({joined("  ", label[k])});
    }
}

/// What the marks behind criteria mean, of those that a case has.
std::string legend_of_marks(const CaseResult& result) {
    const auto any = [&](const char* word) {
        return std::any_of(result.rows.begin(), result.rows.end(),
                           [&](const VerdictRow& row) { return row.rests_on == word; });
    };
    const char* const rebuilt = result.has_strict
                                    ? "r: used to rebuild the slope, a hit proves little. "
                                    : "r: rests on choices or a reference of our own, a hit proves little. ";
    return joined(any("rebuilding") ? rebuilt : "",
                  any("fitted") ? "f: the model was calibrated with it, a hit proves little." : "");
}

void print_verdicts(std::ostream& out, const CaseResult& result) {
    AlignedTable table{result.has_strict ? std::set<std::size_t>{0, 1, 5, 7, 8}
                                         : std::set<std::size_t>{0, 1, 4, 5}};
    table.add(result.has_strict
                  ? std::vector<std::string>{"", "unit", "observed", "published", "strict", "", "default", "",
                                             "criterion"}
                  : std::vector<std::string>{"", "unit", "reference", "Bannwald", "", "criterion"});
    for (const VerdictRow& row : result.rows) {
        add_figure(table, in_readable_unit(row), result.has_strict);
    }
    table.print(out);
    const std::string series = result.series == 0
                                   ? ""
                                   : joined("±: between series of ", std::to_string(result.rocks_per_series),
                                            " rocks (published: as the source says). ");
    const std::string marks = legend_of_marks(result);
    if (!series.empty() || !marks.empty()) {
        print_wrapped(out, "  ", joined(series, marks));
    }
}

void print_miss(std::ostream& out, const VerdictRow& row, const char* variant, const Value& value) {
    const std::string by = figure_text(
        std::abs(value.value < *row.low ? *row.low - value.value : value.value - *row.high), row.unit);
    const std::string unit = row.unit == "-" ? "" : joined(" ", row.unit);
    print_wrapped(out, "  ",
                  std::isfinite(value.value)
                      ? joined("missed", variant, ": ", row.label, " ", figure_text(value.value, row.unit),
                               unit, ", ", by, unit, value.value < *row.low ? " below " : " above ",
                               config::to_text(*row.low), " to ", config::to_text(*row.high))
                      : joined("missed", variant, ": ", row.label,
                               variant[0] == '\0' ? " cannot be computed" : " is given by no rock"));
}

void print_misses(std::ostream& out, const CaseResult& result) {
    for (const VerdictRow& as_judged : result.rows) {
        const VerdictRow row = in_readable_unit(as_judged);
        const bool strict = row.strict_verdict == Verdict::missed;
        const bool ours = row.default_verdict == Verdict::missed;
        if (strict) {
            print_miss(out, row, " by strict", row.strict_value);
        }
        if (ours) {
            print_miss(out, row, result.has_strict ? " by default" : "", row.default_value);
        }
        if ((strict || ours) && !row.cause.empty()) {
            print_wrapped(out, "      ", joined("likely cause: ", row.cause));
        }
    }
}

void print_flips(std::ostream& out, const CaseResult& result) {
    if (result.choices.empty()) {
        return;
    }
    out << "  free choices of the rebuilding, moved one at a time: " << result.choices.size() - 1 << '\n';
    const std::vector<Flip> flips = flips_of(result);
    for (std::size_t c = 1; c < result.choices.size(); ++c) {
        const ChoiceOutcome& choice = result.choices[c];
        std::string text;
        for (const Flip& flip : flips) {
            if (flip.choice == choice.choice) {
                const auto figure = parse_figure(flip.quantity);
                const std::string label = figure ? figure->label() : flip.quantity;
                const std::string unit = figure ? figure->unit() : "";
                text += joined(text.empty() ? "" : "; ", flip.strict ? "strict " : "default ", label, " ",
                               figure_text(flip.before, unit), " → ", figure_text(flip.after, unit), " ",
                               flip.becomes == Verdict::inside ? "comes in" : "goes out");
            }
        }
        print_wrapped(out, "    ",
                      joined(choice.choice, ": ", text.empty() ? std::string{"no verdict changes"} : text));
    }
}

/// The variants of the paper side by side.
void print_paper_variants(std::ostream& out, const CaseResult& result) {
    PaperVariants variants = paper_variants(result);
    if (variants.rows.empty()) {
        return;
    }
    AlignedTable table{{0, 1}};
    table.add(std::move(variants.head));
    for (std::vector<std::string>& row : variants.rows) {
        table.add(std::move(row));
    }
    table.print(out);
}

/// The change of each figure from the first step of its setting to the last.
void print_directions(std::ostream& out, const CaseResult& result) {
    if (result.directions.empty()) {
        return;
    }
    AlignedTable table{{0, 1, 4}};
    table.add({"directions of the literature", "", "change", "95 % interval", ""});
    for (const DirectionRow& row : result.directions) {
        table.add({direction_name(row), row.variant, figure_text(row.change.value, "-"),
                   joined(figure_text(row.change.low, "-"), " to ", figure_text(row.change.high, "-")),
                   verdict_text(row.verdict)});
    }
    table.print(out);
}

}  // namespace

std::string mark_of(const VerdictRow& row) {
    return row.rests_on == "rebuilding" ? " r" : row.rests_on == "fitted" ? " f" : "";
}

std::string figure_text(double value, const std::string& unit) {
    return std::isfinite(value) ? fixed_text(value, decimals_of(value, unit)) : "-";
}

std::string figure_text(double value, double deviation, const std::string& unit) {
    return std::isfinite(value)
               ? joined(figure_text(value, unit), " ± ", fixed_text(deviation, decimals_of(value, unit)))
               : "-";
}

namespace {

void print_coverage(std::ostream& out, const std::vector<Coverage>& coverage) {
    if (coverage.empty()) {
        return;
    }
    out << "  " << in_words(coverage) << '\n';
    for (const Coverage& one : coverage) {
        out << "    " << one.quantity << (one.observed ? ": observed " : ": published ")
            << figure_text(one.known, "") << ", simulated " << figure_text(one.value, "") << " ± "
            << figure_text(one.of_rocks, "") << " by rocks, ± " << figure_text(one.of_all, "") << " by all\n";
    }
}

}  // namespace

void print_case(std::ostream& out, const CaseResult& result) {
    out << result.name << ": " << result.title << '\n';
    print_wrapped(out, "  ", result.rebuilt);
    out << "  " << result.extent << '\n';
    for (const std::string& warning : result.warnings) {
        print_wrapped(out, "  ", joined("warning: ", warning));
    }
    for (const std::string& note : result.notes) {
        print_wrapped(out, "  ", joined("note: ", note));
    }
    print_verdicts(out, result);
    print_misses(out, result);
    for (const std::string& line : result.details) {
        print_wrapped(out, "  ", line);
    }
    print_coverage(out, result.coverage);
    print_paper_variants(out, result);
    print_directions(out, result);
    print_flips(out, result);
    out << '\n';
}

}  // namespace coupling::validation
