#include "validation/engine/case/case_files.hpp"

#include <algorithm>
#include <string_view>

#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"

// Each file becomes a pair of symbols around its bytes. The list of files is written by
// coupling/CMakeLists.txt.
#define CASE_FILE(number, name, file)                                                               \
    asm(".pushsection .rodata\n"                                                                    \
        ".hidden bannwald_case_" #number "_begin\n.globl bannwald_case_" #number                    \
        "_begin\nbannwald_case_" #number "_begin:\n.incbin \"" BANNWALD_CASES_DIR "/" name "/" file \
        "\"\n"                                                                                      \
        ".hidden bannwald_case_" #number "_end\n.globl bannwald_case_" #number                      \
        "_end\nbannwald_case_" #number "_end:\n.byte 0\n.popsection\n");                            \
    extern "C" const char bannwald_case_##number##_begin[];                                         \
    extern "C" const char bannwald_case_##number##_end[];
#include "case_files.inc"
#undef CASE_FILE

namespace coupling::validation {

namespace {

namespace fs = std::filesystem;

constexpr const char* recipe_file = "case.ini";

/// The cases among folders of files: those with a recipe.
std::vector<CaseFiles> with_recipe(std::map<std::string, CaseFiles> folders) {
    std::vector<CaseFiles> cases;
    for (auto& [name, files] : folders) {
        if (files.has(recipe_file)) {
            cases.push_back(std::move(files));
        }
    }
    return cases;
}

CaseFiles read_folder(const fs::path& folder, const std::string& name) {
    CaseFiles files{.name = name, .folder = folder.string(), .texts = {}, .path = folder};
    for (const fs::path& entry : entries_of(folder)) {
        if (is_file(entry)) {
            const FileBytes bytes = open_file(entry, {folder.string()}, "a file of a case");
            files.texts[entry.filename().string()] = bytes.text();
        }
    }
    return files;
}

}  // namespace

config::Table CaseFiles::table(const std::string& file) const {
    if (!has(file)) {
        std::vector<std::string> present;
        for (const auto& [other, bytes] : texts) {
            present.push_back(other);
        }
        const std::string nearest = config::nearest_word(file, present);
        config::fail(config::ExitCode::file, {shown(file)}, "no such file", "a table of the case",
                     nearest.empty() ? "" : "if it is " + config::in_quotes(nearest) + ", rename it");
    }
    return config::Table::read(texts.at(file), shown(file));
}

std::vector<CaseFiles> shipped_cases() {
    std::map<std::string, CaseFiles> folders;
    [[maybe_unused]] const auto put = [&](const std::string& name, const char* file, std::string_view text) {
        CaseFiles& files = folders[name];
        files.name = name;
        files.folder = "validation/" + name;
        files.texts[file] = text;
    };
#define CASE_FILE(number, name, file) \
    put(name, file, {bannwald_case_##number##_begin, bannwald_case_##number##_end});
#include "case_files.inc"
#undef CASE_FILE
    return with_recipe(std::move(folders));
}

std::vector<CaseFiles> cases_in(const fs::path& folder) {
    if (!is_folder(folder)) {
        config::fail(config::ExitCode::file, {folder.string()}, "no folder of this name",
                     "a folder that holds cases");
    }
    if (path_exists(folder / recipe_file)) {
        const fs::path whole = fs::absolute(folder).lexically_normal();
        const fs::path name = whole.has_filename() ? whole.filename() : whole.parent_path().filename();
        return {read_folder(folder, name.string())};
    }
    std::map<std::string, CaseFiles> folders;
    for (const fs::path& entry : entries_of(folder)) {
        if (is_file(entry / recipe_file)) {
            const std::string name = entry.filename().string();
            folders[name] = read_folder(entry, name);
        }
    }
    if (folders.empty()) {
        config::fail(config::ExitCode::file, {folder.string()}, "no case in it",
                     "folders that hold a case.ini");
    }
    return with_recipe(std::move(folders));
}

}  // namespace coupling::validation
