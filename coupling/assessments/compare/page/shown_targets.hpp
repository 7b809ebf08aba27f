#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string>

#include "coupling/assessments/compare/runs/side_by_side.hpp"

namespace coupling::compare {

/// Which targets have charts and stand on paper: of more than ten those that most rocks reach in any run, ten
/// in charts and four of them on paper [choice].
struct ShownTargets {
    std::set<std::string> without_chart;         ///< ids
    std::set<std::string> not_printed;           ///< ids, these among them
    std::size_t all = 0;                         ///< targets of which it is known how many rocks reach them
    std::map<std::string, std::string> names{};  ///< by id, as people call them

    [[nodiscard]] bool charts(const std::string& target) const { return !without_chart.contains(target); }
    [[nodiscard]] bool prints(const std::string& target) const { return !not_printed.contains(target); }
    /// The name of a target, with its id where others have the name, too; the id where none is known.
    [[nodiscard]] const std::string& name_of(const std::string& target) const {
        const auto found = names.find(target);
        return found == names.end() ? target : found->second;
    }
    [[nodiscard]] std::size_t charted() const { return all - without_chart.size(); }
};

/// Nets and other figures that have no rocks that reach them are always shown. Names are those of the first
/// run that has the target.
ShownTargets shown_targets(std::span<const FinishedRun> runs, const SideBySide& comparison);

}  // namespace coupling::compare
