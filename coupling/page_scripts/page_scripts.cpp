#include "coupling/page_scripts/page_scripts.hpp"

#include "config/text/base64.hpp"
#include "config/text/joined.hpp"

// The bundles with a pair of symbols around their bytes. Their hashes come from coupling/CMakeLists.txt, so
// that another bundle is another source for compiler caches too.
#define BUNDLE(name)                                                                          \
    asm(".pushsection .rodata\n"                                                              \
        ".hidden bannwald_script_" #name "_begin\n.globl bannwald_script_" #name              \
        "_begin\nbannwald_script_" #name "_begin:\n.incbin \"" BANNWALD_SCRIPTS_DIR "/" #name \
        ".js\"\n"                                                                             \
        ".hidden bannwald_script_" #name "_end\n.globl bannwald_script_" #name                \
        "_end\nbannwald_script_" #name "_end:\n.byte 0\n.popsection\n");                      \
    extern "C" const char bannwald_script_##name##_begin[];                                   \
    extern "C" const char bannwald_script_##name##_end[];
BUNDLE(charts)
BUNDLE(slope)
#undef BUNDLE

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
    return {{bannwald_script_charts_begin, bannwald_script_charts_end}, BANNWALD_CHARTS_SHA256};
}

Script slope() {
    return {{bannwald_script_slope_begin, bannwald_script_slope_end}, BANNWALD_SLOPE_SHA256};
}

std::string policy(const std::vector<Script>& scripts) {
    std::string sources;
    for (const Script& script : scripts) {
        sources += joined(" 'sha256-", config::base64(bytes_of(script.sha256_hex)), "'");
    }
    return joined(
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
        "style-src 'unsafe-inline'",
        scripts.empty() ? "" : joined("; script-src", sources), "\"/>\n");
}

std::string elements(const std::vector<Script>& scripts) {
    std::string html;
    for (const Script& script : scripts) {
        html.append("<script>").append(script.text).append("</script>\n");
    }
    return html;
}

std::string data(std::string_view name, const std::string& json) {
    return joined("<script type=\"application/json\" class=\"", name, "\">", json, "</script>");
}

}  // namespace coupling::page_scripts
