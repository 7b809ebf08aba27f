#include "coupling/inputs/files/file_part.hpp"

#include <algorithm>

#include "coupling/inputs/files/file_bytes.hpp"

namespace coupling {

FilePart::FilePart(const std::filesystem::path& path, const config::Place& asked_at,
                   std::string_view expected) {
    check_readable(path, asked_at, expected);
    reader_ = std::make_unique<FileReader>(path);
}

void FilePart::read(std::uint64_t at, char* to, std::size_t count) const {
    reader_->seek(at);
    reader_->read(to, count);
}

std::string FilePart::beginning(std::size_t most) const {
    std::string text(static_cast<std::size_t>(std::min<std::uint64_t>(most, bytes())), '\0');
    read(0, text.data(), text.size());
    return text;
}

}  // namespace coupling
