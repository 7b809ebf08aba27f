#include "coupling/validation/screen.hpp"

#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include "config/text/numbers.hpp"
#include "coupling/results/joined.hpp"
#include "coupling/validation/factor_names.hpp"
#include "coupling/validation/text_layout.hpp"
#include "coupling/validation/verdict.hpp"

namespace coupling::validation {

namespace {

int decimals_of(double value, const std::string& unit) {
    const double size = std::abs(value);
    return unit == "-" && size <= 1.0 ? 3 : size < 10.0 ? 2 : size < 100.0 ? 1 : 0;
}

std::string fixed_text(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
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

std::string criterion_text(const VerdictRow& row) {
    return row.low && row.high ? joined(config::to_text(*row.low), " to ", config::to_text(*row.high),
                                        row.rests_on == "rebuilding" ? " r" : "")
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
void add_figure(AlignedTable& table, const VerdictRow& row) {
    constexpr std::size_t label_columns = 32;
    const std::vector<std::string> label = wrapped(row.label, label_columns);
    table.add({label.empty() ? row.quantity : label.front(), row.unit, value_text(row.observed, row.unit),
               row.published ? with_deviation(*row.published, row.published_deviation, row.unit) : "",
               with_deviation(row.strict_value, row.unit), verdict_text(row.strict_verdict),
               with_deviation(row.default_value, row.unit), verdict_text(row.default_verdict),
               criterion_text(row)});
    for (std::size_t k = 1; k < label.size(); ++k) {
        table.add({joined("  ", label[k])});
    }
}

void print_verdicts(std::ostream& out, const CaseResult& result) {
    AlignedTable table{{0, 1, 5, 7, 8}};
    table.add({"", "unit", "observed", "published", "strict", "", "default", "", "criterion"});
    for (const VerdictRow& row : result.rows) {
        add_figure(table, row);
    }
    table.print(out);
    print_wrapped(out, "  ",
                  joined("±: between series of ", std::to_string(result.rocks_per_series),
                         " rocks (published: as the source says). r: used to rebuild the slope, a hit proves "
                         "little."));
}

void print_miss(std::ostream& out, const VerdictRow& row, const char* variant, const Value& value) {
    const std::string by = figure_text(
        std::abs(value.value < *row.low ? *row.low - value.value : value.value - *row.high), row.unit);
    const std::string unit = row.unit == "-" ? "" : joined(" ", row.unit);
    print_wrapped(
        out, "  ",
        std::isfinite(value.value)
            ? joined("missed by ", variant, ": ", row.label, " ", figure_text(value.value, row.unit), unit,
                     ", ", by, unit, value.value < *row.low ? " below " : " above ",
                     config::to_text(*row.low), " to ", config::to_text(*row.high))
            : joined("missed by ", variant, ": ", row.label, " is given by no rock"));
}

void print_misses(std::ostream& out, const CaseResult& result) {
    for (const VerdictRow& row : result.rows) {
        const bool strict = row.strict_verdict == Verdict::missed;
        const bool ours = row.default_verdict == Verdict::missed;
        if (strict) {
            print_miss(out, row, "strict", row.strict_value);
        }
        if (ours) {
            print_miss(out, row, "default", row.default_value);
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

std::string figure_text(double value, const std::string& unit) {
    return std::isfinite(value) ? fixed_text(value, decimals_of(value, unit)) : "-";
}

std::string figure_text(double value, double deviation, const std::string& unit) {
    return std::isfinite(value)
               ? joined(figure_text(value, unit), " ± ", fixed_text(deviation, decimals_of(value, unit)))
               : "-";
}

void print_case(std::ostream& out, const CaseResult& result) {
    out << result.name << ": " << result.title << '\n';
    print_wrapped(out, "  ", result.rebuilt);
    out << "  " << result.rocks << " rocks; " << result.series << " series of " << result.rocks_per_series
        << '\n';
    for (const std::string& note : result.notes) {
        print_wrapped(out, "  ", joined("note: ", note));
    }
    print_verdicts(out, result);
    print_misses(out, result);
    print_directions(out, result);
    print_flips(out, result);
    out << '\n';
}

}  // namespace coupling::validation
