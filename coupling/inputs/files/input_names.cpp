#include "coupling/inputs/files/input_names.hpp"

#include <algorithm>
#include <system_error>

#include "config/text/joined.hpp"

namespace coupling {
namespace {

namespace fs = std::filesystem;

/// As the disk has it, links followed as far as the path exists.
fs::path on_disk(const fs::path& path) {
    std::error_code error;
    const fs::path whole = fs::absolute(path.empty() ? "." : path, error);
    const fs::path real = fs::weakly_canonical(whole, error);
    return error ? whole.lexically_normal() : real;
}

bool leads_up(const fs::path& relative) {
    return relative.empty() || *relative.begin() == "..";
}

/// The name from the folder of the scenario; empty for a file elsewhere.
fs::path name_inside(const fs::path& name, const fs::path& path, const fs::path& folder) {
    if (name.is_relative()) {
        const fs::path plain = name.lexically_normal();
        // "link/../a" is "a" only where `link` leads to no other folder.
        const bool is_plain = on_disk(path.parent_path()) == on_disk((folder / plain).parent_path());
        if (!leads_up(plain) && is_plain) {
            return plain;
        }
    }
    const fs::path relative =
        (on_disk(path.parent_path()) / path.filename()).lexically_relative(on_disk(folder));
    return leads_up(relative) ? fs::path{} : relative;
}

/// "outside/", "outside_2/", ...
std::string prefix_of(std::size_t number) {
    return config::joined(outside_folder, number == 1 ? "" : config::joined("_", std::to_string(number)),
                          "/");
}

}  // namespace

std::string InputNames::shown(const std::string& name, const fs::path& path, const fs::path& folder) {
    if (name.empty()) {
        return "";
    }
    if (name.ends_with('/') && name.size() > 1) {  // a folder
        return shown(name.substr(0, name.find_last_not_of('/') + 1), path.parent_path(), folder);
    }
    const fs::path inside = name_inside(name, path, folder);
    std::string shown = inside.empty() ? outside(path, folder) : inside.generic_string();
    paths_[shown] = path.string();
    if (std::error_code ignored; inside.empty() && fs::is_directory(path, ignored)) {
        named_folders_[on_disk(path)] = shown;
    }
    return shown;
}

std::string InputNames::outside(const fs::path& path, const fs::path& folder) {
    const fs::path elsewhere = on_disk(path.parent_path());
    if (const auto named = named_folders_.find(elsewhere); named != named_folders_.end()) {
        return config::joined(named->second, "/", path.filename().string());
    }
    auto known = std::find_if(folders_.begin(), folders_.end(),
                              [&](const Folder& each) { return each.path == elsewhere; });
    if (known == folders_.end()) {
        std::size_t number = folders_.empty() ? 1 : folders_.back().number + 1;
        // A folder of the project that happens to have the name keeps it.
        for (std::error_code ignored; fs::exists(folder / prefix_of(number), ignored);) {
            ++number;
        }
        known = folders_.insert(folders_.end(), {elsewhere, number});
    }
    return prefix_of(known->number) + path.filename().string();
}

std::string InputNames::path_of(const std::string& shown) const {
    if (const auto found = paths_.find(shown); found != paths_.end()) {
        return found->second;
    }
    for (const Folder& folder : folders_) {
        if (const std::string prefix = prefix_of(folder.number); shown.starts_with(prefix)) {
            return (folder.path / shown.substr(prefix.size())).string();
        }
    }
    return shown;
}

bool is_within(const fs::path& path, const fs::path& folder) {
    return !leads_up(on_disk(path).lexically_relative(on_disk(folder)));
}

}  // namespace coupling
