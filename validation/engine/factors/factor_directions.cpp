#include <algorithm>
#include <cmath>

#include "validation/engine/factors/factors.hpp"

namespace coupling::validation {
namespace {

constexpr std::size_t thirds = 3;

/// Where a combination belongs when one setting is looked at.
struct Cell {
    std::size_t step = 0;
    Combination chain;  ///< what it shares with the other steps
    friend bool operator<(const Cell& a, const Cell& b) {
        return a.chain != b.chain ? a.chain < b.chain : a.step < b.step;
    }
};

bool is_of_stand(const std::string& setting) {
    return setting.starts_with("stand.");
}

/// Tells step and chain of combinations with regard to one setting.
class Steps {
public:
    Steps(const std::string& setting, const FactorPlan& plan, const std::vector<CombinationOutcome>& outcomes)
        : plan_{plan}, factor_{plan.place_of(setting)} {
        if (by_basal_area()) {
            find_thirds(outcomes);
        } else {
            values_ = plan.factors[factor_].values;
        }
    }

    [[nodiscard]] const std::vector<double>& values() const { return values_; }

    /// Nothing for a combination that belongs to another setting's chain.
    [[nodiscard]] std::optional<Cell> cell_of(const CombinationOutcome& outcome) const {
        Cell cell{0, outcome.settings};
        if (by_basal_area()) {
            if (!plan_.is_crossed(outcome.settings)) {
                return std::nullopt;
            }
            cell.step = third_of(outcome.basal_area_m2pha);
            for (std::size_t f = 0; f < plan_.factors.size(); ++f) {
                cell.chain[f] = is_of_stand(plan_.factors[f].setting) ? 0.0 : cell.chain[f];
            }
            return cell;
        }
        const double value = outcome.settings[factor_];
        const auto found = std::find(values_.begin(), values_.end(), value);
        cell.step = static_cast<std::size_t>(found - values_.begin());
        cell.chain[factor_] = plan_.base[factor_];
        const bool belongs =
            plan_.factors[factor_].crossed ? plan_.is_crossed(outcome.settings) : cell.chain == plan_.base;
        return belongs && found != values_.end() ? std::optional{cell} : std::nullopt;
    }

private:
    [[nodiscard]] bool by_basal_area() const { return factor_ == plan_.factors.size(); }

    void find_thirds(const std::vector<CombinationOutcome>& outcomes) {
        for (const CombinationOutcome& outcome : outcomes) {
            if (plan_.is_crossed(outcome.settings)) {
                areas_.push_back(outcome.basal_area_m2pha);
            }
        }
        std::sort(areas_.begin(), areas_.end());
        areas_.erase(std::unique(areas_.begin(), areas_.end()), areas_.end());
        std::vector<double> counts(thirds, 0.0);
        values_.assign(thirds, 0.0);
        for (const double area : areas_) {
            values_[third_of(area)] += area;
            counts[third_of(area)] += 1.0;
        }
        for (std::size_t i = 0; i < thirds; ++i) {
            values_[i] /= counts[i];
        }
    }
    [[nodiscard]] std::size_t third_of(double area) const {
        const auto rank = std::lower_bound(areas_.begin(), areas_.end(), area) - areas_.begin();
        return static_cast<std::size_t>(rank) * thirds / areas_.size();
    }

    const FactorPlan& plan_;
    std::size_t factor_;
    std::vector<double> values_;
    std::vector<double> areas_;  ///< of the stands, rising, each once
};

/// The figure at each step over the chains that have it at every step; empty without any.
std::vector<SeriesEstimate> at_steps(const std::string& figure, const Steps& steps,
                                     const std::vector<CombinationOutcome>& outcomes) {
    std::map<Cell, std::vector<SeriesEstimate>> cells;
    for (const CombinationOutcome& outcome : outcomes) {
        if (const auto cell = steps.cell_of(outcome)) {
            cells[*cell].push_back(outcome.figures.at(figure));
        }
    }
    std::vector<std::vector<SeriesEstimate>> of_step(steps.values().size());
    for (auto cell = cells.begin(); cell != cells.end();) {
        const Combination& chain = cell->first.chain;
        std::vector<SeriesEstimate> means;
        for (; cell != cells.end() && cell->first.chain == chain; ++cell) {
            means.push_back(mean_of(cell->second));
        }
        const bool whole = means.size() == of_step.size() &&
                           std::all_of(means.begin(), means.end(),
                                       [](const SeriesEstimate& mean) { return std::isfinite(mean.value); });
        for (std::size_t step = 0; whole && step < means.size(); ++step) {
            of_step[step].push_back(means[step]);
        }
    }
    std::vector<SeriesEstimate> estimates;
    for (const std::vector<SeriesEstimate>& chains : of_step) {
        if (chains.empty()) {
            return {};
        }
        estimates.push_back(mean_of(chains));
    }
    return estimates;
}

}  // namespace

DirectionRow judge_direction(const Direction& direction, const FactorPlan& plan,
                             const std::vector<CombinationOutcome>& outcomes) {
    DirectionRow row;
    row.figure = direction.figure;
    row.setting = direction.setting;
    row.rises = direction.rises;
    row.source = direction.source;
    row.verdict = Verdict::missed;
    const Steps steps{direction.setting, plan, outcomes};
    const std::vector<SeriesEstimate> estimates = at_steps(direction.figure, steps, outcomes);
    if (estimates.empty()) {
        row.change = {NAN, NAN, NAN};
        return row;
    }
    row.steps = steps.values();
    for (const SeriesEstimate& estimate : estimates) {
        row.at_steps.push_back(estimate.interval());
    }
    const auto against = [&](const Estimate& change) {
        return direction.rises ? change.high < 0.0 : change.low > 0.0;
    };
    for (std::size_t i = 1; i < estimates.size(); ++i) {
        row.steps_against += against(difference(estimates[i], estimates[i - 1]).interval()) ? 1U : 0U;
    }
    row.change = difference(estimates.back(), estimates.front()).interval();
    const bool as_expected = direction.rises ? row.change.low > 0.0 : row.change.high < 0.0;
    row.verdict = as_expected && row.steps_against == 0 ? Verdict::inside : Verdict::missed;
    return row;
}

}  // namespace coupling::validation
