#include "coupling/run/byte_archive.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>

#include "coupling/results/disk.hpp"

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
    const std::streamoff place = in_.tellg();
    const std::uintmax_t size = static_cast<std::uintmax_t>(place) + left_;
    constexpr std::uintmax_t sum_bytes = sizeof(std::uint64_t);
    if (size < sum_bytes) {
        damaged();
    }
    in_.seekg(0);
    Checksum sum;
    std::vector<char> block(std::size_t{1} << 20);
    for (std::uintmax_t left = size - sum_bytes; left > 0;) {
        const std::size_t count = static_cast<std::size_t>(std::min<std::uintmax_t>(left, block.size()));
        if (!in_.read(block.data(), static_cast<std::streamsize>(count))) {
            damaged();
        }
        sum.add(block.data(), count);
        left -= count;
    }
    std::uint64_t stored = 0;
    if (!in_.read(reinterpret_cast<char*>(&stored), sizeof stored) || stored != sum.value()) {
        damaged();
    }
    in_.seekg(place);
}

}  // namespace coupling
