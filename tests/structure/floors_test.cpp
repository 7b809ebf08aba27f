// The floors of `coupling`: who may include whom among its rooms, read off the sources.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace structure::floors_test {
namespace {

namespace fs = std::filesystem;

/// From the top floor to the bottom one. A room may include rooms of its own floor and of those below it.
/// Rooms that do not exist yet have their place already.
const std::vector<std::vector<std::string>> floors{
    {"commands"},
    {"vary", "pack"},
    {"decades", "hazard"},
    {"today"},
    {"nets", "profile", "compare", "validation", "stopping", "calibrate", "collapse"},
    {"run", "exchange", "regimes", "rockyfor3d"},
    {"results", "observed"},
    {"inputs"},
    {"files"},
    {"page_scripts", "examples", "files"}};

/// One include of a room by a file of another room.
struct Include {
    std::string from;
    std::string to;
    std::string file;
};

std::map<std::string, std::size_t> floor_by_room() {
    std::map<std::string, std::size_t> numbers;
    for (std::size_t i = 0; i < floors.size(); ++i) {
        for (const std::string& room : floors[i]) {
            numbers[room] = i;
        }
    }
    return numbers;
}

std::vector<Include> includes_between_rooms() {
    static const std::regex include{"#include \"coupling/([a-z0-9_]+)/"};
    const fs::path coupling = fs::path{BANNWALD_SOURCE_DIR} / "coupling";
    std::vector<Include> includes;
    for (const fs::directory_entry& room : fs::directory_iterator{coupling}) {
        if (!room.is_directory()) {
            continue;
        }
        const std::string from = room.path().filename().string();
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator{room.path()}) {
            if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") {
                continue;
            }
            std::ifstream in{entry.path()};
            const std::string text{std::istreambuf_iterator<char>{in}, {}};
            for (std::sregex_iterator at{text.begin(), text.end(), include}; at != std::sregex_iterator{};
                 ++at) {
                if ((*at)[1] != from) {
                    includes.push_back(
                        {from, (*at)[1], fs::relative(entry.path(), coupling).generic_string()});
                }
            }
        }
    }
    return includes;
}

TEST(Floors, HaveEveryRoomOfCoupling) {
    const auto floor_of = floor_by_room();
    for (const Include& include : includes_between_rooms()) {
        EXPECT_TRUE(floor_of.contains(include.from)) << include.from;
        EXPECT_TRUE(floor_of.contains(include.to)) << include.to << ", included by " << include.file;
    }
}

TEST(Floors, AreIncludedFromAboveOnly) {
    const auto floor_of = floor_by_room();
    const std::vector<Include> includes = includes_between_rooms();
    ASSERT_GT(includes.size(), 100U);
    for (const Include& include : includes) {
        EXPECT_LE(floor_of.at(include.from), floor_of.at(include.to))
            << "coupling/" << include.file << " includes coupling/" << include.to
            << ", which stands above it";
    }
}

TEST(Floors, HaveNoTwoRoomsThatIncludeEachOther) {
    std::set<std::pair<std::string, std::string>> pairs;
    for (const Include& include : includes_between_rooms()) {
        pairs.emplace(include.from, include.to);
    }
    for (const auto& [from, to] : pairs) {
        EXPECT_FALSE(pairs.contains({to, from})) << from << " and " << to;
    }
}

TEST(Floors, LeavePageScriptsOnConfigAlone) {
    for (const Include& include : includes_between_rooms()) {
        EXPECT_NE(include.from, "page_scripts") << include.file << " includes coupling/" << include.to;
    }
}

}  // namespace
}  // namespace structure::floors_test
