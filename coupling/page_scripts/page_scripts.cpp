#include "coupling/page_scripts/page_scripts.hpp"

#include "config/text/base64.hpp"
#include "config/text/embedded.hpp"
#include "config/text/joined.hpp"

BANNWALD_EMBED(charts_js, BANNWALD_SCRIPTS_DIR "/charts.js")
BANNWALD_EMBED(slope_js, BANNWALD_SCRIPTS_DIR "/slope.js")
BANNWALD_EMBED(nets_js, BANNWALD_SCRIPTS_DIR "/nets.js")

namespace coupling::page_scripts {
namespace {

using config::joined;

int digit(char hexadecimal) {
    return hexadecimal <= '9' ? hexadecimal - '0' : hexadecimal - 'a' + 10;
}

std::string bytes_of(std::string_view hexadecimal) {
    std::string bytes;
    for (std::size_t i = 0; i + 1 < hexadecimal.size(); i += 2) {
        bytes += static_cast<char>(16 * digit(hexadecimal[i]) + digit(hexadecimal[i + 1]));
    }
    return bytes;
}

}  // namespace

Script charts() {
    return {BANNWALD_EMBEDDED(charts_js), BANNWALD_CHARTS_SHA256};
}

Script slope() {
    return {BANNWALD_EMBEDDED(slope_js), BANNWALD_SLOPE_SHA256};
}

Script nets() {
    return {BANNWALD_EMBEDDED(nets_js), BANNWALD_NETS_SHA256};
}

std::string policy(const std::vector<Script>& scripts) {
    std::string sources;
    for (const Script& script : scripts) {
        sources += joined(" 'sha256-", config::base64(bytes_of(script.sha256_hex)), "'");
    }
    return joined("default-src 'none'; img-src data:; style-src 'unsafe-inline'",
                  scripts.empty() ? "" : joined("; script-src", sources));
}

}  // namespace coupling::page_scripts
