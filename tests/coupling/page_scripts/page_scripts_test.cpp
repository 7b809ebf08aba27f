#include "coupling/page_scripts/page_scripts.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace coupling::page_scripts::page_scripts_test {
namespace {

const std::filesystem::path room{BANNWALD_SOURCE_DIR "/coupling/page_scripts"};

std::string text_of(const std::filesystem::path& file) {
    std::ifstream in{file, std::ios::binary};
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

TEST(PageScripts, AreThoseThatWereBundledLast) {
    const std::string sums = text_of(room / "built/SHA256SUMS");
    EXPECT_EQ(sums, std::string{charts().sha256_hex} + "  charts.js\n" + std::string{slope().sha256_hex} +
                        "  slope.js\n" + std::string{nets().sha256_hex} + "  nets.js\n");
    EXPECT_EQ(charts().text, text_of(room / "built/charts.js"));
    EXPECT_EQ(slope().text, text_of(room / "built/slope.js"));
    EXPECT_EQ(nets().text, text_of(room / "built/nets.js"));
}

TEST(PageScripts, EndNowhereButAtTheirEndAndEvaluateNoTexts) {
    for (const Script& script : {charts(), slope(), nets()}) {
        ASSERT_GT(script.text.size(), 10'000U);
        for (const char* forbidden : {"</script", "<!--", "eval(", "new Function", "importScripts",
                                      "XMLHttpRequest(\"", "WebSocket("}) {
            EXPECT_EQ(script.text.find(forbidden), std::string_view::npos) << forbidden;
        }
    }
}

TEST(PageScripts, NameNoAddressButThoseOfXmlNamespaces) {
    const std::string allowed = "http://www.w3.org/";
    for (const Script& script : {charts(), slope(), nets()}) {
        for (const std::string scheme : {"http:", "https:", "ws:", "wss:", "ftp:"}) {
            for (std::size_t at = script.text.find(scheme + "//"); at != std::string_view::npos;
                 at = script.text.find(scheme + "//", at + 1)) {
                EXPECT_TRUE(script.text.substr(at).starts_with(allowed)) << script.text.substr(at, 60);
            }
        }
    }
}

TEST(PageScripts, CarryTheLicencesOfTheirLibraries) {
    const std::string licences = text_of(room / "built/LICENSES.txt");
    for (const char* text :
         {"Apache ECharts", "Apache License", "ZRender", "three.js authors", "Mike Bostock"}) {
        EXPECT_NE(licences.find(text), std::string::npos) << text;
    }
}

TEST(PageScripts, AreLockedToVersionsWithoutNamingAHostOfPackages) {
    const std::string lock = text_of(room / "package-lock.json");
    EXPECT_NE(lock.find("\"integrity\": \"sha512-"), std::string::npos);
    EXPECT_EQ(lock.find("\"resolved\""), std::string::npos);
}

TEST(Policy, AllowsThePagesOwnScriptsByTheirHashAndNothingElse) {
    // The hash of the empty text (FIPS 180-4 test vector), in base64.
    const Script empty{"", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"};
    EXPECT_EQ(policy({empty}),
              "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src "
              "'sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU='");
    EXPECT_EQ(policy({}).find("script-src"), std::string::npos);
}

}  // namespace
}  // namespace coupling::page_scripts::page_scripts_test
