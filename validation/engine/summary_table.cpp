#include "validation/engine/summary_table.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "validation/engine/case/factor_names.hpp"
#include "validation/engine/kinds/verdict.hpp"
#include "validation/engine/paper_variants.hpp"
#include "validation/engine/screen.hpp"

namespace coupling::validation {
namespace {

using config::joined;

std::string cell(std::string text) {
    for (std::size_t bar = text.find('|'); bar != std::string::npos; bar = text.find('|', bar + 2)) {
        text.insert(bar, 1, '\\');
    }
    return text;
}

std::string value_cell(const Value& value, const std::string& unit, Verdict verdict) {
    const std::string text =
        value.deviation ? figure_text(value.value, *value.deviation, unit) : figure_text(value.value, unit);
    return verdict == Verdict::missed ? joined("**", text, "**") : text;
}

void write_row(std::ostream& out, const VerdictRow& row, bool has_strict, bool has_scatter) {
    const std::vector<std::string> fixed = fixed_cells(row);
    if (!has_strict) {
        out << "| " << fixed[0] << " | " << fixed[1] << " | " << fixed[3] << " | "
            << value_cell(row.default_value, row.unit, row.default_verdict) << " | " << fixed[4] << " |\n";
        return;
    }
    out << "| " << fixed[0] << " | " << fixed[1] << " | " << fixed[2] << " | " << fixed[3] << " | "
        << value_cell(row.strict_value, row.unit, row.strict_verdict) << " | ";
    if (has_scatter) {
        out << (row.scatter_value ? value_cell(*row.scatter_value, row.unit, Verdict::no_criterion) : "")
            << " | ";
    }
    out << value_cell(row.default_value, row.unit, row.default_verdict) << " | " << fixed[4] << " |\n";
}

std::size_t met(const CaseResult& result, Verdict VerdictRow::*verdict) {
    return static_cast<std::size_t>(
        std::count_if(result.rows.begin(), result.rows.end(),
                      [&](const VerdictRow& row) { return row.*verdict == Verdict::inside; }));
}

std::size_t criteria(const CaseResult& result) {
    return static_cast<std::size_t>(
        std::count_if(result.rows.begin(), result.rows.end(),
                      [](const VerdictRow& row) { return row.default_verdict != Verdict::no_criterion; }));
}

/// "0.34 (0.33 to 0.35)", in bold where the direction does not hold.
std::string change_cell(const DirectionRow& row) {
    const std::string text = joined(figure_text(row.change.value, ""), " (", figure_text(row.change.low, ""),
                                    " to ", figure_text(row.change.high, ""), ")");
    return row.verdict == Verdict::missed ? joined("**", text, "**") : text;
}

const DirectionRow* same_in_default(const CaseResult& result, const DirectionRow& row) {
    const auto found =
        std::find_if(result.directions.begin(), result.directions.end(), [&](const DirectionRow& other) {
            return other.variant == "default" && other.figure == row.figure && other.setting == row.setting;
        });
    return found == result.directions.end() ? nullptr : &*found;
}

void write_direction_rows(std::ostream& out, const CaseResult& result) {
    if (result.directions.empty()) {
        return;
    }
    out << "\n| as the literature has it | strict: change from first to last step (95 %) | default |\n"
           "|---|---|---|\n";
    for (const DirectionRow& row : result.directions) {
        if (row.variant == "default") {
            continue;
        }
        const DirectionRow* ours = same_in_default(result, row);
        out << "| " << cell(direction_name(row)) << " | " << change_cell(row) << " | "
            << (ours != nullptr ? change_cell(*ours) : "") << " |\n";
    }
}

void write_paper_variants(std::ostream& out, const CaseResult& result) {
    const PaperVariants variants = paper_variants(result);
    if (variants.rows.empty()) {
        return;
    }
    const auto line = [&](const std::vector<std::string>& cells) {
        for (const std::string& text : cells) {
            out << "| " << cell(text) << ' ';
        }
        out << "|\n";
    };
    out << '\n';
    line(variants.head);
    line(std::vector<std::string>(variants.head.size(), "---"));
    for (const std::vector<std::string>& row : variants.rows) {
        line(row);
    }
}

void write_case(std::ostream& out, const CaseResult& result) {
    out << "\n**" << result.name << "** - " << result.title << ". " << result.extent << ". Criteria met: ";
    if (result.has_strict) {
        out << "strict " << met(result, &VerdictRow::strict_verdict) << ", default ";
    }
    out << met(result, &VerdictRow::default_verdict) << " of " << criteria(result) << ".\n";
    if (!result.rows.empty()) {
        const bool has_scatter =
            std::any_of(result.rows.begin(), result.rows.end(),
                        [](const VerdictRow& row) { return row.scatter_value.has_value(); });
        out << (has_scatter ? "\n| figure | unit | observed | published | strict | strict, scattered angle | "
                              "default | "
                              "criterion |\n|---|---|---|---|---|---|---|---|\n"
                : result.has_strict
                    ? "\n| figure | unit | observed | published | strict | default | criterion |\n"
                      "|---|---|---|---|---|---|---|\n"
                    : "\n| figure | unit | reference | Bannwald | criterion |\n"
                      "|---|---|---|---|---|\n");
        for (const VerdictRow& row : result.rows) {
            write_row(out, in_readable_unit(row), result.has_strict, has_scatter);
        }
    }
    write_paper_variants(out, result);
    write_direction_rows(out, result);
    for (const std::string& warning : result.warnings) {
        out << "\nWarning: " << warning << ".\n";
    }
    for (const std::string& note : result.notes) {
        out << "\nNote: " << note << ".\n";
    }
    for (const VerdictRow& row : result.rows) {
        const bool missed = row.strict_verdict == Verdict::missed || row.default_verdict == Verdict::missed;
        if (missed && !row.cause.empty()) {
            out << "\nMissed: " << row.label << ". Likely cause: " << row.cause << "\n";
        }
    }
}

}  // namespace

std::vector<std::string> fixed_cells(const VerdictRow& row) {
    const auto value = [&](const std::optional<double>& number) {
        return number ? figure_text(*number, row.unit) : std::string{};
    };
    std::string published = value(row.published);
    if (row.published && row.published_deviation) {
        published = figure_text(*row.published, *row.published_deviation, row.unit);
    }
    std::string criterion;
    if (row.low && row.high) {
        criterion = joined(config::to_text(*row.low), " to ", config::to_text(*row.high), mark_of(row));
    }
    return {cell(row.label), row.unit, value(row.observed), published, criterion};
}

void write_summary(std::ostream& out, std::span<const CaseResult> cases) {
    // No line begins with **: that is how cases begin (update_readme.sh).
    out << "Value of the large ensemble ± standard deviation between series (forest: seeds); **bold**: "
           "outside\nthe criterion; r: the figure was used to rebuild the slope, f: the model was fitted to "
           "it, so a hit\nproves little.\n";
    for (const CaseResult& result : cases) {
        write_case(out, result);
    }
}

void write_overview(std::ostream& out, std::span<const CaseResult> cases) {
    out << "| case | what | strict | default |\n|---|---|---|---|\n";
    for (const CaseResult& result : cases) {
        const std::string of = " of " + std::to_string(criteria(result));
        out << "| "
            << (result.is_own ? result.name
                              : joined("[", result.name, "](validation/", result.name, "/README.md)"))
            << " | " << cell(result.title) << " | ";
        if (result.has_strict) {
            out << met(result, &VerdictRow::strict_verdict) << of;
        }
        out << " | " << met(result, &VerdictRow::default_verdict) << of << " |\n";
    }
}

}  // namespace coupling::validation
