// The floors of the house: who may include whom, read off the sources.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/structure/house.hpp"

namespace structure::floors_test {
namespace {

/// Rooms side by side in a folder, from the top floor to the bottom one. A room may include rooms of its own
/// floor and of those below it. Rooms that do not exist yet have their place already.
struct Floors {
    std::string folder;
    std::vector<std::vector<std::string>> rooms;
};

const std::vector<Floors> houses{
    {"", {{"validation"}, {"coupling"}, {"rockfall", "forest"}, {"config"}}},
    {"coupling",
     {{"program"},
      {"assessments"},
      {"run", "exchange"},
      {"results"},
      {"inputs"},
      {"page_scripts", "examples"}}},
    {"coupling/assessments",
     {{"optimise", "vary", "models"},
      {"calibrate", "decades", "hazard"},
      {"today"},
      {"nets", "works", "profile", "compare", "stopping", "collapse", "consequences"}}}};

/// `main` is the only one that knows the program and its validation.
const Unit top = "coupling/main";

/// Folders whose files include a file of the folder around them: what is left of a habit. None may be added.
const std::set<std::pair<Unit, Unit>> known_ways_up{
    {"coupling/assessments/profile/report/profile_page", "coupling/assessments/profile/profile_results"},
    {"rockfall/motion/rigid/fall", "rockfall/motion/bare_twin"},
    {"rockfall/motion/rigid/fall", "rockfall/motion/fall"},
    {"rockfall/motion/rigid/start", "rockfall/motion/fall"}};

/// Folders side by side that include each other.
const std::set<std::pair<std::string, std::string>> known_pairs{{"config/errors", "config/text"}};

constexpr std::size_t most_units_of_a_folder = 25;
constexpr std::size_t most_units_of_a_ring = 5;

TEST(Floors, AreIncludedFromAboveOnly) {
    for (const auto& [folder, rooms] : houses) {
        std::map<std::string, std::size_t> floor_of;
        for (std::size_t i = 0; i < rooms.size(); ++i) {
            for (const std::string& room : rooms[i]) {
                floor_of[folder.empty() ? room : folder + '/' + room] = i;
            }
        }
        std::size_t seen = 0;
        for (const auto& [unit, of_unit] : includes_by_unit()) {
            for (const Unit& other : of_unit) {
                const auto [from, to] = folders_side_by_side(unit, other);
                if (unit == top || from == to || folder_of(from) != folder) {
                    continue;
                }
                ++seen;
                ASSERT_TRUE(floor_of.contains(from)) << from << " has no floor; includes " << other;
                ASSERT_TRUE(floor_of.contains(to)) << to << " has no floor; included by " << unit;
                EXPECT_LE(floor_of.at(from), floor_of.at(to))
                    << unit << " includes " << other << ", which stands above it";
            }
        }
        EXPECT_GT(seen, 10U) << folder;
    }
}

TEST(Floors, HaveFoldersThatStandBelowTheirParent) {
    std::set<std::pair<Unit, Unit>> ways_up;
    for (const auto& [unit, of_unit] : includes_by_unit()) {
        for (const Unit& other : of_unit) {
            if (lies_below(folder_of(unit), folder_of(other))) {
                ways_up.emplace(unit, other);
            }
        }
    }
    for (const auto& [unit, other] : ways_up) {
        EXPECT_TRUE(known_ways_up.contains({unit, other})) << unit << " includes " << other;
    }
    for (const auto& [unit, other] : known_ways_up) {
        EXPECT_TRUE(ways_up.contains({unit, other}))
            << unit << " no longer includes " << other << ": take it off the list";
    }
}

TEST(Floors, HaveNoTwoFoldersThatIncludeEachOther) {
    std::set<std::pair<std::string, std::string>> pairs;
    for (const auto& [unit, of_unit] : includes_by_unit()) {
        for (const Unit& other : of_unit) {
            const auto pair = folders_side_by_side(unit, other);
            if (unit != top && pair.first != pair.second) {
                pairs.insert(pair);
            }
        }
    }
    for (const auto& [from, to] : pairs) {
        const bool is_known = known_pairs.contains({from, to}) || known_pairs.contains({to, from});
        EXPECT_TRUE(is_known || !pairs.contains({to, from})) << from << " and " << to;
    }
}

TEST(Floors, HaveFoldersThatOneOverlooks) {
    std::map<std::string, std::size_t> units;
    for (const auto& [unit, of_unit] : includes_by_unit()) {
        ++units[folder_of(unit)];
    }
    EXPECT_GT(units.size(), 50U);
    for (const auto& [folder, count] : units) {
        EXPECT_LE(count, most_units_of_a_folder) << folder;
    }
}

TEST(Floors, HaveNoLargeRingsOfUnits) {
    for (const std::vector<Unit>& ring : rings_of_units()) {
        std::string names;
        for (const Unit& unit : ring) {
            names += unit + ' ';
        }
        EXPECT_LE(ring.size(), most_units_of_a_ring) << names;
    }
}

TEST(Floors, LeavePageScriptsOnConfigAlone) {
    for (const auto& [unit, of_unit] : includes_by_unit()) {
        for (const Unit& other : of_unit) {
            EXPECT_FALSE(unit.starts_with("coupling/page_scripts/") && other.starts_with("coupling/") &&
                         !other.starts_with("coupling/page_scripts/"))
                << unit << " includes " << other;
        }
    }
}

}  // namespace
}  // namespace structure::floors_test
