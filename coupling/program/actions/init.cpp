#include "coupling/program/actions/init.hpp"

#include <algorithm>
#include <chrono>
#include <sstream>
#include <system_error>
#include <vector>

#include "config/errors/input_error.hpp"
#include "coupling/examples/embedded.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/own_files/file_reader.hpp"
#include "coupling/inputs/release/terrain_check.hpp"
#include "coupling/inputs/rockyfor3d/project.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/program/actions/check.hpp"
#include "coupling/results/disk/byte_archive.hpp"
#include "coupling/results/disk/disk.hpp"
#include "coupling/results/disk/leftovers.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/run/interrupt.hpp"

namespace coupling {

namespace {

namespace fs = std::filesystem;

/// Beside what a call writes, until all of it is there: the names of its files. They may refer to each other
/// and to files elsewhere by their final places, so that they are written there.
constexpr const char* list_name = ".init";

/// A file that somebody has worked on since: a call writes all of its files within seconds [choice].
bool is_of_later(const fs::path& file, const fs::path& list) {
    std::error_code error;
    const auto changed = fs::last_write_time(file, error);
    return !error && changed > fs::last_write_time(list, error) + std::chrono::minutes{1} && !error;
}

/// A call that was killed leaves its list: what it had written goes, unless somebody has worked on it.
void delete_unfinished(const fs::path& folder) {
    for (const fs::path& list : leftovers_of(folder / list_name)) {
        std::vector<fs::path> files;
        std::istringstream names{text_of_file(list)};
        for (std::string name; std::getline(names, name);) {
            files.push_back(folder / name);
        }
        const auto later = [&](const fs::path& file) { return is_of_later(file, list); };
        if (std::none_of(files.begin(), files.end(), later)) {
            std::for_each(files.begin(), files.end(), delete_entry);
            delete_entry(list);
        }
    }
}

void check_folder(const fs::path& folder) {
    if (!path_exists(folder)) {
        return;
    }
    if (!is_folder(folder)) {
        config::fail(config::ExitCode::settings, {}, path_in_quotes(folder) + ", which is no folder",
                     "a new or empty folder");
    }
    delete_unfinished(folder);
    if (!is_empty_folder(folder)) {
        config::fail(config::ExitCode::settings, {}, "files in folder " + path_in_quotes(folder),
                     "a new or empty folder");
    }
}

std::string all_examples() {
    std::string all;
    for (const std::string& name : example_names()) {
        all += (all.empty() ? "" : " or ") + config::in_quotes(name);
    }
    return all;
}

std::vector<ExampleFile> files_of(const std::string& example) {
    std::vector<ExampleFile> files = example_files();
    std::erase_if(files, [&](const ExampleFile& file) { return file.example != example; });
    if (files.empty()) {
        const std::string nearest = config::nearest_word(example, example_names());
        config::fail(config::ExitCode::settings, {}, "example " + config::in_quotes(example),
                     nearest.empty() ? all_examples() : config::in_quotes(nearest));
    }
    return files;
}

/// Files that vanish again unless they are kept.
class Draft {
public:
    explicit Draft(fs::path folder)
        : folder_{std::move(folder)},
          list_{temporary_beside(folder_ / list_name)},
          is_new_{!path_exists(folder_)} {
        make_folder(folder_);
    }
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft() {
        std::error_code ignored;
        for (const fs::path& path : written_) {
            fs::remove(path, ignored);
        }
        fs::remove(list_, ignored);
        if (is_new_) {
            fs::remove(folder_, ignored);  // removes an empty folder only
        }
    }

    /// What will be written, before any of it is.
    template <class Files>
    void list(const Files& files) {
        OutFile names{list_};
        for (const auto& file : files) {
            names.stream() << file.name << '\n';
        }
        names.sync();
        names.close();
        sync_folder(folder_);
    }
    void write(const std::string& name, std::string_view bytes) {
        const fs::path path = folder_ / name;
        written_.push_back(path);
        OutFile out{path};
        out.stream().write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        out.close();
    }
    void keep() {
        sync_all_below(folder_);
        delete_entry(list_);
        written_.clear();
    }

private:
    fs::path folder_;
    fs::path list_;
    bool is_new_;
    std::vector<fs::path> written_;
};

/// A scenario that cannot be run is no start for anybody, and what `check` would say is said at once.
config::Warnings checked(const fs::path& scenario) {
    config::Warnings warnings;
    std::ostringstream description;
    check_scenario({.scenario = scenario}, warnings, description);
    return warnings;
}

/// Writes the files of a project whole or not at all. `judge` may refuse the scenario before it is checked.
template <class Project, class Judge>
MadeProject write_project(const fs::path& folder, const Project& project, Judge judge) {
    const InterruptGuard until_written;
    Draft draft{folder};
    draft.list(project.files);
    for (const auto& file : project.files) {
        draft.write(file.name, file.text);
    }
    judge(*read_scenario(folder / "scenario.ini", {}));
    MadeProject made{project.remarks, checked(folder / "scenario.ini")};
    draft.keep();
    return made;
}

}  // namespace

void write_example(const fs::path& folder, const std::string& example) {
    const std::vector<ExampleFile> files = files_of(example);
    check_folder(folder);
    const InterruptGuard until_written;
    Draft draft{folder};
    draft.list(files);
    for (const ExampleFile& file : files) {
        draft.write(file.name, file.bytes);
    }
    draft.keep();
}

MadeProject write_from_rockyfor3d(const fs::path& folder, const fs::path& source) {
    check_folder(folder);
    return write_project(folder, rockyfor3d::project_of(source), [](const Scenario&) {});
}

MadeProject write_from_files(const fs::path& folder, const GivenFiles& given) {
    check_folder(folder);
    const GivenProject project = project_from_files(given, folder);
    return write_project(folder, project, [&](const Scenario& scenario) {
        if (project.no_sources) {
            check_terrain(scenario);  // heights that cannot be meant are the likelier cause
            throw config::InputError{{*project.no_sources}};
        }
    });
}

}  // namespace coupling
