#include "config/table/records.hpp"

#include <algorithm>
#include <utility>

#include "config/table/table.hpp"
#include "config/text/reading.hpp"

namespace config {

namespace {

/// What makes all that follows meaningless: reported alone, before it fills the memory.
[[noreturn]] void refuse_at_once(const Place& place, std::string found, std::string expected) {
    fail(ExitCode::data, place, std::move(found), std::move(expected));
}

}  // namespace

Records::Records(std::string_view text, const std::string& file, Problems& problems, std::size_t lines_above)
    : text_{text}, problems_{problems}, place_{file, 1, 1}, separator_{separator_of_header(lines_above)} {}

Record Records::next() {
    while (!at_end()) {
        if (text_[at_] == '#') {
            skip_line();
            continue;
        }
        Record record = read_record();
        if (std::any_of(record.begin(), record.end(),
                        [](const Field& field) { return !field.text.empty(); })) {
            return record;
        }
    }
    return {};
}

/// What separates the fields of the first line: tabs where they are more than commas and semicolons, else
/// a semicolon (Excel's in much of Europe) where there is one outside quotes and no comma. Excel may say
/// it in a line of its own before all others, which is passed over then.
char Records::separator_of_header(std::size_t lines_above) {
    const bool has_explanations = lines_above > 0;
    for (; lines_above > 0; --lines_above) {
        skip_line();
    }
    if (has_explanations && !at_end() && text_[at_] == '#') {
        advance();  // the header stands in a comment
    }
    constexpr std::string_view announced = "sep=";
    if (text_.size() > announced.size() && text_.starts_with(announced)) {
        const char separator = text_[announced.size()];
        skip_line();
        return separator == ';' || separator == '\t' ? separator : ',';
    }
    std::string_view rest = text_.substr(at_);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size() - 1);
        const std::string_view line = trimmed(rest.substr(0, end + 1));
        rest.remove_prefix(end + 1);
        if (line.empty() || line.front() == '#') {
            continue;
        }
        bool quoted = false;
        std::size_t commas = 0;
        std::size_t semicolons = 0;
        std::size_t tabs = 0;
        for (const char c : line) {
            quoted = quoted != (c == '"');
            commas += !quoted && c == ',' ? 1U : 0U;
            semicolons += !quoted && c == ';' ? 1U : 0U;
            tabs += !quoted && c == '\t' ? 1U : 0U;
        }
        return tabs > commas + semicolons ? '\t' : commas == 0 && semicolons > 0 ? ';' : ',';
    }
    return ',';
}

void Records::advance() {
    const char c = text_[at_++];
    if (c == '\n') {
        ++place_.line;
        place_.column = 1;
    } else if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) {
        ++place_.column;
    }
}

void Records::skip_line() {
    while (!at_end() && text_[at_] != '\n') {
        advance();
    }
    if (!at_end()) {
        advance();
    }
}

Record Records::read_record() {
    Record record;
    while (true) {
        if (record.size() == Table::most_columns) {
            refuse_at_once(place_, "a line of more than " + std::to_string(Table::most_columns) + " fields",
                           "a table of at most so many columns: is this the file that was meant, and do its "
                           "lines end where rows end?");
        }
        record.push_back(read_field());
        if (at_end() || text_[at_] == '\n') {
            skip_line();
            return record;
        }
        advance();  // the separator
    }
}

Field Records::read_field() {
    while (!at_end() && (text_[at_] == ' ' || text_[at_] == '\t') && text_[at_] != separator_) {
        advance();
    }
    const Place start = place_;
    const bool quoted = !at_end() && text_[at_] == '"';
    std::string text = quoted ? read_quoted() : std::string{};
    const std::size_t plain_start = at_;
    while (!at_end() && text_[at_] != separator_ && text_[at_] != '\n') {
        advance();
        check_length(at_ - plain_start, start);
    }
    const std::string_view plain = trimmed(text_.substr(plain_start, at_ - plain_start));
    if (quoted && !plain.empty()) {
        problems_.add(ExitCode::data, start, in_quotes(plain) + " after a closing quote",
                      "quotes around the whole field");
    }
    text += plain;
    return {std::move(text), start};
}

std::string Records::read_quoted() {
    const Place start = place_;
    std::string text;
    advance();
    while (!at_end()) {
        if (text_[at_] == '"') {
            advance();
            if (at_end() || text_[at_] != '"') {
                return text;
            }
        }
        text += text_[at_];
        advance();
        check_length(text.size(), start);
    }
    problems_.add(ExitCode::data, start, "a quote that is never closed");
    return text;
}

void Records::check_length(std::size_t bytes, const Place& start) const {
    if (bytes > Table::longest_field_bytes) {
        refuse_at_once(start,
                       "a field of more than " + std::to_string(Table::longest_field_bytes / 1'000'000) +
                           " million bytes",
                       "shorter fields: is this the file that was meant, or is a quote not closed?");
    }
}

}  // namespace config
