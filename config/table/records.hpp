#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"

namespace config {

struct Field {
    std::string text;
    Place place;
};
using Record = std::vector<Field>;

/// Cuts the text of a table into records of fields; knows nothing about columns. Faults of quotes are added
/// to the problems; a record or a field that is too long is refused at once (InputError).
class Records {
public:
    /// @param text  valid UTF-8 with lines that end in '\n'; must outlive the object, as must `problems`
    /// @param lines_above  the header (config/table/preamble.hpp), which are passed over
    Records(std::string_view text, const std::string& file, Problems& problems, std::size_t lines_above = 0);

    /// The next record that holds anything; empty at the end.
    Record next();

    [[nodiscard]] const Place& place() const { return place_; }
    [[nodiscard]] char separator() const { return separator_; }

private:
    [[nodiscard]] bool at_end() const { return at_ == text_.size(); }
    [[nodiscard]] char separator_of_header(std::size_t lines_above);
    void advance();
    void skip_line();
    Record read_record();
    Field read_field();
    std::string read_quoted();
    void check_length(std::size_t bytes, const Place& start) const;

    std::string_view text_;
    Problems& problems_;
    std::size_t at_ = 0;
    Place place_;
    char separator_;
};

}  // namespace config
