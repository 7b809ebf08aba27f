#pragma once

#include <string>
#include <vector>

#include "config/options/options.hpp"

namespace rockfall {

using Presets = std::vector<config::Preset>;

/// A value that all three published variants share: they differ from the default in the same way.
inline Presets published(const std::string& value) {
    return {{"strict", value}, {"paper_rebound", value}, {"paper_initial", value}};
}

/// What is switched off in the initial model of the paper (its section 3.1), and what in the step after it.
inline Presets from_rebound_on(const std::string& initial) {
    return {{"paper_initial", initial}};
}
inline Presets from_final_on(const std::string& earlier) {
    return {{"paper_rebound", earlier}, {"paper_initial", earlier}};
}

}  // namespace rockfall
