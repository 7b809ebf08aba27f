#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "config/errors/input_error.hpp"
#include "coupling/inputs/own_files/file_reader.hpp"
#include "coupling/results/disk/checksum.hpp"
#include "coupling/results/disk/out_file.hpp"

namespace coupling {

/// Values that are copied byte by byte. Files of parts stay on the machine that made them.
template <class T>
concept Plain = std::is_trivially_copyable_v<T>;

/// Writes plain values and vectors of them. `close` adds the checksum and returns once all is on the disk; a
/// disk that does not take it throws config::InputError (file).
class ByteWriter {
public:
    explicit ByteWriter(const std::filesystem::path& file) : out_{file} {}
    template <Plain T>
    void value(const T& v) {
        values(std::span<const T>{&v, 1});
    }
    template <Plain T>
    void list(std::span<const T> list_of) {
        value(static_cast<std::uint64_t>(list_of.size()));
        values(list_of);
    }
    template <Plain T>
    void list(const std::vector<T>& values) {
        list(std::span<const T>{values});
    }
    void text(const std::string& v) { list(std::span<const char>{v.data(), v.size()}); }
    void close() {
        value(sum_.value());
        out_.sync();
        out_.close();
    }

private:
    /// Bytes between the members of a struct are whatever was there before: they are written as zeros, so
    /// that the same values make the same file.
    template <Plain T>
    void values(std::span<const T> all) {
        constexpr std::size_t at_once = std::max<std::size_t>(1, 4096 / sizeof(T));
        std::array<T, at_once> copies;
        for (std::size_t from = 0; from < all.size(); from += at_once) {
            const std::size_t count = std::min(at_once, all.size() - from);
            for (std::size_t i = 0; i < count; ++i) {
                copies[i] = all[from + i];
#if __has_builtin(__builtin_clear_padding)
                __builtin_clear_padding(&copies[i]);
#endif
            }
            bytes(reinterpret_cast<const char*>(copies.data()), count * sizeof(T));
        }
    }
    void bytes(const char* from, std::size_t count) {
        sum_.add(from, count);
        out_.stream().write(from, static_cast<std::streamsize>(count));
    }
    OutFile out_;
    Checksum sum_;
};

/// Name of a part file while it is written: of this process alone, as others may share the folder.
std::filesystem::path temporary_beside(const std::filesystem::path& file);

/// Ends a part file: closed under its temporary name, renamed when it is on the disk. Returns once the new
/// name is on the disk too. Throws config::InputError (file).
void close_and_rename(ByteWriter& out, const std::filesystem::path& temporary,
                      const std::filesystem::path& file);

/// What a message advises where a part of a run's own folder cannot be used.
inline constexpr const char* own_part_remedy =
    "delete it, or run with --overwrite to start from the beginning";
/// The same of a part that a finished run has kept for the next one.
inline constexpr const char* kept_part_remedy = "delete it: it is made again where it is needed";

/// Reads back what ByteWriter wrote. Anything missing or changed, and a read error, throws config::InputError
/// (file); its message ends with `remedy`: what the user may do about this file.
class ByteReader {
public:
    explicit ByteReader(const std::filesystem::path& file, std::string remedy = own_part_remedy)
        : file_{file.string()}, remedy_{std::move(remedy)}, in_{file}, left_{in_.bytes()} {}
    [[nodiscard]] const std::string& remedy() const { return remedy_; }
    /// Reads the whole file once for its checksum, before anything in it is used, and goes on where it was.
    void check_whole();
    template <Plain T>
    T value() {
        T v{};
        bytes(reinterpret_cast<char*>(&v), sizeof v);
        return v;
    }
    template <Plain T>
    std::vector<T> list() {
        const std::uint64_t count = count_of(sizeof(T));
        std::vector<T> values(count);
        bytes(reinterpret_cast<char*>(values.data()), count * sizeof(T));
        return values;
    }
    /// A count of things of at least `bytes_each` that must still fit into the file.
    std::uint64_t count_of(std::size_t bytes_each) {
        const auto count = value<std::uint64_t>();
        if (count > left_ / bytes_each) {
            damaged();
        }
        return count;
    }
    /// What a whole file holds; else it is damaged.
    void require(bool holds) const {
        if (!holds) {
            damaged();
        }
    }
    std::string text() {
        const std::vector<char> letters = list<char>();
        return {letters.begin(), letters.end()};
    }
    void check_end() {
        const std::uint64_t expected = sum_.value();
        if (value<std::uint64_t>() != expected || left_ != 0) {
            damaged();
        }
    }

private:
    [[noreturn]] void damaged() const {
        config::fail(config::ExitCode::file, {file_}, "the part file is cut off or damaged",
                     "a whole part file; " + remedy_);
    }
    void bytes(char* to, std::size_t count) {
        if (count > left_) {
            damaged();
        }
        in_.read(to, count);
        left_ -= count;
        sum_.add(to, count);
    }
    std::string file_;
    std::string remedy_;
    FileReader in_;
    std::uint64_t left_ = 0;
    Checksum sum_;
};

}  // namespace coupling
