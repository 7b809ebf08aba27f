#include "coupling/exchange/regimes/shipped.hpp"

// Each file becomes a pair of symbols around its bytes. The list of files is written by
// coupling/CMakeLists.txt.
#define REGIME_FILE(number, folder, name)                                                                 \
    asm(".pushsection .rodata\n"                                                                          \
        ".hidden bannwald_regime_" #number "_begin\n.globl bannwald_regime_" #number                      \
        "_begin\nbannwald_regime_" #number "_begin:\n.incbin \"" BANNWALD_REGIMES_DIR "/" folder "/" name \
        "\"\n.hidden bannwald_regime_" #number "_end\n.globl bannwald_regime_" #number                    \
        "_end\nbannwald_regime_" #number "_end:\n.byte 0\n.popsection\n");                                \
    extern "C" const char bannwald_regime_##number##_begin[];                                             \
    extern "C" const char bannwald_regime_##number##_end[];
#include "regime_files.inc"
#undef REGIME_FILE

namespace coupling {

namespace {

struct ShippedRegime {
    std::string name;
    std::string_view text;
};

std::vector<ShippedRegime> all_regimes() {
    constexpr std::size_t ending = 4;  // .csv
    std::vector<ShippedRegime> regimes;
    std::string file;
#define REGIME_FILE(number, folder, name)                    \
    file = name;                                             \
    regimes.push_back({file.substr(0, file.size() - ending), \
                       {bannwald_regime_##number##_begin, bannwald_regime_##number##_end}});
#include "regime_files.inc"
#undef REGIME_FILE
    return regimes;
}

}  // namespace

std::vector<std::string> shipped_regime_names() {
    std::vector<std::string> names;
    for (const ShippedRegime& regime : all_regimes()) {
        names.push_back(regime.name);
    }
    return names;
}

std::string_view shipped_regime(std::string_view name) {
    for (const ShippedRegime& regime : all_regimes()) {
        if (regime.name == name) {
            return regime.text;
        }
    }
    return {};
}

}  // namespace coupling
