#include "coupling/inputs/reading/guesses.hpp"

#include "config/text/joined.hpp"

namespace coupling {

using config::joined;

bool is_guess(const config::Options& options, const std::string& key) {
    return options.remark_of(key).starts_with("GUESS");
}

void doubt_guesses(Reading& reading) {
    const config::Options& options = *reading.settings().options;
    std::string keys;
    for (const config::ParameterRow& row : options.rows()) {
        if (is_guess(options, row.key)) {
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
