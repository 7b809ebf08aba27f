#include "coupling/run/byte_archive.hpp"

#include <unistd.h>

#include <array>

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

}  // namespace coupling
