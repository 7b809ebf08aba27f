#include "coupling/inputs/own_files/own_rows.hpp"

#include <algorithm>
#include <utility>

#include "config/text/joined.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr std::size_t block_bytes = std::size_t{1} << 20U;
/// The longest rows are outlines of areas, of a few million bytes. A damaged quote must not take the whole
/// of a table into memory [choice].
constexpr std::size_t longest_row_bytes = std::size_t{1} << 26U;
constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";  // tables for Excel begin with it

/// The text between quotes, with each doubled quote once.
std::string with_single_quotes(std::string_view inside) {
    std::string plain;
    for (std::size_t i = 0; i < inside.size(); ++i) {
        plain += inside[i];
        i += inside[i] == '"' ? 1 : 0;
    }
    return plain;
}

}  // namespace

OwnRows::OwnRows(const std::filesystem::path& file, std::optional<TableEnd> end, config::ExitCode damaged)
    : name_{file.string()},
      damaged_{damaged},
      end_{end},
      reader_{std::make_unique<FileReader>(file)},
      block_(static_cast<std::size_t>(std::min<std::uint64_t>(reader_->bytes() + 1, block_bytes))),
      bytes_{reader_->bytes()} {
    read_header();
}

OwnRows::OwnRows(std::string_view text, std::string name)
    : name_{std::move(name)}, damaged_{config::ExitCode::file}, text_{text}, bytes_{text.size()} {
    read_header();
}

void OwnRows::read_header() {
    if (!reader_ || fill()) {
        if (text_.starts_with(utf8_mark)) {
            at_ = utf8_mark.size();
            separator_ = ';';
        }
    }
    if (!read_row()) {
        line_ = 1;
        refuse("an empty file");
    }
    columns_.assign(fields_.begin(), fields_.end());
}

std::size_t OwnRows::column(std::string_view name) const {
    const auto found = std::find(columns_.begin(), columns_.end(), name);
    if (found == columns_.end()) {
        config::fail(damaged_, {name_, 1, 1}, "a damaged row", joined("a header with the column ", name));
    }
    return static_cast<std::size_t>(found - columns_.begin());
}

bool OwnRows::next() {
    if (!read_row()) {
        check_end();
        return false;
    }
    ++rows_;
    if (fields_.size() != columns_.size()) {
        refuse(joined(std::to_string(fields_.size()), " fields where the header has ",
                      std::to_string(columns_.size())));
    }
    return true;
}

double OwnRows::share() const {
    return bytes_ == 0 ? 1.0 : static_cast<double>(before_ + at_) / static_cast<double>(bytes_);
}

bool OwnRows::read_row() {
    while (parse_row() == Read::cut_off) {
        if (!fill()) {
            if (at_ == text_.size()) {
                return false;
            }
            refuse("a row that is cut off");
        }
    }
    return true;
}

OwnRows::Read OwnRows::parse_row() {
    fields_.clear();
    unquoted_.clear();
    line_ = next_line_;
    std::uint64_t breaks = 0;  // within quotes
    for (std::size_t at = at_;; ++at) {
        if (at < text_.size() && text_[at] == '"') {
            const std::optional<std::string_view> inside = parse_quoted(at);
            if (!inside || at == text_.size()) {
                return Read::cut_off;
            }
            breaks += static_cast<std::uint64_t>(std::count(inside->begin(), inside->end(), '\n'));
            fields_.push_back(*inside);
            if (text_[at] == '\r' && at + 1 == text_.size()) {
                return Read::cut_off;  // its line feed is the first byte of the next block
            }
            at += text_[at] == '\r' && text_[at + 1] == '\n' ? 1U : 0U;
            if (text_[at] != separator_ && text_[at] != '\n') {
                refuse("text behind a closing quote");
            }
        } else {
            const std::size_t first = at;
            const std::string_view text = text_;
            const char separator = separator_;
            while (at < text.size() && text[at] != separator && text[at] != '\n') {
                ++at;
            }
            if (at == text_.size()) {
                return Read::cut_off;
            }
            // A program for tables may have saved it with other line ends.
            const bool returns = text_[at] == '\n' && at > first && text_[at - 1] == '\r';
            fields_.push_back(text_.substr(first, at - first - (returns ? 1U : 0U)));
        }
        if (text_[at] == '\n') {
            at_ = at + 1;
            next_line_ = line_ + breaks + 1;
            return Read::whole;
        }
    }
}

/// The field whose opening quote stands at a place, which moves behind the closing one. Nothing if the text
/// ends before that is certain: the next byte may double it.
std::optional<std::string_view> OwnRows::parse_quoted(std::size_t& at) {
    const std::size_t first = at + 1;
    bool doubled = false;
    std::size_t end = text_.find('"', first);
    while (end != std::string_view::npos && end + 1 < text_.size() && text_[end + 1] == '"') {
        doubled = true;
        end = text_.find('"', end + 2);
    }
    if (end == std::string_view::npos) {
        return std::nullopt;
    }
    at = end + 1;
    const std::string_view inside = text_.substr(first, end - first);
    return doubled ? std::string_view{unquoted_.emplace_back(with_single_quotes(inside))} : inside;
}

/// Reads on, with the row that has begun at the front. False at the end of the table.
bool OwnRows::fill() {
    if (!reader_ || reader_->place() == bytes_) {
        return false;
    }
    const std::size_t kept = text_.size() - at_;
    if (kept == block_.size()) {
        if (block_.size() >= longest_row_bytes) {
            refuse(joined("a row of more than ", std::to_string(longest_row_bytes >> 20U), " MiB"));
        }
        std::vector<char> larger(2 * block_.size());
        std::copy(text_.begin(), text_.end(), larger.begin());
        block_ = std::move(larger);
    } else {
        std::copy(text_.begin() + static_cast<std::ptrdiff_t>(at_), text_.end(), block_.begin());
    }
    before_ += at_;
    at_ = 0;
    const std::size_t got = reader_->read(block_.data() + kept, block_.size() - kept);
    text_ = {block_.data(), kept + got};
    return true;
}

void OwnRows::check_end() const {
    if (end_ && (end_->bytes != bytes_ || end_->rows != rows_)) {
        config::fail(damaged_, {name_},
                     joined(std::to_string(rows_), " rows in ", std::to_string(bytes_), " bytes"),
                     joined(std::to_string(end_->rows), " rows in ", std::to_string(end_->bytes),
                            " bytes, as this run wrote it"),
                     "run again with --overwrite");
    }
}

void OwnRows::refuse(const std::string& found) const {
    const bool in_a_run = damaged_ == config::ExitCode::file;
    config::fail(damaged_, {name_, static_cast<std::size_t>(line_), 1}, joined("a damaged row: ", found),
                 in_a_run ? "a row that this run wrote" : "a row that a run wrote",
                 in_a_run ? "run again with --overwrite"
                          : "put the table back as it was, or run the scenario again with --overwrite");
}

}  // namespace coupling
