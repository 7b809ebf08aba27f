// Files of a room are compiled together: what an unnamed namespace holds is seen by the others, too.

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/structure/house.hpp"

namespace structure {
namespace {

/// The value or type that a line declares in an unnamed namespace; "" for anything else.
std::string declared_by(const std::string& line) {
    const std::size_t end = line.find_first_of("={[;");
    const std::string head = line.substr(0, end);
    std::istringstream in{head};
    std::vector<std::string> words;
    for (std::string word; in >> word;) {
        words.push_back(word);
    }
    if (line.starts_with(' ') || words.size() < 2 || head.find('(') != std::string::npos) {
        return "";
    }
    const std::string& first = words.front();
    if (first == "struct" || first == "class") {
        return words[1];
    }
    if (first == "enum") {
        return words[words[1] == "class" ? 2 : 1];
    }
    const bool is_alias = first == "using" && end != std::string::npos && line[end] == '=';
    const bool is_value = first == "constexpr" || first == "const" || first == "thread_local";
    return is_alias || is_value ? words.back() : "";
}

/// The function that a line begins to define; functions of one name may be overloaded.
std::string function_of(const std::string& line) {
    const std::size_t end = line.find('(');
    if (end == std::string::npos || line.starts_with(' ') ||
        line.substr(0, end).find('=') != std::string::npos) {
        return "";
    }
    const std::size_t begin = line.find_last_of(" *&", end);
    return begin == std::string::npos ? "" : line.substr(begin + 1, end - begin - 1);
}

using Files = std::map<std::string, std::set<std::string>>;

/// Files by the name, with its namespaces, that their unnamed namespaces declare.
Files unnamed_names(const std::vector<Source>& sources, std::string (*declared)(const std::string& line)) {
    Files files;
    for (const Source& source : sources) {
        if (!source.name.ends_with(".cpp")) {
            continue;
        }
        std::vector<std::string> namespaces;
        std::istringstream in{source.text};
        for (std::string line; std::getline(in, line);) {
            if (line.starts_with("namespace ") && line.ends_with("{")) {
                namespaces.push_back(line == "namespace {" ? "" : line.substr(10, line.size() - 12) + "::");
            } else if (line.starts_with("}  // namespace") && !namespaces.empty()) {
                namespaces.pop_back();
            } else if (!namespaces.empty() && namespaces.back().empty()) {
                if (const std::string name = declared(line); !name.empty()) {
                    std::string whole;
                    for (const std::string& part : namespaces) {
                        whole += part;
                    }
                    files[whole + name].insert(source.name);
                }
            }
        }
    }
    return files;
}

TEST(UnnamedNames, AreFound) {
    const std::vector<Source> sources{
        {"a/one.cpp",
         "namespace a {\nnamespace {\nconstexpr double most_m = 1.0;\nstruct Place {\n"
         "    const int inner = 0;\n};\nusing Row = int;\nusing std::max;\n"
         "double share(int x) {\n}  // namespace\n}  // namespace a\n"},
        {"a/two.cpp", "namespace a {\nnamespace {\nenum class Place { left };\n"}};
    EXPECT_EQ(unnamed_names(sources, declared_by), (Files{{"a::Place", {"a/one.cpp", "a/two.cpp"}},
                                                          {"a::Row", {"a/one.cpp"}},
                                                          {"a::most_m", {"a/one.cpp"}}}));
    EXPECT_EQ(unnamed_names(sources, function_of), (Files{{"a::share", {"a/one.cpp"}}}));
}

TEST(UnnamedNames, AreThoseOfOneFileOfARoom) {
    for (const std::string_view room : rooms_of_the_house) {
        const std::vector<Source> sources = sources_below(std::string{room});
        const Files functions = unnamed_names(sources, function_of);
        for (auto [name, files] : unnamed_names(sources, declared_by)) {
            if (const auto functions_of_name = functions.find(name); functions_of_name != functions.end()) {
                files.insert(functions_of_name->second.begin(), functions_of_name->second.end());
            }
            std::string all;
            for (const std::string& file : files) {
                all += file + ' ';
            }
            EXPECT_EQ(files.size(), 1U)
                << name << " stands in " << all << "- name them apart, or keep one in a header";
        }
    }
}

}  // namespace
}  // namespace structure
