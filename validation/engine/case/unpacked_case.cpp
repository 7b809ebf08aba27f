#include "validation/engine/case/unpacked_case.hpp"

#include <cstdlib>
#include <string>
#include <system_error>

#include "config/errors/input_error.hpp"
#include "coupling/results/disk/out_file.hpp"

namespace coupling::validation {

TemporaryFolder::TemporaryFolder() {
    std::error_code error;
    std::string name = (std::filesystem::temp_directory_path(error) / "bannwald-XXXXXX").string();
    if (error || ::mkdtemp(name.data()) == nullptr) {
        config::fail(config::ExitCode::file, {name}, "no temporary folder can be made",
                     "a place for the files of a case", "set TMPDIR to a folder that can be written");
    }
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

UnpackedCase::UnpackedCase(const CaseFiles& files) : path_{files.path} {
    if (!files.path.empty()) {
        return;
    }
    temporary_.emplace();
    for (const auto& [file, text] : files.texts) {
        OutFile out{temporary_->path() / file};
        out.stream() << text;
        out.close();
    }
}

}  // namespace coupling::validation
