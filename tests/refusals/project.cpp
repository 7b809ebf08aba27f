#include "tests/refusals/project.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "config/data/shipped_tables.hpp"
#include "coupling/examples/embedded.hpp"
#include "tests/coupling/assessments/profile/profile_project.hpp"
#include "tests/coupling/inputs/forest_project.hpp"
#include "tests/coupling/inputs/formats/given_files.hpp"
#include "validation/engine/case/case_files.hpp"

namespace coupling::refusals {
namespace {

/// So many rocks that nobody is warned of few.
template <class Project>
std::unique_ptr<SampleProject> with_many_rocks() {
    auto project = std::make_unique<Project>();
    project->replace("scenario.ini", "rocks_per_source = 5\n", "rocks_per_source = 2500\n");
    return project;
}

std::unique_ptr<SampleProject> empty_project() {
    auto project = std::make_unique<SampleProject>();
    std::filesystem::remove_all(project->folder());
    std::filesystem::create_directory(project->folder());
    return project;
}

std::unique_ptr<SampleProject> example(const std::string& name) {
    std::unique_ptr<SampleProject> project = empty_project();
    for (const ExampleFile& file : example_files()) {
        if (file.example == name) {
            project->write(file.name, std::string{file.bytes});
        }
    }
    return project;
}

/// A case of validation in a folder of its name.
std::unique_ptr<SampleProject> validation_case(const std::string& name) {
    std::unique_ptr<SampleProject> project = empty_project();
    for (const validation::CaseFiles& files : validation::shipped_cases()) {
        if (files.name == name) {
            std::filesystem::create_directory(project->file(name));
            for (const auto& [file, text] : files.texts) {
                project->write(name + "/" + file, text);
            }
            return project;
        }
    }
    throw std::runtime_error{"no case '" + name + "'"};
}

/// A text in which `\\n` stands for a line end and `\\x0a` for a byte.
std::string unescaped(const std::string& text) {
    static const std::regex escape{R"(\\n|\\x([0-9a-f]{2}))"};
    std::string result;
    std::size_t done = 0;
    for (std::sregex_iterator at{text.begin(), text.end(), escape}, end; at != end; ++at) {
        const auto begin = static_cast<std::size_t>(at->position());
        result += text.substr(done, begin - done);
        result += (*at)[1].matched ? static_cast<char>(std::stoi((*at)[1], nullptr, 16)) : '\n';
        done = begin + static_cast<std::size_t>(at->length());
    }
    return result + text.substr(done);
}

/// The first place of a text, or all of them.
void replace_text(const SampleProject& project, const std::string& file, const std::string& from,
                  const std::string& to, bool all) {
    std::string text = project.read(file);
    std::size_t at = text.find(from);
    if (at == std::string::npos) {
        throw std::runtime_error{file + " does not hold this text"};
    }
    do {
        text.replace(at, from.size(), to);
        at = text.find(from, at + to.size());
    } while (all && at != std::string::npos);
    project.write(file, text);
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in{text};
    for (std::string line; std::getline(in, line);) {
        lines.push_back(line);
    }
    return lines;
}

std::string text_of(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += line + "\n";
    }
    return text;
}

/// The first and last index of "5", "2-4" or "*" of so many rows or columns.
std::pair<std::size_t, std::size_t> indices_of(const std::string& range, std::size_t count) {
    if (range == "*") {
        return {0, count - 1};
    }
    const std::size_t dash = range.find('-');
    const std::size_t first = std::stoul(range);
    const std::size_t last = dash == std::string::npos ? first : std::stoul(range.substr(dash + 1));
    if (first == 0 || last > count) {
        throw std::runtime_error{"no " + range + " among " + std::to_string(count)};
    }
    return {first - 1, last - 1};
}

/// Sets cells of an ESRI ASCII grid, whose header is the lines that begin with a letter.
void set_cells(const SampleProject& project, const std::string& file, const std::string& row_range,
               const std::string& column_range, const std::string& value) {
    std::vector<std::string> lines = lines_of(project.read(file));
    std::size_t header = 0;
    while (header < lines.size() && std::isalpha(static_cast<unsigned char>(lines[header][0])) != 0) {
        ++header;
    }
    const auto [first_row, last_row] = indices_of(row_range, lines.size() - header);
    for (std::size_t row = first_row; row <= last_row; ++row) {
        std::istringstream in{lines[header + row]};
        std::vector<std::string> cells{std::istream_iterator<std::string>{in}, {}};
        const auto [first, last] = indices_of(column_range, cells.size());
        std::fill(cells.begin() + static_cast<std::ptrdiff_t>(first),
                  cells.begin() + static_cast<std::ptrdiff_t>(last) + 1, value);
        lines[header + row].clear();
        for (const std::string& cell : cells) {
            lines[header + row] += cell + " ";
        }
    }
    project.write(file, text_of(lines));
}

void set_line(const SampleProject& project, const std::string& file, std::size_t number,
              const std::string& text) {
    std::vector<std::string> lines = lines_of(project.read(file));
    if (number == lines.size() + 1) {
        lines.emplace_back();
    }
    lines.at(number - 1) = text;
    project.write(file, text_of(lines));
}

}  // namespace

std::unique_ptr<SampleProject> make_project(const std::string& name) {
    if (name == "sample") {
        return with_many_rocks<SampleProject>();
    }
    if (name == "forest") {
        return with_many_rocks<ForestProject>();
    }
    if (name == "regimes") {
        auto project = with_many_rocks<ForestProject>();
        for (const char* regime :
             {"salvage_only.csv", "groups_fenced.csv", "corridors_selection.csv", "thin_spruce.csv"}) {
            std::filesystem::copy_file(std::string{BANNWALD_SOURCE_DIR "/tests/runs/regime_study/"} + regime,
                                       project->file(regime));
        }
        return project;
    }
    if (name == "profile") {
        auto project = std::make_unique<SampleProject>();
        make_profile_project(*project);
        return project;
    }
    if (name == "formats") {
        auto project = std::make_unique<SampleProject>();
        take_given_files(*project);
        return project;
    }
    if (name.starts_with("case ")) {
        return validation_case(name.substr(name.find(' ') + 1));
    }
    const std::vector<std::string> examples = example_names();
    const std::string word = name.substr(name.find(' ') + 1);
    if (name.starts_with("example ") && std::find(examples.begin(), examples.end(), word) != examples.end()) {
        return example(word);
    }
    throw std::runtime_error{"no project '" + name + "'"};
}

void change(const SampleProject& project, const std::string& line, const std::string& content) {
    static const std::regex replace{R"(replace (all )?(.+?): (.*?) =>(?: (.*))?)"};
    static const std::regex write{R"(write (.+))"};
    static const std::regex set{R"(line (.+?) (\d+): (.*))"};
    static const std::regex remove{R"(remove (.+))"};
    static const std::regex shipped{R"(shipped (.+))"};
    static const std::regex cut{R"(cut (.+) to (\d+) %)"};
    static const std::regex cell{R"(cell (\S+) row (\S+) column (\S+) = (.*))"};
    std::smatch part;
    if (std::regex_match(line, part, replace)) {
        replace_text(project, part[2], unescaped(part[3]), unescaped(part[4]), part[1].matched);
    } else if (std::regex_match(line, part, write)) {
        std::filesystem::create_directories(project.file(part[1]).parent_path());
        project.write(part[1], content);
    } else if (std::regex_match(line, part, set)) {
        set_line(project, part[1], std::stoul(part[2]), part[3]);
    } else if (std::regex_match(line, part, shipped)) {
        project.write(part[1], std::string{config::shipped_table(part[1].str())});
    } else if (std::regex_match(line, part, cut)) {
        const std::string bytes = project.read(part[1]);
        project.write(part[1], bytes.substr(0, bytes.size() * std::stoul(part[2]) / 100));
    } else if (std::regex_match(line, part, remove)) {
        if (!std::filesystem::remove(project.file(part[1]))) {
            throw std::runtime_error{"no file " + part[1].str()};
        }
    } else if (std::regex_match(line, part, cell)) {
        set_cells(project, part[1], part[2], part[3], part[4]);
    } else {
        throw std::runtime_error{"a line without meaning"};
    }
}

}  // namespace coupling::refusals
