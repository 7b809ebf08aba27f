#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"

namespace coupling {

/// The bytes of a file in memory, read by plain reads (FileReader), unpacked where they are gzip.
class FileBytes {
public:
    /// The content, unpacked. Lives as long as this object.
    [[nodiscard]] std::string_view text() const { return is_packed_ ? unpacked_ : stored_; }
    [[nodiscard]] std::uint64_t stored_bytes() const { return stored_.size(); }
    /// 16 hexadecimal digits over the bytes as stored: distinguishes versions of a file, no protection
    /// against malice.
    [[nodiscard]] std::string hash() const;

private:
    friend FileBytes open_file(const std::filesystem::path&, const config::Place&, std::string_view);

    std::shared_ptr<const void> memory_;  ///< of `stored_`
    std::string_view stored_;
    std::string unpacked_;
    bool is_packed_ = false;
};

/// Opens a file; the way of every input into the program. `asked_at` is where the user named it and
/// `expected` what it ought to be. Throws InputError: (file) for a file that is missing, a folder or
/// unreadable, (data) for a packed one that holds more than a grid of its header's size, a text of 512 MiB or
/// a grid of 2 GiB.
FileBytes open_file(const std::filesystem::path& path, const config::Place& asked_at,
                    std::string_view expected);

/// Throws InputError (file) for a file that cannot be opened, as `open_file` does.
void check_readable(const std::filesystem::path& path, const config::Place& asked_at,
                    std::string_view expected);

/// FNV-1a of 64 bits.
std::uint64_t fnv1a(std::string_view bytes);
/// The same as 16 hexadecimal digits.
std::string hash_text(std::string_view bytes);

}  // namespace coupling
