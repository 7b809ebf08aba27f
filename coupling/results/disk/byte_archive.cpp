#include "coupling/results/disk/byte_archive.hpp"

#include <unistd.h>

#include <array>

#include "coupling/results/disk/disk.hpp"

namespace coupling {

std::filesystem::path temporary_beside(const std::filesystem::path& file) {
    std::array<char, 256> machine{};
    gethostname(machine.data(), machine.size() - 1);
    std::filesystem::path temporary = file;
    temporary += std::string{"."} + machine.data();
    temporary += "." + std::to_string(getpid());
    temporary += ".tmp";
    return temporary;
}

void close_and_rename(ByteWriter& out, const std::filesystem::path& temporary,
                      const std::filesystem::path& file) {
    out.close();
    std::error_code error;
    std::filesystem::rename(temporary, file, error);
    if (error) {
        config::fail(config::ExitCode::file, {file.string()},
                     "the part file cannot be renamed: " + error.message());
    }
    sync_folder(file.parent_path());
}

void ByteReader::check_whole() {
    const std::uint64_t place = in_.place();
    constexpr std::uint64_t sum_bytes = sizeof(std::uint64_t);
    if (in_.bytes() < sum_bytes) {
        damaged();
    }
    in_.seek(0);
    const Checksum sum = checksum_of(in_, in_.bytes() - sum_bytes);
    std::uint64_t stored = 0;
    in_.read(reinterpret_cast<char*>(&stored), sizeof stored);
    if (stored != sum.value()) {
        damaged();
    }
    in_.seek(place);
}

}  // namespace coupling
