#include "validation/engine/kinds/verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "validation/engine/case/comparison.hpp"

namespace coupling::validation {

namespace {

Value value_named(const Values& values, const std::string& name) {
    const auto found = values.find(name);
    return found != values.end() ? found->second : Value{std::numeric_limits<double>::quiet_NaN(), {}, {}};
}

template <class Map>
auto* find_in(const Map& map, const std::string& name) {
    const auto found = map.find(name);
    return found != map.end() ? &found->second : nullptr;
}

VerdictRow row_of(const ValidationCase& of, const std::string& name, const Values& strict_values,
                  const Values& default_values) {
    VerdictRow row;
    row.quantity = name;
    row.label = of.label_of(name);
    row.unit = of.unit_of(name);
    if (of.comparison) {
        row.model = of.comparison->figure(name).model;
        row.measures = of.comparison->figure(name).measures;
    }
    if (const ObservedFigure* observed = find_in(of.observed, name)) {
        row.observed = observed->value;
        row.observed_source = observed->source;
    }
    if (const PublishedFigure* published = find_in(of.published, name)) {
        row.published = published->value;
        row.published_deviation = published->deviation;
        row.published_source = published->source;
    }
    row.strict_value = value_named(strict_values, name);
    row.default_value = value_named(default_values, name);
    if (const Criterion* criterion = find_in(of.criteria, name)) {
        row.low = criterion->low;
        row.high = criterion->high;
        row.rests_on = criterion->rests_on;
        row.rule = criterion->rule;
        row.cause = criterion->cause;
        if (of.has_strict()) {
            row.strict_verdict = verdict_of(row.strict_value.value, *criterion);
        }
        row.default_verdict = verdict_of(row.default_value.value, *criterion);
    }
    return row;
}

void add_flip(std::vector<Flip>& flips, const VerdictRow& row, const ChoiceOutcome& moved, bool strict,
              double before, double after) {
    const Criterion criterion{*row.low, *row.high, {}, {}, {}};
    const Verdict becomes = verdict_of(after, criterion);
    if (verdict_of(before, criterion) != becomes) {
        flips.push_back({moved.choice, row.quantity, strict, before, after, becomes});
    }
}

}  // namespace

Verdict verdict_of(double value, const Criterion& criterion) {
    return value >= criterion.low && value <= criterion.high ? Verdict::inside : Verdict::missed;
}

std::vector<VerdictRow> verdict_rows(const ValidationCase& of, const Values& strict_values,
                                     const Values& default_values) {
    std::vector<VerdictRow> rows;
    for (const std::string& name : of.figures) {
        rows.push_back(row_of(of, name, strict_values, default_values));
    }
    return rows;
}

VerdictRow in_readable_unit(VerdictRow row) {
    struct Unit {
        const char* from;
        double least;  ///< of the figure, from which on the other unit is taken
        const char* to;
        double divisor;
    };
    static constexpr std::array<Unit, 3> units{
        {{"ppb", 1e10, "times", 1e9}, {"ppb", 1e6, "%", 1e7}, {"g/ha", 1e6, "t/ha", 1e6}}};
    const auto unit = std::find_if(units.begin(), units.end(), [&](const Unit& one) {
        return row.unit == one.from && std::abs(row.default_value.value) >= one.least;
    });
    if (unit == units.end()) {
        return row;
    }
    row.unit = unit->to;
    row.default_value.value /= unit->divisor;
    for (std::optional<double>* value : {&row.observed, &row.published, &row.low, &row.high}) {
        if (*value) {
            **value /= unit->divisor;
        }
    }
    return row;
}

std::vector<Flip> flips_of(const CaseResult& result) {
    std::vector<Flip> flips;
    if (result.choices.empty()) {
        return flips;
    }
    const ChoiceOutcome& base = result.choices.front();
    for (const ChoiceOutcome& moved : result.choices) {
        for (const VerdictRow& row : result.rows) {
            if (row.low && row.high) {
                add_flip(flips, row, moved, true, value_named(base.strict_values, row.quantity).value,
                         value_named(moved.strict_values, row.quantity).value);
                add_flip(flips, row, moved, false, value_named(base.default_values, row.quantity).value,
                         value_named(moved.default_values, row.quantity).value);
            }
        }
    }
    return flips;
}

bool misses_any(const CaseResult& result) {
    return std::any_of(result.rows.begin(), result.rows.end(),
                       [](const VerdictRow& row) {
                           return row.strict_verdict == Verdict::missed ||
                                  row.default_verdict == Verdict::missed;
                       }) ||
           std::any_of(result.directions.begin(), result.directions.end(),
                       [](const DirectionRow& row) { return row.verdict == Verdict::missed; });
}

}  // namespace coupling::validation
