#pragma once

#include <cstddef>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace config {

/// What the program's exit code means to a script.
enum class ExitCode : int {
    done = 0,
    internal = 1,      ///< a fault of ours
    settings = 2,      ///< usage or settings
    file = 3,          ///< a file is missing, unreadable or cannot be written
    data = 4,          ///< the data are not plausible
    validation = 5,    ///< a validation case lies outside its bounds
    interrupted = 75,  ///< stopped by the user: run again to go on
};

/// Where in the user's input something stands. Line and column count from 1; 0 means "the whole file".
struct Place {
    std::string file{};
    std::size_t line = 0;
    std::size_t column = 0;
};

/// One thing that is wrong with an input: where, what was found, what was expected, what to do about it.
struct Problem {
    ExitCode code = ExitCode::data;
    Place place{};
    std::string found{};
    std::string expected{};  ///< may be empty where `found` says it all
    std::string advice{};  ///< what to do, a phrase such as "exchange the columns"; empty where it is obvious
};

/// "dem.asc:3:7: found 'abc', expected a number; correct the cell"; leaves out what is not known.
std::string to_string(const Problem& problem);

/// All that is wrong with the input, thrown once per file.
class InputError : public std::runtime_error {
public:
    /// Requires at least one problem. The exit code is that of the first.
    explicit InputError(std::vector<Problem> problems);
    [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }
    [[nodiscard]] ExitCode code() const { return problems_.front().code; }

private:
    std::vector<Problem> problems_;
};

/// Throws an InputError of one problem.
[[noreturn]] void fail(ExitCode code, Place place, std::string found, std::string expected = "",
                       std::string advice = "");

/// Collects the problems of a file so that the user sees all of them at once.
class Problems {
public:
    void add(ExitCode code, Place place, std::string found, std::string expected = "",
             std::string advice = "");
    void add(Problem problem) { problems_.push_back(std::move(problem)); }
    void add(const InputError& error);
    [[nodiscard]] bool empty() const { return problems_.empty(); }
    [[nodiscard]] const std::vector<Problem>& list() const { return problems_; }
    void throw_if_any() const;

private:
    std::vector<Problem> problems_;
};

/// Longest text that `nearest_word` looks for a neighbour of [bytes]: no name of ours is half as long, and
/// the search takes time with the square of the length.
inline constexpr std::size_t longest_word_bytes = 64;

/// The legal word nearest to what the user wrote, or "": edit distance up to a third of its length, case
/// ignored. "" for texts above longest_word_bytes.
std::string nearest_word(std::string_view word, const std::vector<std::string>& legal);

/// What the user wrote, as a message shows it: 'in quotes', one line, cut off after 60 bytes.
std::string in_quotes(std::string_view text);

/// Where byte `offset` of a text stands. Columns count characters of UTF-8, as an editor does. `start` is the
/// place of the first byte, for a text that is itself part of a file.
Place place_in(std::string_view text, std::size_t offset, const Place& start);

}  // namespace config
