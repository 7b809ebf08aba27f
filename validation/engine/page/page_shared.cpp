#include <array>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "validation/engine/page/page_parts.hpp"

namespace coupling::validation {
namespace {

using config::joined;

/// 0.9995 must not become 1.00.
int decimals_of(double size) {
    return size >= 100.0 ? 0 : size >= 10.0 ? 1 : size < 1.0 ? 3 : 2;
}

}  // namespace

void Score::add(Verdict verdict, bool rests_on_nothing) {
    if (verdict == Verdict::no_criterion) {
        return;
    }
    const bool is_met = verdict == Verdict::inside;
    met += is_met ? 1U : 0U;
    missed += is_met ? 0U : 1U;
    independent += rests_on_nothing ? 1U : 0U;
    met_independent += is_met && rests_on_nothing ? 1U : 0U;
}

void Score::add(const Score& other) {
    met += other.met;
    missed += other.missed;
    independent += other.independent;
    met_independent += other.met_independent;
}

std::string Score::text() const {
    return report::page_text("{met} of {met_missed}",
                             {{"met", std::to_string(met)}, {"met_missed", std::to_string(met + missed)}});
}

Score score_of(const CaseResult& result, const Side& side) {
    Score score;
    for (const VerdictRow& row : result.rows) {
        score.add(row.*side.verdict, row.rests_on == "independent");
    }
    for (const DirectionRow& row : result.directions) {
        if (row.variant == side.name) {
            score.add(row.verdict, true);
        }
    }
    return score;
}

std::string badge(Verdict verdict) {
    switch (verdict) {
        case Verdict::inside:
            return report::element("span", {{"class", "badge"}}, report::page_text("met"));
        case Verdict::missed:
            return report::element("span", {{"class", "badge missed"}}, report::page_text("missed"));
        case Verdict::no_criterion:
            break;
    }
    return "–";
}

std::string criterion_text(const VerdictRow& row) {
    if (row.low && row.high) {
        return report::page_text("{row_low} to {row_high}",
                                 {{"row_low", figure_text(*row.low)}, {"row_high", figure_text(*row.high)}});
    }
    if (row.low) {
        return report::page_text("at least {row_low}", {{"row_low", figure_text(*row.low)}});
    }
    return row.high ? report::page_text("at most {row_high}", {{"row_high", figure_text(*row.high)}}) : "–";
}

Verdict judge(const VerdictRow& row, double value) {
    if (!row.low && !row.high) {
        return Verdict::no_criterion;
    }
    const bool inside =
        !std::isnan(value) && (!row.low || value >= *row.low) && (!row.high || value <= *row.high);
    return inside ? Verdict::inside : Verdict::missed;
}

std::string row_name(const VerdictRow& row) {
    const std::string& name = row.label.empty() ? row.quantity : row.label;
    return row.unit.empty() || row.unit == "-"
               ? report::escaped(name)
               : joined(report::escaped(name), ", ", report::escaped(row.unit));
}

std::string series_of(const CaseResult& result, std::size_t variant) {
    const std::string& name = result.variants[variant].variant;
    if (name == "strict" || name == "default") {
        return name;
    }
    constexpr std::size_t styles = 5;
    std::size_t others = 0;
    for (std::size_t i = 0; i < variant; ++i) {
        const std::string& before = result.variants[i].variant;
        others += before != "strict" && before != "default" ? 1U : 0U;
    }
    return joined("other", std::to_string(others % styles));
}

std::string figure_text(double value) {
    const double size = std::abs(value);
    return size < 0.001 ? report::three_digits(value) : report::fixed(value, decimals_of(size));
}

std::string figure_text(double value, double deviation) {
    const std::string text = std::abs(value) < 0.001 ? report::three_digits(deviation)
                                                     : report::fixed(deviation, decimals_of(std::abs(value)));
    return joined(figure_text(value), "\u00a0±\u00a0", text);
}

}  // namespace coupling::validation
