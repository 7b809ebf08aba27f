#include "validation/engine/kinds/scenario_changes.hpp"

#include <string_view>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"

namespace coupling::validation {

void take_changes_of_a_scenario(ValidationCase& out) {
    if (out.replaces_profile()) {
        config::fail(config::ExitCode::settings, {}, config::joined("--profile for ", out.files.name),
                     "a case with a profile: this one has a terrain");
    }
    constexpr std::string_view seed_of_series = "series.seed=";
    for (std::string& change : out.changes.overrides) {
        if (change.starts_with(seed_of_series)) {
            change = config::joined("run.seed=", change.substr(seed_of_series.size()));
        }
    }
    if (out.changes.most_rocks) {
        out.notes.emplace_back("--rocks changes nothing here: the scenario says how many rocks fall");
    }
}

}  // namespace coupling::validation
