#include "coupling/run/settings_hash.hpp"

#include <sstream>

#include "coupling/inputs/file_bytes.hpp"
#include "coupling/version.hpp"

namespace coupling {

std::string settings_hash(const Scenario& scenario, std::span<const InputFile> inputs) {
    std::ostringstream text;
    text << version() << '\n';
    scenario.options->write_ini(text, false);
    for (const InputFile& input : inputs) {
        text << input.role << ' ' << input.hash << '\n';
    }
    return hash_text(text.str());
}

}  // namespace coupling
