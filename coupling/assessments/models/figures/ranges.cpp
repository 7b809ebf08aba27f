#include "coupling/assessments/models/figures/ranges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace coupling::models {
namespace {

/// The intervals of the models that know the figure; empty if one of them has none.
std::vector<Interval> intervals_of(const ModelFigure& figure, Interval Figure::*kind) {
    std::vector<Interval> intervals;
    for (const Figure& one : figure.by_model) {
        if (std::isnan(one.value)) {
            continue;
        }
        Interval interval = one.*kind;
        if (std::isnan(interval.low) && !std::isnan(interval.high)) {
            interval.low = -std::numeric_limits<double>::infinity();  // not known: anything below
        }
        if (!(interval.low <= interval.high)) {
            return {};
        }
        intervals.push_back(interval);
    }
    return intervals;
}

/// Intervals have a value in common if each pair of them has one: the highest low is not above the lowest
/// high.
Agreement agreement_of(const std::vector<Interval>& intervals) {
    double highest_low = -std::numeric_limits<double>::infinity();
    double lowest_high = std::numeric_limits<double>::infinity();
    for (const Interval& interval : intervals) {
        highest_low = std::max(highest_low, interval.low);
        lowest_high = std::min(lowest_high, interval.high);
    }
    return highest_low > lowest_high ? Agreement::disagree : Agreement::agree;
}

}  // namespace

std::optional<Range> range_over(const ModelFigure& figure) {
    std::optional<Range> range;
    std::size_t known = 0;
    for (std::size_t model = 0; model < figure.by_model.size(); ++model) {
        const double value = figure.by_model[model].value;
        if (std::isnan(value)) {
            continue;
        }
        ++known;
        if (!range) {
            range = Range{.lowest = model, .highest = model, .low = value, .high = value};
        }
        if (value < range->low) {
            range->lowest = model;
            range->low = value;
        }
        if (value >= range->high) {  // of equal values the last model: a range names two
            range->highest = model;
            range->high = value;
        }
    }
    if (known < 2) {
        return std::nullopt;
    }
    if (range->low > 0.0) {
        range->factor = range->high / range->low;
    }
    for (const auto& [kind, name] :
         {std::pair{&Figure::of_all, Intervals::of_all}, std::pair{&Figure::of_rocks, Intervals::of_rocks}}) {
        if (const std::vector<Interval> intervals = intervals_of(figure, kind); !intervals.empty()) {
            range->agreement = agreement_of(intervals);
            range->intervals = name;
            break;
        }
    }
    return range;
}

bool levels_differ(const LevelOfModels& levels) {
    return std::adjacent_find(levels.by_model.begin(), levels.by_model.end(), std::not_equal_to<>{}) !=
           levels.by_model.end();
}

FieldVerdicts::FieldVerdicts(std::span<const std::string> models) {
    for (const std::string& model : models) {
        by_model_.push_back(verdicts_on(model));
    }
}

const QuantityVerdict& FieldVerdicts::of(std::size_t model, std::string_view quantity) const {
    const std::vector<QuantityVerdict>& verdicts = by_model_.at(model);
    const auto found = std::find_if(verdicts.begin(), verdicts.end(),
                                    [&](const QuantityVerdict& one) { return one.quantity == quantity; });
    if (found == verdicts.end()) {
        throw std::logic_error("no quantity that field cases judge: " + std::string{quantity});
    }
    return *found;
}

std::vector<std::size_t> FieldVerdicts::best_on(std::string_view quantity) const {
    // Shares are compared as products of whole numbers, so that equal ones are equal.
    const auto is_better = [](const QuantityVerdict& a, const QuantityVerdict& b) {
        const std::uint64_t left = a.independent_met * b.independent();
        const std::uint64_t right = b.independent_met * a.independent();
        return left != right ? left > right : a.independent() > b.independent();
    };
    std::vector<std::size_t> best;
    for (std::size_t model = 0; model < by_model_.size(); ++model) {
        const QuantityVerdict& verdict = of(model, quantity);
        if (verdict.independent() == 0 || 2 * verdict.independent_met < verdict.independent()) {
            continue;
        }
        if (!best.empty() && is_better(verdict, of(best.front(), quantity))) {
            best.clear();
        }
        if (best.empty() || !is_better(of(best.front(), quantity), verdict)) {
            best.push_back(model);
        }
    }
    return best;
}

std::vector<std::size_t> FieldVerdicts::judged_on(std::string_view quantity) const {
    std::vector<std::size_t> judged;
    for (std::size_t model = 0; model < by_model_.size(); ++model) {
        if (of(model, quantity).independent() > 0) {
            judged.push_back(model);
        }
    }
    return judged;
}

}  // namespace coupling::models
