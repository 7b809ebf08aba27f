#include "validation/engine/kinds/model_verdicts.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "config/text/joined.hpp"
#include "rockfall/motion/models.hpp"
#include "validation/engine/kinds/verdict.hpp"

namespace coupling::validation {
namespace {

struct Part {
    std::string_view in_name;
    std::string_view quantity;
};

/// What the first part found in the name of a figure says that it is about.
constexpr std::array parts{
    Part{"reduction.", ""},
    Part{"first_", "rebounds"},
    Part{"impact.", "rebounds"},
    Part{"impacts_mean", "rebounds"},
    Part{"jump_length", "rebounds"},
    Part{"sideways", "sideways"},
    Part{"dispersion", "sideways"},
    Part{"run_out_deviation", "spread"},
    Part{"energy_distance_m", "stops"},
    Part{"energ", "energy"},
    Part{"translational", "energy"},
    Part{"speed", "speed"},
    Part{"height", "height"},
    Part{"run_out", "stops"},
    Part{"displacement", "stops"},
    Part{"shadow", "stops"},
    Part{"reach", "stops"},
    Part{"stopped_share", "stops"},
    Part{"passing", "stops"},
    Part{"ks", "stops"},
};

using Counts = std::map<std::pair<std::string, std::string>, QuantityVerdict>;

void count(Counts& counts, const std::string& model, std::string_view quantity, bool is_met,
           bool is_independent) {
    QuantityVerdict& to = counts[{model, std::string{quantity}}];
    (is_met ? to.met : to.missed) += 1;
    if (is_independent) {
        (is_met ? to.independent_met : to.independent_missed) += 1;
    }
}

const Values* default_values(const CaseResult& result) {
    const auto found =
        std::find_if(result.variants.begin(), result.variants.end(),
                     [](const VariantOutcome& variant) { return variant.variant == "default"; });
    return found == result.variants.end() ? nullptr : &found->values;
}

/// The other models that have the figure of a row, held against its criterion.
void count_other_models(const CaseResult& result, const VerdictRow& row, std::string_view quantity,
                        Counts& counts) {
    const Values* values = default_values(result);
    if (values == nullptr) {
        return;
    }
    const Criterion criterion{*row.low, *row.high, {}, {}, {}};
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        const std::string name{rockfall::description_of(model).name};
        const std::string figure = config::joined(name, ".", row.quantity);
        const bool has_own =
            std::any_of(result.rows.begin(), result.rows.end(), [&](const VerdictRow& other) {
                return other.quantity == figure && other.default_verdict != Verdict::no_criterion;
            });
        const auto value = values->find(figure);
        if (!has_own && value != values->end()) {
            count(counts, name, quantity, verdict_of(value->second.value, criterion) == Verdict::inside,
                  row.rests_on != "rebuilding");
        }
    }
}

}  // namespace

std::string_view quantity_of(std::string_view figure) {
    const std::string_view name = figure.substr(0, figure.find(':'));
    const auto* found = std::find_if(parts.begin(), parts.end(), [&](const Part& part) {
        return name.find(part.in_name) != std::string_view::npos;
    });
    return found == parts.end() ? "" : found->quantity;
}

std::vector<ModelVerdict> model_verdicts(const CaseResult& result) {
    Counts counts;
    for (const VerdictRow& row : result.rows) {
        const std::string_view quantity = quantity_of(row.measures.empty() ? row.quantity : row.measures);
        if (row.model.empty() || quantity.empty() || row.default_verdict == Verdict::no_criterion) {
            continue;
        }
        count(counts, row.model, quantity, row.default_verdict == Verdict::inside,
              row.rests_on == "independent");
        count_other_models(result, row, quantity, counts);
    }
    std::vector<ModelVerdict> verdicts;
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        const std::string name{rockfall::description_of(model).name};
        for (const std::string_view quantity : judged_quantities) {
            const auto found = counts.find({name, std::string{quantity}});
            if (found != counts.end()) {
                verdicts.push_back({name, found->second});
                verdicts.back().verdict.quantity = quantity;
            }
        }
    }
    return verdicts;
}

}  // namespace coupling::validation
