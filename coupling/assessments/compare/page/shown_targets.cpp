#include "coupling/assessments/compare/page/shown_targets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "coupling/results/figures/most_reached.hpp"

namespace coupling::compare {
namespace {

std::map<std::string, std::string> names_of_targets(std::span<const FinishedRun> runs) {
    std::map<std::string, std::string> names;
    for (const FinishedRun& run : runs) {
        if (!has_table(run.folder, "targets.csv")) {
            continue;
        }
        const config::Table table = read_table(run.folder, "targets.csv", {"target_id"});
        for (std::size_t row = 0; table.has("name") && row < table.rows(); ++row) {
            if (!table.text(row, "name").empty()) {
                names.emplace(table.text(row, "target_id"), table.text(row, "name"));
            }
        }
    }
    std::map<std::string, int> called;
    for (const auto& [id, name] : names) {
        ++called[name];
    }
    for (auto& [id, name] : names) {
        if (called[name] > 1) {
            name = config::joined(name, " (", id, ")");
        }
    }
    return names;
}

}  // namespace

ShownTargets shown_targets(std::span<const FinishedRun> runs, const SideBySide& comparison) {
    std::vector<std::pair<std::string, double>> targets;  // in the order of the tables
    for (const Line& line : comparison.lines) {
        const bool tells_reach =
            line.key.quantity == "reached_percent" || line.key.quantity == "reached_bare_percent";
        if (line.key.target.empty() || !tells_reach) {
            continue;
        }
        auto known = std::find_if(targets.begin(), targets.end(),
                                  [&](const auto& each) { return each.first == line.key.target; });
        if (known == targets.end()) {
            known = targets.insert(targets.end(), {line.key.target, 0.0});
        }
        for (const auto& figure : line.figures) {
            if (figure && !std::isnan(figure->value)) {
                known->second = std::max(known->second, figure->value);
            }
        }
    }
    ShownTargets shown{{}, {}, targets.size(), names_of_targets(runs)};
    if (targets.size() > most_targets_shown) {
        std::stable_sort(targets.begin(), targets.end(),
                         [](const auto& a, const auto& b) { return a.second > b.second; });
        for (std::size_t i = most_target_cards; i < targets.size(); ++i) {
            shown.not_printed.insert(targets[i].first);
            if (i >= most_targets_shown) {
                shown.without_chart.insert(targets[i].first);
            }
        }
    }
    return shown;
}

}  // namespace coupling::compare
