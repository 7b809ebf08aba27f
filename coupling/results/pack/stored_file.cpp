#include "coupling/results/pack/stored_file.hpp"

#include <array>

#include "config/text/sha256.hpp"
#include "coupling/inputs/own_files/file_reader.hpp"

namespace coupling::pack {

StoredFile stored_file(const std::filesystem::path& file) {
    FileReader in{file};
    config::Sha256 sum;
    std::array<char, 1U << 16U> piece{};
    for (std::size_t got = 0; (got = in.read(piece.data(), piece.size())) > 0;) {
        sum.add({piece.data(), got});
    }
    return {sum.digits(), in.bytes()};
}

}  // namespace coupling::pack
