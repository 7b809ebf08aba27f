#pragma once

#include <string>

#include "config/options/options.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling {

/// Whether a setting's line says GUESS in the comment behind its value, as `bannwald init` writes it.
bool is_guess(const config::Options& options, const std::string& key);

/// Warns of the settings that are still guesses, all of them in one sentence.
void doubt_guesses(Reading& reading);

}  // namespace coupling
