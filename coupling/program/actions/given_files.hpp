#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <string_view>

#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/files_beside.hpp"
#include "coupling/inputs/formats/read_file.hpp"
#include "coupling/inputs/grids/tiles.hpp"

namespace coupling {

/// A name of the command line as the scenario in another folder needs it.
std::string name_from(const std::filesystem::path& folder, const std::string& name);

/// A file of the user, opened.
class GivenFile {
public:
    explicit GivenFile(std::string name);

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] std::string_view bytes() const { return bytes_.text(); }
    [[nodiscard]] bool is_grid() const;
    [[nodiscard]] formats::PlacedGrid grid();
    [[nodiscard]] formats::ReadLayer layer();
    /// The text of the .prj beside it, "" without one.
    [[nodiscard]] std::string system_beside();

private:
    std::string name_;
    formats::LayerName layer_;
    FileBytes bytes_;
    FilesBeside beside_;
};

/// A layer as the reader of the project will have it; what there is to say is said when the project is
/// checked. Throws what is wrong with it.
void prepare(formats::ReadLayer& read, const std::string& role);

/// The files of a grid where the command line names them. Has to live as long as what it gives.
class HeightFiles {
public:
    grids::GridFiles files();

private:
    std::deque<FilesBeside> beside_;
};

}  // namespace coupling
