// The rules of the rooms, read off the sources: who may include whom, who opens files, who knows CGAL and
// options.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/structure/house.hpp"

namespace {

using structure::Source;
using structure::sources_below;

namespace fs = std::filesystem;

/// Names of the sources of a room in which a pattern occurs.
std::vector<std::string> users_of(const std::string& pattern, const std::string& room) {
    const std::regex wanted{pattern};
    std::vector<std::string> users;
    for (const Source& source : sources_below(room)) {
        if (std::regex_search(source.text, wanted)) {
            users.push_back(source.name);
        }
    }
    std::sort(users.begin(), users.end());
    return users;
}

/// The same of several rooms.
std::vector<std::string> users_of(const std::string& pattern, const std::vector<std::string>& rooms) {
    std::vector<std::string> users;
    for (const std::string& room : rooms) {
        for (std::string& user : users_of(pattern, room)) {
            users.push_back(std::move(user));
        }
    }
    return users;
}

/// The rooms that know files, threads and users.
const std::vector<std::string> above_physics{"coupling", "validation"};

const std::vector<std::string> nobody;

TEST(Rooms, AreFoundAtAll) {
    EXPECT_GT(sources_below("config").size(), 10U);
    EXPECT_GT(sources_below("rockfall").size(), 20U);
    EXPECT_GT(sources_below("forest").size(), 1U);
    EXPECT_GT(sources_below("coupling").size(), 20U);
}

TEST(Rooms, IncludeOnlyDownwards) {
    EXPECT_EQ(users_of("#include \"(rockfall|forest|coupling|validation|tests)/", "config"), nobody);
    EXPECT_EQ(users_of("#include \"(forest|coupling|validation|tests)/", "rockfall"), nobody);
    EXPECT_EQ(users_of("#include \"(rockfall|coupling|validation|tests)/", "forest"), nobody);
    EXPECT_EQ(users_of("#include \"tests/", above_physics), nobody);
}

TEST(Rooms, WriteIncludesFromTheRoot) {
    for (const std::string room : {"config", "rockfall", "forest", "coupling", "validation"}) {
        EXPECT_EQ(
            users_of("#include \"(?!config/|rockfall/|forest/|coupling/|validation/engine/|[a-z_]+\\.inc\")",
                     room),
            nobody);
    }
}

TEST(Rooms, LeaveFilesToTheCouplingRoom) {
    for (const std::string room : {"config", "rockfall", "forest"}) {
        EXPECT_EQ(users_of("#include <(fstream|filesystem|cstdio)>|mapped_file", room), nobody);
    }
}

TEST(Rooms, ReadFilesByOneReader) {
    // A stream takes a read error for the end of the file, and a mapping ends the process
    // (coupling/inputs/own_files).
    EXPECT_EQ(users_of("ifstream|mapped_file|\\b(fopen|freopen|fdopen|fread|mmap) *\\(", above_physics),
              nobody);
    EXPECT_EQ(users_of("[ (]::p?readv? *\\(", above_physics),
              (std::vector<std::string>{"coupling/inputs/own_files/file_reader.cpp",
                                        "coupling/run/folder_lock.cpp"}));
    // Lines and letters are taken from texts in memory only.
    const std::vector<std::string> of_texts = users_of("istringstream", above_physics);
    for (const std::string& user : users_of("std::getline|istreambuf_iterator", above_physics)) {
        EXPECT_NE(std::find(of_texts.begin(), of_texts.end(), user), of_texts.end()) << user;
    }
}

TEST(Rooms, RepeatCallsThatASignalInterrupts) {
    for (const Source& source : sources_below("coupling")) {
        if (source.name == "coupling/run/interrupt.cpp") {
            continue;  // a sentence on the screen, in a handler of signals
        }
        const std::regex call{"[ (]::(open|read|pread|write|pwrite|fsync|ftruncate|flock)\\("};
        for (auto at = std::sregex_iterator{source.text.begin(), source.text.end(), call};
             at != std::sregex_iterator{}; ++at) {
            const auto place = static_cast<std::size_t>(at->position());
            const std::size_t near = place - std::min<std::size_t>(place, 60);
            EXPECT_NE(source.text.substr(near, place - near).find("repeated("), std::string::npos)
                << source.name << ": " << at->str();
        }
    }
}

/// 0.01 * 95 is above 0.95: of 500 rocks it would be the 476th, in tables beside it the 475th.
TEST(Rooms, DividePercentilesByAHundred) {
    for (const std::string room : {"rockfall", "forest", "coupling", "validation"}) {
        EXPECT_EQ(users_of("0\\.01 \\* *(static_cast<double>\\()?[a-z_.]*percentile", room), nobody);
    }
}

TEST(Rooms, KnowNoThreadsInThePhysics) {
    for (const std::string room : {"rockfall", "forest"}) {
        EXPECT_EQ(users_of("#include <(thread|mutex|future|omp.h)>|#pragma omp", room), nobody);
    }
}

TEST(Rooms, MeetOptionsInFilesOfParametersOnly) {
    for (const std::string room : {"rockfall", "forest"}) {
        for (const std::string& user : users_of("config/options/options.hpp", room)) {
            const std::string file = fs::path{user}.stem().string();
            EXPECT_TRUE(file == "parameters" || user == "rockfall/motion/seam/presets.hpp") << user;
        }
    }
    EXPECT_EQ(users_of("boost/program_options", "rockfall"), nobody);
}

/// The names of the motion models: their rooms.
std::vector<std::string> motion_model_rooms() {
    std::vector<std::string> rooms;
    for (const fs::directory_entry& entry :
         fs::directory_iterator{fs::path{BANNWALD_SOURCE_DIR} / "rockfall/motion"}) {
        if (entry.is_directory() && fs::exists(entry.path() / "model.hpp")) {
            rooms.push_back(entry.path().filename().string());
        }
    }
    std::sort(rooms.begin(), rooms.end());
    return rooms;
}

TEST(MotionModels, AreRoomsWithADescriptor) {
    const fs::path motion = fs::path{BANNWALD_SOURCE_DIR} / "rockfall/motion";
    const std::vector<std::string> rooms = motion_model_rooms();
    EXPECT_GE(rooms.size(), 3U);
    for (const std::string& room : rooms) {
        for (const char* file : {"model.hpp", "law.hpp", "motion.hpp", "parameters.cpp", "README.md"}) {
            EXPECT_TRUE(fs::exists(motion / room / file)) << room << "/" << file;
        }
    }
}

TEST(MotionModels, AreNamedInTheirRoomAndInTheListOnly) {
    // Pages, tables and commands ask the descriptor (rockfall/motion/seam/description.hpp). A word as such:
    // the shipped table pir3d_soils is no name of a model.
    for (const std::string& model : motion_model_rooms()) {
        EXPECT_EQ(users_of("\\b" + model + "\\b", above_physics), nobody) << model;
        for (const std::string& user : users_of("\\b" + model + "(::|/)", "rockfall")) {
            EXPECT_TRUE(user.starts_with("rockfall/motion/")) << user << " names " << model;
        }
    }
    EXPECT_EQ(users_of("PiR3D|PICUS", above_physics), nobody);
}

TEST(Rooms, IncludeCgalInOneSource) {
    EXPECT_EQ(users_of("#include <CGAL/", "rockfall"), std::vector<std::string>{"rockfall/terrain/mesh.cpp"});
    for (const std::string room : {"config", "forest", "coupling"}) {
        EXPECT_EQ(users_of("#include <CGAL/", room), nobody);
    }
}

TEST(Rooms, IncludeTheJsonLibraryInOneSource) {
    EXPECT_EQ(users_of("#include <nlohmann/", above_physics).size(), 1U);
}

TEST(Rooms, IncludeTheLibraryOfStatisticsInOneSource) {
    // Its long double stops programs under valgrind, and differs between processors.
    EXPECT_EQ(users_of("#include <boost/math", {"config", "rockfall", "forest", "coupling", "validation"}),
              std::vector<std::string>{"config/random/quantiles.cpp"});
}

TEST(Rooms, KnowMpiInOneSource) {
    EXPECT_EQ(users_of("#include <(mpi\\.h|boost/mpi)|\\bMPI_[A-Z]", above_physics),
              std::vector<std::string>{"coupling/run/ranks.cpp"});
    for (const std::string room : {"config", "rockfall", "forest"}) {
        EXPECT_EQ(users_of("#include <(mpi\\.h|boost/mpi)", room), nobody);
    }
}

TEST(Rooms, DrawFromNoDistributionOfTheStandardLibrary) {
    // They give other numbers with other libraries.
    for (const std::string room : {"config", "rockfall", "forest", "coupling", "validation"}) {
        EXPECT_EQ(
            users_of(
                "std::(mt19937|uniform_real_distribution|normal_distribution|random_device)|\\brand\\(\\)",
                room),
            nobody);
    }
}

TEST(Rooms, KeepTheMathematicalLibraryOutOfFallAndForest) {
    // Elementary functions of the library may differ in the last bit between processors
    // (config/math/elementary.hpp).
    const std::string elementary =
        "std::(sin|cos|tan|asin|acos|atan|atan2|exp|exp2|log|log2|log10|pow|cbrt|hypot)\\(";
    for (const std::string room :
         {"rockfall/motion", "rockfall/obstacles", "rockfall/tally", "rockfall/terrain", "rockfall/release",
          "rockfall/solids", "rockfall/virtual_surface", "forest"}) {
        EXPECT_EQ(users_of(elementary, room), nobody) << room;
    }
    EXPECT_EQ(users_of(elementary, "config/math"), nobody);
}

TEST(Rooms, LoopOverWhatOutlivesTheLoop) {
    // What a member of a temporary refers to is gone before the first turn of the loop (C++20). A temporary
    // from braces is given a name; a span of the standard library refers to what others own.
    const std::string of_a_temporary =
        "for \\([^;{\n]*[^:]: (?!std::span)[A-Za-z_:<>]+\\{[^;\n]*\\}\\.[a-z_]+\\(";
    for (const std::string room : {"config", "rockfall", "forest", "coupling", "validation", "tests"}) {
        EXPECT_EQ(users_of(of_a_temporary, room), nobody) << room;
    }
}

TEST(Rooms, HaveATheoryChapter) {
    for (const std::string room : {"config", "rockfall", "forest", "coupling", "validation", "tests"}) {
        EXPECT_TRUE(fs::exists(fs::path{BANNWALD_SOURCE_DIR} / room / "README.md")) << room;
    }
}

TEST(Rooms, GiveEachNumberOfAnEnumerationOnce) {
    // Two purposes of random numbers with one number would share their draws.
    const std::regex enumeration{R"(enum class (\w+)[^{;]*\{([^}]*)\})"}, numbered{R"(^\s*(\w+) = (\w+))"};
    std::size_t seen = 0;
    for (const std::string room : {"config", "rockfall", "forest", "coupling", "validation"}) {
        for (const Source& source : sources_below(room)) {
            for (std::sregex_iterator e{source.text.begin(), source.text.end(), enumeration}, end; e != end;
                 ++e) {
                std::map<std::string, std::string> names;
                std::istringstream lines{e->str(2)};
                for (std::string line; std::getline(lines, line);) {
                    if (std::smatch value; std::regex_search(line, value, numbered)) {
                        ++seen;
                        const auto [first, is_new] = names.try_emplace(value.str(2), value.str(1));
                        EXPECT_TRUE(is_new) << source.name << ": " << e->str(1) << ": " << first->second
                                            << " and " << value.str(1) << " are both " << value.str(2);
                    }
                }
            }
        }
    }
    EXPECT_GT(seen, 40U);
}

TEST(Rooms, StayReadable) {
    for (const std::string room : {"config", "rockfall", "forest", "coupling", "validation"}) {
        for (const Source& source : sources_below(room)) {
            const auto lines = std::count(source.text.begin(), source.text.end(), '\n');
            EXPECT_LE(lines, 450) << source.name;
        }
    }
}

}  // namespace
