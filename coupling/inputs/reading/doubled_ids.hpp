#pragma once

#include <set>
#include <string>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling {

/// Warns where things of a list (with a member `id`) share their name: results could not tell them apart.
template <class Things>
void warn_of_doubled_ids(const Things& things, const std::string& column, const std::string& advice,
                         const std::string& file, Reading& reading) {
    std::set<std::string> seen;
    std::set<std::string> doubled;
    for (const auto& thing : things) {
        if (!seen.insert(thing.id).second) {
            doubled.insert(thing.id);
        }
    }
    if (!doubled.empty()) {
        reading.warn({file},
                     config::joined(counted(doubled.size(), column), " used more than once, such as ",
                                    config::in_quotes(*doubled.begin())),
                     config::joined("one ", column, " for each ", column.substr(0, column.find('_'))), advice,
                     config::Effect::detail);
    }
}

}  // namespace coupling
