#include "coupling/assessments/models/screen.hpp"

#include <iomanip>
#include <optional>
#include <sstream>
#include <string>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::models {
namespace {

using config::joined;

/// Of the many figures those of the first screen of the page.
bool is_main(const FigureKey& key) {
    const std::string& quantity = key.quantity;
    return quantity == "protection_percent" || (quantity == "reached_percent" && key.about == "target") ||
           quantity == "design_energy_kj" || quantity == "design_height_m" ||
           (quantity == "run_out_m" && key.statistic == "mean") ||
           (key.statistic == "p95" && key.about == "target" && quantity != "height_m");
}

std::string in_short(double value) {
    std::ostringstream text;
    text << std::setprecision(3) << value;
    return text.str();
}

std::string judged_in_words(const Comparison& comparison, const FigureKey& key) {
    const std::string quantity = judged_quantity(key);
    if (quantity.empty()) {
        return "";
    }
    std::string best;
    for (const std::size_t model : comparison.verdicts.best_on(quantity)) {
        const QuantityVerdict& verdict = comparison.verdicts.of(model, quantity);
        best +=
            joined(best.empty() ? "" : ", ", comparison.models[model], " ",
                   std::to_string(verdict.independent_met), " of ", std::to_string(verdict.independent()));
    }
    return best.empty() ? joined("; none meets half of its field criteria on ", quantity)
                        : joined("; judged best on ", quantity, ": ", best);
}

std::string title_of_figure(const FigureKey& key) {
    const std::string slope = key.cover == "forest" ? ", with forest"
                              : key.cover == "bare" ? ", bare slope"
                                                    : "";
    return joined(key.quantity, key.statistic.empty() ? "" : " ", key.statistic, slope);
}

}  // namespace

void print_ranges(std::ostream& out, const Comparison& comparison) {
    for (const LevelOfModels& levels : comparison.levels) {
        out << levels.name << ", level "
            << (levels.cover == "forest" ? "with forest:" : "on the bare slope:");
        for (std::size_t model = 0; model < comparison.models.size(); ++model) {
            out << (model > 0 ? "," : "") << ' ' << comparison.models[model] << ' ' << levels.by_model[model];
        }
        out << (levels_differ(levels) ? ": the models disagree\n" : "\n");
    }
    std::string place;
    for (const ModelFigure& figure : comparison.figures) {
        const std::optional<Range> range = range_over(figure);
        if (!range || !is_main(figure.key)) {
            continue;
        }
        const FigureKey& key = figure.key;
        const std::string here =
            joined(key.about == "slope" ? "slope" : key.name,
                   key.return_period_years > 0.0
                       ? joined(", return period of ", config::to_text(key.return_period_years), " years")
                       : "");
        if (here != place) {
            out << here << '\n';
            place = here;
        }
        out << "  " << title_of_figure(key) << ": " << in_short(range->low) << " ("
            << comparison.models[range->lowest] << ") to " << in_short(range->high) << " ("
            << comparison.models[range->highest] << ')';
        if (range->agreement == Agreement::disagree) {
            out << ", the models disagree"
                << (range->factor && *range->factor >= 1.45
                        ? joined(" by a factor of ", in_short(*range->factor))
                        : "");
        }
        out << judged_in_words(comparison, key) << '\n';
    }
}

}  // namespace coupling::models
