#include "coupling/commands/init.hpp"

#include <algorithm>
#include <system_error>
#include <vector>

#include "config/errors/input_error.hpp"
#include "coupling/examples/embedded.hpp"
#include "coupling/inputs/path_checks.hpp"
#include "coupling/inputs/scenario.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/out_file.hpp"
#include "coupling/rockyfor3d/project.hpp"
#include "coupling/run/interrupt.hpp"

namespace coupling {

namespace {

namespace fs = std::filesystem;

void check_folder(const fs::path& folder) {
    if (!path_exists(folder)) {
        return;
    }
    if (!is_folder(folder)) {
        config::fail(config::ExitCode::settings, {},
                     config::in_quotes(folder.string()) + ", which is no folder", "a new or empty folder");
    }
    if (!is_empty_folder(folder)) {
        config::fail(config::ExitCode::settings, {}, "files in folder " + config::in_quotes(folder.string()),
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
    explicit Draft(fs::path folder) : folder_{std::move(folder)}, is_new_{!path_exists(folder_)} {
        make_folder(folder_);
    }
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft() {
        std::error_code ignored;
        for (const fs::path& path : written_) {
            fs::remove(path, ignored);
        }
        if (is_new_ && !written_.empty()) {
            fs::remove(folder_, ignored);
        }
    }

    void write(const std::string& name, std::string_view bytes) {
        const fs::path path = folder_ / name;
        written_.push_back(path);
        OutFile out{path};
        out.stream().write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        out.close();
    }
    void keep() { written_.clear(); }

private:
    fs::path folder_;
    bool is_new_;
    std::vector<fs::path> written_;
};

/// A scenario that cannot be run is no start for anybody.
void refuse_unrunnable(const fs::path& folder) {
    config::Warnings warnings;
    const auto scenario = read_scenario(folder / "scenario.ini", {});
    open_site(*scenario, warnings);
}

}  // namespace

void write_example(const fs::path& folder, const std::string& example) {
    const std::vector<ExampleFile> files = files_of(example);
    check_folder(folder);
    const InterruptGuard until_written;
    Draft draft{folder};
    for (const ExampleFile& file : files) {
        draft.write(file.name, file.bytes);
    }
    draft.keep();
}

std::vector<std::string> write_from_rockyfor3d(const fs::path& folder, const fs::path& source) {
    check_folder(folder);
    const rockyfor3d::Project project = rockyfor3d::project_of(source);
    const InterruptGuard until_written;
    Draft draft{folder};
    for (const rockyfor3d::Project::File& file : project.files) {
        draft.write(file.name, file.text);
    }
    refuse_unrunnable(folder);
    draft.keep();
    return project.remarks;
}

std::vector<std::string> write_from_files(const fs::path& folder, const GivenFiles& given) {
    check_folder(folder);
    const GivenProject project = project_from_files(given, folder);
    const InterruptGuard until_written;
    Draft draft{folder};
    for (const GivenProject::File& file : project.files) {
        draft.write(file.name, file.text);
    }
    refuse_unrunnable(folder);
    draft.keep();
    return project.remarks;
}

}  // namespace coupling
