#include "coupling/inputs/files/folder_names.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "config/text/joined.hpp"

namespace coupling {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view sign_between_names = " = ";

/// Signs before a name in a message.
constexpr std::string_view signs_before_names = " '\"(=,;:";

/// "outside/" of "outside/maps/dem.asc".
std::string first_folder(const std::string& shown) {
    return shown.substr(0, shown.find('/') + 1);
}

/// What settings write before the names of files in folders elsewhere.
std::map<std::string, std::string> folders_of(
    const std::vector<std::pair<std::string, std::string>>& settings) {
    std::map<std::string, std::string> folders;
    for (const auto& [shown, written] : settings) {
        folders.try_emplace(first_folder(shown), (fs::path{written}.parent_path() / "").generic_string());
    }
    return folders;
}

}  // namespace

FolderNames folder_names(const InputNames& names,
                         const std::vector<std::pair<std::string, std::string>>& settings) {
    constexpr int most_folders = 1000;
    const std::map<std::string, std::string> of_settings = folders_of(settings);
    FolderNames folders;
    for (int number = 1; number <= most_folders; ++number) {
        const std::string prefix = config::joined(
            outside_folder, number == 1 ? "" : config::joined("_", std::to_string(number)), "/");
        const std::string path = names.path_of(prefix);
        if (path != prefix) {
            const auto named = of_settings.find(prefix);
            folders.emplace_back(prefix, named != of_settings.end() ? named->second : path);
        }
    }
    return folders;
}

FolderNames folder_names_on_pages(const InputNames& names,
                                  const std::vector<std::pair<std::string, std::string>>& settings) {
    const std::map<std::string, std::string> of_settings = folders_of(settings);
    FolderNames folders = folder_names(names, settings);
    for (auto& [prefix, name] : folders) {
        // A line break would end the line that an archive keeps.
        if (!of_settings.contains(prefix) || fs::path{name}.is_absolute() ||
            name.find('\n') != std::string::npos) {
            name.clear();
        }
    }
    return folders;
}

std::string with_folder_names(std::string text, const FolderNames& folders) {
    for (std::size_t at = text.find(outside_folder); at != std::string::npos;
         at = text.find(outside_folder, at)) {
        const bool begins = at == 0 || signs_before_names.find(text[at - 1]) != std::string_view::npos;
        const auto named = std::find_if(folders.begin(), folders.end(), [&](const auto& each) {
            return text.compare(at, each.first.size(), each.first) == 0;
        });
        if (begins && named != folders.end()) {
            text.replace(at, named->first.size(), named->second);
            at += named->second.size();
        } else {
            ++at;
        }
    }
    return text;
}

std::string text_of(const FolderNames& folders) {
    std::string text;
    for (const auto& [prefix, name] : folders) {
        text += config::joined(prefix, sign_between_names, name, "\n");
    }
    return text;
}

FolderNames folder_names_of(std::string_view text) {
    FolderNames folders;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        if (const std::size_t sign = line.find(sign_between_names); sign != std::string_view::npos) {
            folders.emplace_back(line.substr(0, sign), line.substr(sign + sign_between_names.size()));
        }
        text.remove_prefix(std::min(text.size(), line.size() + 1));
    }
    return folders;
}

}  // namespace coupling
