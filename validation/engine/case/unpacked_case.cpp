#include "validation/engine/case/unpacked_case.hpp"

#include <cstdlib>
#include <string>
#include <system_error>

#include "config/errors/input_error.hpp"
#include "coupling/results/disk/out_file.hpp"

namespace coupling::validation {

UnpackedCase::UnpackedCase(const CaseFiles& files) : path_{files.path}, temporary_{files.path.empty()} {
    if (!temporary_) {
        return;
    }
    std::error_code error;
    std::string name = (std::filesystem::temp_directory_path(error) / "bannwald-XXXXXX").string();
    if (error || ::mkdtemp(name.data()) == nullptr) {
        config::fail(config::ExitCode::file, {name}, "no temporary folder can be made",
                     "a place for the files of a case", "set TMPDIR to a folder that can be written");
    }
    path_ = name;
    for (const auto& [file, text] : files.texts) {
        OutFile out{path_ / file};
        out.stream() << text;
        out.close();
    }
}

UnpackedCase::~UnpackedCase() {
    if (temporary_) {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
}

}  // namespace coupling::validation
