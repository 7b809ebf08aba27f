#include "coupling/inputs/formats/sqlite_log.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>

namespace coupling::formats {
namespace {

constexpr std::size_t database_header_bytes = 100;
constexpr std::size_t log_header_bytes = 32;
constexpr std::size_t frame_header_bytes = 24;
constexpr std::uint64_t most_database_bytes = std::uint64_t{8} << 30U;  // as text of layers is held in memory

/// A number of four bytes, the first of which counts most.
std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value = (value << 8U) | static_cast<unsigned char>(bytes[at + i]);
    }
    return value;
}

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) {
        value = (value << 8U) | static_cast<unsigned char>(bytes[at + i]);
    }
    return value;
}

/// The running sum over all frames of a log.
struct Checksum {
    bool is_big_endian = false;
    std::uint32_t first = 0;
    std::uint32_t second = 0;

    /// Takes a multiple of eight bytes.
    void add(std::string_view bytes) {
        for (std::size_t at = 0; at + 8 <= bytes.size(); at += 8) {
            first += word(bytes, at) + second;
            second += word(bytes, at + 4) + first;
        }
    }
    [[nodiscard]] bool stands_at(std::string_view bytes, std::size_t at) const {
        return first == big_endian(bytes, at) && second == big_endian(bytes, at + 4);
    }

private:
    [[nodiscard]] std::uint32_t word(std::string_view bytes, std::size_t at) const {
        return is_big_endian ? big_endian(bytes, at) : little_endian(bytes, at);
    }
};

/// Bytes of a page, by the header of a database, where 1 stands for 65536.
std::uint32_t page_bytes_of(std::string_view database) {
    constexpr std::size_t at_page_size = 16;
    const std::uint32_t written = big_endian(database, at_page_size) >> 16U;
    return written == 1 ? 65536U : written;
}

/// The pages of a log that count, by their number from 1.
struct Pages {
    std::map<std::uint32_t, std::string_view> by_number;
    std::uint32_t database_pages = 0;  ///< after the last change; 0: nothing was committed
};

/// The running sum behind the header, which is checked.
Checksum checked_header(std::string_view log, std::uint32_t page_bytes) {
    constexpr std::uint32_t log_magic = 0x377F0682U;
    constexpr std::uint32_t version = 3007000U;
    if (log.size() < log_header_bytes || (big_endian(log, 0) & ~1U) != log_magic) {
        throw std::invalid_argument{"a -wal beside it that is no write-ahead log of SQLite"};
    }
    if (big_endian(log, 4) != version) {
        throw std::invalid_argument{"a write-ahead log (-wal) of an unknown version beside it"};
    }
    Checksum sum{(big_endian(log, 0) & 1U) != 0};
    sum.add(log.substr(0, 24));
    if (!sum.stands_at(log, 24)) {
        throw std::invalid_argument{"a damaged write-ahead log (-wal) beside it"};
    }
    if (big_endian(log, 8) != page_bytes) {
        throw std::invalid_argument{"a write-ahead log (-wal) of another database beside it"};
    }
    return sum;
}

Pages committed_pages(std::string_view log, std::uint32_t page_bytes) {
    Checksum sum = checked_header(log, page_bytes);
    const std::string_view salt = log.substr(16, 8);
    Pages committed;
    std::map<std::uint32_t, std::string_view> pending;
    const std::size_t frame_bytes = frame_header_bytes + page_bytes;
    for (std::size_t at = log_header_bytes; at < log.size(); at += frame_bytes) {
        const std::string_view frame = log.substr(at, frame_bytes);
        // SQLite restarts a log over the old one: from the first frame of another salt on, nothing counts.
        if (frame.size() >= 16 && frame.substr(8, 8) != salt) {
            break;
        }
        if (frame.size() < frame_bytes) {
            throw std::invalid_argument{"a write-ahead log (-wal) beside it that is cut off"};
        }
        sum.add(frame.substr(0, 8));
        sum.add(frame.substr(frame_header_bytes));
        const std::uint32_t number = big_endian(frame, 0);
        if (number == 0 || !sum.stands_at(frame, 16)) {
            throw std::invalid_argument{"a damaged write-ahead log (-wal) beside it"};
        }
        pending[number] = frame.substr(frame_header_bytes);
        if (const std::uint32_t pages = big_endian(frame, 4); pages > 0) {
            for (const auto& [page, bytes] : pending) {
                committed.by_number[page] = bytes;
            }
            pending.clear();
            committed.database_pages = pages;
        }
    }
    return committed;
}

}  // namespace

bool is_unfinished_journal(std::string_view journal) {
    return !journal.empty() && journal.front() != '\0';
}

std::string with_write_ahead_log(std::string_view database, std::string_view log) {
    if (database.size() < database_header_bytes) {
        throw std::invalid_argument{"a database without its header"};
    }
    constexpr std::size_t at_write_version = 18;
    constexpr char by_log = 2;
    if (database[at_write_version] != by_log) {
        throw std::invalid_argument{"a write-ahead log (-wal) beside it, although it is written without one"};
    }
    const std::uint32_t page_bytes = page_bytes_of(database);
    const Pages pages = committed_pages(log, page_bytes);
    std::string whole{database};
    if (pages.database_pages == 0) {
        return whole;
    }
    const std::uint64_t bytes = std::uint64_t{pages.database_pages} * page_bytes;
    // Pages that neither file holds would be memory without content.
    if (bytes > most_database_bytes || bytes > database.size() + log.size()) {
        throw std::invalid_argument{"a write-ahead log (-wal) of another database beside it"};
    }
    whole.resize(static_cast<std::size_t>(bytes));
    for (const auto& [number, page] : pages.by_number) {
        if (number <= pages.database_pages) {
            page.copy(whole.data() + std::size_t{number - 1} * page_bytes, page.size());
        }
    }
    return whole;
}

}  // namespace coupling::formats
