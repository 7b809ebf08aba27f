#include "tests/structure/house.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

namespace structure {
namespace {

namespace fs = std::filesystem;

Unit unit_of(const std::string& file) {
    return file.substr(0, file.rfind('.'));
}

std::map<Unit, std::set<Unit>> read_includes() {
    static const std::regex include{"#include \"([a-z0-9_/]+)\\.hpp\""};
    const fs::path root{BANNWALD_SOURCE_DIR};
    std::map<Unit, std::set<Unit>> includes;
    for (const std::string_view room : rooms_of_the_house) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator{root / room}) {
            if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") {
                continue;
            }
            const Unit unit = unit_of(fs::relative(entry.path(), root).generic_string());
            std::set<Unit>& of_unit = includes[unit];
            std::ifstream in{entry.path()};
            const std::string text{std::istreambuf_iterator<char>{in}, {}};
            for (std::sregex_iterator at{text.begin(), text.end(), include}; at != std::sregex_iterator{};
                 ++at) {
                if ((*at)[1] != unit) {
                    of_unit.insert((*at)[1]);
                }
            }
        }
    }
    return includes;
}

/// The algorithm of Tarjan for strongly connected parts of a graph.
class RingSearch {
public:
    explicit RingSearch(const std::map<Unit, std::set<Unit>>& includes) : includes_{includes} {
        for (const auto& [unit, of_unit] : includes_) {
            if (!number_.contains(unit)) {
                visit(unit);
            }
        }
    }
    [[nodiscard]] const std::vector<std::vector<Unit>>& rings() const { return rings_; }

private:
    void visit(const Unit& unit) {
        number_[unit] = lowest_[unit] = number_.size();
        stack_.push_back(unit);
        for (const Unit& other : includes_.at(unit)) {
            if (!includes_.contains(other)) {
                continue;
            }
            if (!number_.contains(other)) {
                visit(other);
                lowest_[unit] = std::min(lowest_[unit], lowest_[other]);
            } else if (std::find(stack_.begin(), stack_.end(), other) != stack_.end()) {
                lowest_[unit] = std::min(lowest_[unit], number_[other]);
            }
        }
        if (lowest_[unit] == number_[unit]) {
            const auto first = std::find(stack_.begin(), stack_.end(), unit);
            if (stack_.end() - first > 1) {
                rings_.emplace_back(first, stack_.end());
            }
            stack_.erase(first, stack_.end());
        }
    }

    const std::map<Unit, std::set<Unit>>& includes_;
    std::map<Unit, std::size_t> number_;
    std::map<Unit, std::size_t> lowest_;
    std::vector<Unit> stack_;
    std::vector<std::vector<Unit>> rings_;
};

}  // namespace

const std::map<Unit, std::set<Unit>>& includes_by_unit() {
    static const std::map<Unit, std::set<Unit>> includes = read_includes();
    return includes;
}

std::string folder_of(const std::string& name) {
    const auto slash = name.rfind('/');
    return slash == std::string::npos ? "" : name.substr(0, slash);
}

bool lies_below(const std::string& folder, const std::string& other) {
    return folder.size() > other.size() && folder.starts_with(other) && folder[other.size()] == '/';
}

std::pair<std::string, std::string> folders_side_by_side(const Unit& one, const Unit& other) {
    const std::string a = folder_of(one) + '/', b = folder_of(other) + '/';
    const auto differ = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    if (differ.first == a.end() || differ.second == b.end()) {
        return {a, a};
    }
    // Back to the begin of the first different name, and on to its end.
    const auto begin = a.rfind('/', static_cast<std::size_t>(differ.first - a.begin()));
    const std::size_t from = begin == std::string::npos ? 0 : begin + 1;
    return {a.substr(0, a.find('/', from)), b.substr(0, b.find('/', from))};
}

std::vector<std::vector<Unit>> rings_of_units() {
    const RingSearch search{includes_by_unit()};
    std::vector<std::vector<Unit>> rings = search.rings();
    std::sort(rings.begin(), rings.end(),
              [](const auto& one, const auto& other) { return one.size() > other.size(); });
    return rings;
}

std::vector<Source> sources_below(const std::string& room) {
    const fs::path root{BANNWALD_SOURCE_DIR};
    std::vector<Source> sources;
    if (!fs::exists(root / room)) {
        return sources;
    }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{root / room}) {
        const std::string ending = entry.path().extension().string();
        if (entry.is_regular_file() && (ending == ".hpp" || ending == ".cpp")) {
            std::ifstream in{entry.path()};
            std::ostringstream text;
            text << in.rdbuf();
            sources.push_back({fs::relative(entry.path(), root).generic_string(), text.str()});
        }
    }
    return sources;
}

}  // namespace structure
