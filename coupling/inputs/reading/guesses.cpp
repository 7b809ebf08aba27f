#include "coupling/inputs/reading/guesses.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "config/text/joined.hpp"
#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling {

using config::joined;

bool is_guess(const config::Options& options, const std::string& key) {
    return options.remark_of(key).starts_with("GUESS");
}

void doubt_guesses(Reading& reading) {
    const config::Options& options = *reading.settings().options;
    // What stands in for sources that are not drawn yet counts for nothing once they are.
    const auto& undrawn = reading.scenario().undrawn;
    const bool has_drawn_sources = std::none_of(undrawn.begin(), undrawn.end(), [](const Undrawn& each) {
        return each.is_all && each.key == "release.source_shapes";
    });
    // A setting that has no effect decides nothing; a note says so.
    std::set<std::string> without_effect;
    for (const config::IdleSettings& idle : options.idle()) {
        without_effect.insert(idle.keys.begin(), idle.keys.end());
    }
    std::string keys;
    for (const config::ParameterRow& row : options.rows()) {
        const bool is_idle = has_drawn_sources && row.key == "release.undrawn_steeper_than_deg";
        if (is_guess(options, row.key) && !is_idle && !without_effect.contains(row.key)) {
            keys += joined(keys.empty() ? "" : ", ", row.key);
        }
    }
    if (!keys.empty()) {
        reading.warn({reading.settings().file.string()}, joined("settings that are marked GUESS: ", keys),
                     "values of this slope", "check them, then take the word out of their lines",
                     config::Effect::answer);
    }
}

}  // namespace coupling
