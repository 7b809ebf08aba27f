#include "validation/engine/years/changed_laws.hpp"

#include <map>
#include <set>

#include "config/text/joined.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "forest/parameters.hpp"

namespace coupling::validation::years {

using config::joined;

std::string changed_laws(std::span<const Scenario* const> scenarios) {
    config::Options declared;
    forest::Parameters defaults;
    forest::declare(declared, defaults);
    std::set<std::string> known;
    for (const config::ParameterRow& row : declared.rows()) {
        known.insert(row.key);
    }
    std::map<std::string, std::set<std::string>> values;
    std::set<std::string> changed;
    for (const Scenario* scenario : scenarios) {
        for (const config::ParameterRow& row : scenario->options->rows()) {
            if (known.contains(row.key)) {
                values[row.key].insert(row.value_text);
            }
            if (known.contains(row.key) && row.changed) {
                changed.insert(row.key);
            }
        }
    }
    std::string laws;
    for (const std::string& key : changed) {
        const std::set<std::string>& all = values.at(key);
        laws += joined(laws.empty() ? "" : ", ", key, all.size() == 1 ? " = " : " by site",
                       all.size() == 1 ? *all.begin() : "");
    }
    return laws;
}

}  // namespace coupling::validation::years
