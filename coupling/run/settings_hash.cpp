#include "coupling/run/settings_hash.hpp"

#include <set>
#include <sstream>

#include "coupling/inputs/file_bytes.hpp"
#include "coupling/version.hpp"

namespace coupling {
namespace {

/// What only the hazard map heeds: it is made from finished falls and changes none of them.
const std::set<std::string>& settings_after_the_falls() {
    static const std::set<std::string> keys{"hazard.energy", "hazard.least_reach_percent", "hazard.matrix"};
    return keys;
}

}  // namespace

std::string settings_hash(const Scenario& scenario, std::span<const InputFile> inputs) {
    std::ostringstream text;
    text << version() << '\n';
    scenario.options->write_ini(text, false, settings_after_the_falls());
    for (const InputFile& input : inputs) {
        text << input.role << ' ' << input.hash << '\n';
    }
    return hash_text(text.str());
}

}  // namespace coupling
