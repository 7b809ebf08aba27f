#include "coupling/pack/stored_file.hpp"

#include <array>
#include <cstdio>

#include "config/errors/input_error.hpp"
#include "config/text/sha256.hpp"
#include "coupling/inputs/path_checks.hpp"

namespace coupling::pack {

StoredFile stored_file(const std::filesystem::path& file) {
    config::Sha256 sum;
    std::uint64_t bytes = 0;
    if (std::FILE* in = std::fopen(file.c_str(), "rb")) {
        std::array<char, 1U << 16U> piece{};
        for (std::size_t got = 0; (got = std::fread(piece.data(), 1, piece.size(), in)) > 0;) {
            sum.add({piece.data(), got});
            bytes += got;
        }
        std::fclose(in);
    }
    if (bytes != bytes_of_file(file)) {
        config::fail(config::ExitCode::file, {file.string()}, "a file that cannot be read", "a readable one");
    }
    return {sum.digits(), bytes};
}

}  // namespace coupling::pack
