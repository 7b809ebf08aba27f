#include "config/grid/ascii_grid.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"

namespace config {

namespace {

constexpr double conventional_nodata = -9999.0;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
// Beyond these, sizes and places in metres are slips or damage, and areas no longer fit a number [choice].
constexpr double largest_cell_m = 1e5;
constexpr double farthest_place_m = 1e9;
// As many as other formats and maps may have [choice]. Triangles of a terrain, two to a cell, are numbered by
// 32 bits.
constexpr std::size_t most_cells = 400'000'000;
constexpr std::size_t most_bad_values = 20;  // a file of another kind would fill the screen

const std::vector<std::string> header_keys{"ncols",     "nrows",    "xllcorner", "xllcenter", "yllcorner",
                                           "yllcenter", "cellsize", "dx",        "dy",        "nodata_value"};

/// A grid's text on its way through the reader.
struct Reading {
    std::string_view text;
    const std::string& file;
    Problems problems{};
    std::size_t at = 0;

    [[nodiscard]] std::size_t offset_of(std::string_view token) const {
        return static_cast<std::size_t>(token.data() - text.data());
    }
    [[nodiscard]] Place place(std::string_view token) const {
        return place_in(text, offset_of(token), {file});
    }

    void skip_blanks() {
        while (at < text.size() && is_blank(text[at])) {
            ++at;
        }
    }
    /// The next word, which is empty at the end of the text.
    std::string_view next_token() {
        skip_blanks();
        const std::size_t start = at;
        while (at < text.size() && !is_blank(text[at])) {
            ++at;
        }
        return text.substr(start, at - start);
    }
    void refuse(std::string_view token, std::string found, std::string expected) {
        problems.add(ExitCode::data, place(token), std::move(found), std::move(expected));
    }
};

struct HeaderEntry {
    std::string key;
    std::string_view value;
};
using HeaderEntries = std::vector<HeaderEntry>;

std::optional<std::string_view> value_of(const HeaderEntries& entries, std::string_view key) {
    for (const HeaderEntry& entry : entries) {
        if (entry.key == key) {
            return entry.value;
        }
    }
    return std::nullopt;
}

/// Whether a word belongs to the header: `nan`, `null` and `inf` are letters too, but stand for values.
bool is_key(std::string_view token) {
    const std::string word = in_lower_case(token);
    return !word.empty() && std::isalpha(static_cast<unsigned char>(word[0])) != 0 &&
           (word == "nodata" || !is_word_for_nodata(word)) && word != "inf" && word != "infinity";
}

std::string canonical_key(std::string_view token) {
    const std::string key = in_lower_case(token);
    if (key == "xllcentre" || key == "yllcentre") {
        return key.substr(0, 4) + "enter";
    }
    return key == "nodata" ? "nodata_value" : key;
}

/// Whether a text speaks of columns as the header of a grid does: if not, it is none at all.
bool names_columns(std::string_view text) {
    constexpr std::size_t longest_header = 1000;
    return in_lower_case(text.substr(0, longest_header)).find("ncols") != std::string::npos;
}

HeaderEntries read_header_entries(Reading& reading) {
    HeaderEntries entries;
    reading.skip_blanks();
    const std::size_t first = reading.at;
    while (reading.problems.list().size() < most_bad_values) {
        reading.skip_blanks();
        const std::size_t start = reading.at;
        const std::string_view token = reading.next_token();
        if (!is_key(token)) {
            reading.at = start;
            return entries;
        }
        const std::string key = canonical_key(token);
        const std::string_view value = reading.next_token();
        if (std::find(header_keys.begin(), header_keys.end(), key) == header_keys.end()) {
            const std::string nearest = nearest_word(key, header_keys);
            if (nearest.empty() && start == first && !names_columns(reading.text)) {
                fail(ExitCode::data, reading.place(token), "a text that begins with " + in_quotes(token),
                     "an ESRI ASCII grid, which begins with ncols", "name a grid, GeoTIFF or ESRI ASCII");
            }
            reading.refuse(token, in_quotes(token),
                           nearest.empty() ? "a header key or a number" : in_quotes(nearest));
        } else if (value_of(entries, key)) {
            reading.refuse(token, in_quotes(token).append(" a second time"), "each header key once");
        } else {
            entries.push_back({key, value});
        }
    }
    return entries;
}

/// The numbers of a header, each checked where it is taken.
class Header {
public:
    Header(HeaderEntries entries, Reading& reading) : entries_{std::move(entries)}, reading_{reading} {}

    [[nodiscard]] bool has(std::string_view key) const { return value_of(entries_, key).has_value(); }

    int count(std::string_view key) {
        const NumberRange range{1.0, std::numeric_limits<int>::max()};
        const std::optional<std::string_view> text = required(key);
        const std::optional<long long> value = text ? parse_whole(*text) : 1;
        if (value && range.contains(static_cast<double>(*value))) {
            return static_cast<int>(*value);
        }
        refuse_value(key, *text, describe("a whole number", range));
        return 1;
    }

    double number(std::string_view key, const NumberRange& range = {}) {
        const std::optional<std::string_view> text = required(key);
        const std::optional<double> value = text ? parse_number(*text) : 1.0;
        if (value && (!text || range.contains(*value))) {
            return *value;
        }
        refuse_value(key, *text, describe("a number", range));
        return 1.0;
    }

    double cell_size_m(std::string_view key) {
        const double size_m = number(key, {.low = 0.0, .low_excluded = true});
        if (size_m > largest_cell_m) {
            refuse_value(key, *required(key), "cells of at most 100 km; correct the header");
        }
        return size_m;
    }

    double place_m(std::string_view key) {
        const double place = number(key);
        if (std::abs(place) > farthest_place_m) {
            refuse_value(key, *required(key),
                         "metres of a projected coordinate system, at most 1e9; correct the header");
        }
        return place;
    }

    /// What stands for "no value here": -9999 if the header does not say, as ESRI defines the format.
    double nodata() {
        const std::optional<std::string_view> text = value_of(entries_, "nodata_value");
        if (!text) {
            return conventional_nodata;
        }
        return is_word_for_nodata(*text) ? not_a_number : number("nodata_value");
    }

    void refuse_both(std::string_view key, std::string_view other) {
        if (has(key) && has(other)) {
            reading_.refuse(*value_of(entries_, other),
                            std::string{key}.append(" and ").append(other).append(" in one header"),
                            "one of them");
        }
    }

private:
    std::optional<std::string_view> required(std::string_view key) {
        const std::optional<std::string_view> text = value_of(entries_, key);
        if (!text) {
            reading_.refuse(
                reading_.text.substr(reading_.at, 0), std::string{"a header without "}.append(in_quotes(key)),
                "ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize or dx and dy");
        }
        return text;
    }
    void refuse_value(std::string_view key, std::string_view text, std::string expected) {
        reading_.refuse(text, std::string{key}.append(" ").append(text.empty() ? "empty" : in_quotes(text)),
                        std::move(expected));
    }

    HeaderEntries entries_;
    Reading& reading_;
};

GridFrame frame_of(Header& header) {
    header.refuse_both("xllcorner", "xllcenter");
    header.refuse_both("yllcorner", "yllcenter");
    header.refuse_both("cellsize", "dx");
    header.refuse_both("cellsize", "dy");

    GridFrame frame;
    frame.columns = header.count("ncols");
    frame.rows = header.count("nrows");
    const bool oblong = header.has("dx") || header.has("dy");
    frame.cell_width_m = header.cell_size_m(oblong ? "dx" : "cellsize");
    frame.cell_height_m = oblong ? header.cell_size_m("dy") : frame.cell_width_m;
    frame.x_west_m = header.has("xllcenter") ? header.place_m("xllcenter") - 0.5 * frame.cell_width_m
                                             : header.place_m("xllcorner");
    frame.y_south_m = header.has("yllcenter") ? header.place_m("yllcenter") - 0.5 * frame.cell_height_m
                                              : header.place_m("yllcorner");
    return frame;
}

/// The value of a word that from_chars alone did not take; NaN with a problem noted where it is none.
double careful_value(Reading& reading, std::string_view token, double nodata, GridWords& words) {
    if (is_word_for_nodata(token)) {
        if (!std::isnan(nodata) && words.cells++ == 0) {
            words.first = token;
        }
        return not_a_number;
    }
    const std::optional<double> value = parse_number(token);
    if (!value) {
        const bool decimal_comma = token.find(',') != std::string_view::npos;
        reading.refuse(token, in_quotes(token), decimal_comma ? "a number with a decimal point" : "a number");
    }
    return value && *value != nodata ? *value : not_a_number;
}

/// Reads up to `expected` values; fewer come back where the text ends early.
std::vector<double> read_values(Reading& reading, std::size_t expected, double nodata, GridWords& words) {
    const std::size_t most = (reading.text.size() - reading.at) / 2 + 1;  // a digit and a blank each
    std::vector<double> values(std::min(expected, most));
    const char* const end = reading.text.data() + reading.text.size();
    std::size_t count = 0;
    while (count < values.size() && reading.problems.list().size() < most_bad_values) {
        reading.skip_blanks();
        const char* const start = reading.text.data() + reading.at;
        double value = 0.0;
        const auto [stop, error] = std::from_chars(start, end, value);
        if (error == std::errc{} && (stop == end || is_blank(*stop)) && std::isfinite(value)) {
            reading.at += static_cast<std::size_t>(stop - start);
            values[count++] = value == nodata ? not_a_number : value;
            continue;
        }
        const std::string_view token = reading.next_token();
        if (token.empty()) {
            break;
        }
        values[count++] = careful_value(reading, token, nodata, words);
    }
    values.resize(count);
    return values;
}

std::string counted(std::size_t found) {
    return std::to_string(found).append(found == 1 ? " value" : " values");
}

void check_count(Reading& reading, std::size_t found, const GridFrame& frame) {
    const std::string expected = std::to_string(frame.size())
                                     .append(" (ncols ")
                                     .append(std::to_string(frame.columns))
                                     .append(" x nrows ")
                                     .append(std::to_string(frame.rows))
                                     .append(")");
    if (found < frame.size()) {
        reading.refuse(reading.text.substr(reading.text.size()),
                       counted(found).append(" where the file ends"), expected);
        return;
    }
    const std::string_view surplus = reading.next_token();
    if (!surplus.empty()) {
        std::size_t all = found + 1;
        while (!reading.next_token().empty()) {
            ++all;
        }
        reading.refuse(surplus, counted(all).append(", the first too many is ").append(in_quotes(surplus)),
                       expected);
    }
}

/// The shortest text of a value, several times faster for whole numbers that need no exponent.
template <class Number>
char* write_value(char* next, char* end, Number value) {
    constexpr Number most_in_full{99'999};
    if (std::abs(value) <= most_in_full && !(value == Number{0} && std::signbit(value))) {
        if (const auto whole = static_cast<int>(value); static_cast<Number>(whole) == value) {
            return std::to_chars(next, end, whole).ptr;
        }
    }
    return std::to_chars(next, end, value).ptr;
}

template <class Number>
void write(std::ostream& out, const Raster<Number>& raster) {
    const GridFrame& frame = raster.frame;
    out << "ncols " << frame.columns << "\nnrows " << frame.rows;
    out << "\nxllcorner " << to_text(frame.x_west_m) << "\nyllcorner " << to_text(frame.y_south_m);
    if (frame.cell_width_m == frame.cell_height_m) {
        out << "\ncellsize " << to_text(frame.cell_width_m);
    } else {
        out << "\ndx " << to_text(frame.cell_width_m) << "\ndy " << to_text(frame.cell_height_m);
    }
    const std::string nodata = to_text(conventional_nodata);
    out << "\nNODATA_value " << nodata << '\n';

    constexpr std::size_t longest = 32;  // of one number and its separator
    const auto columns = static_cast<std::size_t>(frame.columns);
    std::vector<char> line(columns * longest);
    for (auto row = raster.values.begin(); row != raster.values.end(); row += frame.columns) {
        char* next = line.data();
        for (std::size_t column = 0; column < columns; ++column) {
            const Number value = row[static_cast<std::ptrdiff_t>(column)];
            assert(!std::isinf(value));
            next = std::isnan(value) ? std::copy(nodata.begin(), nodata.end(), next)
                                     : write_value(next, next + longest, value);
            *next++ = column + 1 == columns ? '\n' : ' ';
        }
        out.write(line.data(), next - line.data());
    }
}

}  // namespace

bool is_word_for_nodata(std::string_view word) {
    constexpr std::array words{
        "nan",    "-nan",    "+nan",    "nan(ind)", "-nan(ind)", "nan(snan)", "1.#qnan",  "-1.#qnan",
        "1.#ind", "-1.#ind", "1.#snan", "-1.#snan", "1.#qnan0",  "-1.#qnan0", "1.#ind00", "-1.#ind00",
        "null",   "(null)",  "<null>",  "na",       "<na>",      "n/a",       "#n/a",     "nd",
        "none",   "nodata",  "no_data", "nil",      "*",         "-",         "--",       "---"};
    return std::any_of(words.begin(), words.end(),
                       [low = in_lower_case(word)](const char* known) { return low == known; });
}

namespace {

/// Before any value is read or takes memory.
void check_size(const GridFrame& frame, const std::string& file) {
    if (frame.size() > most_cells) {
        fail(ExitCode::data, {file},
             std::to_string(frame.columns) + " x " + std::to_string(frame.rows) + " cells",
             "a grid of 1 to 400 million cells",
             "take coarser cells, or cut the grid into tiles: terrain.extent_m takes those that matter");
    }
}

Header header_of(Reading& reading) {
    HeaderEntries entries = read_header_entries(reading);
    if (entries.empty() && reading.problems.list().empty()) {
        fail(ExitCode::data, {reading.file}, "a text without the header of a grid",
             "an ESRI ASCII grid, which begins with ncols", "export it again, as GeoTIFF or ESRI ASCII");
    }
    return {std::move(entries), reading};
}

}  // namespace

GridFrame read_ascii_frame(std::string_view beginning, const std::string& file) {
    Reading reading{.text = without_byte_order_mark(beginning), .file = file};
    Header header = header_of(reading);
    const GridFrame frame = frame_of(header);
    reading.problems.throw_if_any();
    return frame;
}

AsciiGrid read_ascii_grid_with_words(std::string_view text, const std::string& file) {
    Reading reading{.text = without_byte_order_mark(text), .file = file};
    Header header = header_of(reading);

    AsciiGrid grid;
    grid.raster.frame = frame_of(header);
    const double nodata = header.nodata();
    reading.problems.throw_if_any();
    check_size(grid.raster.frame, file);

    grid.raster.values = read_values(reading, grid.raster.frame.size(), nodata, grid.words);
    if (reading.problems.list().size() < most_bad_values) {
        check_count(reading, grid.raster.values.size(), grid.raster.frame);
    }
    reading.problems.throw_if_any();
    return grid;
}

Raster<double> read_ascii_grid(std::string_view text, const std::string& file) {
    return read_ascii_grid_with_words(text, file).raster;
}

std::optional<std::uint64_t> most_grid_bytes(std::string_view beginning) {
    constexpr std::uint64_t bytes_a_value = 64;
    constexpr std::uint64_t header_bytes = std::uint64_t{1} << 20U;
    const std::string file;
    Reading reading{.text = without_byte_order_mark(beginning), .file = file};
    std::optional<std::uint64_t> columns;
    std::optional<std::uint64_t> rows;
    for (std::size_t entry = 0; entry < header_keys.size(); ++entry) {
        const std::string key = canonical_key(reading.next_token());
        const std::string_view value = reading.next_token();
        if (std::find(header_keys.begin(), header_keys.end(), key) == header_keys.end()) {
            break;
        }
        const std::optional<long long> count = parse_whole(value);
        if (!count || *count < 1 || *count > std::numeric_limits<int>::max()) {
            continue;  // no count, or one that the reader of the whole grid refuses
        }
        if (key == "ncols") {
            columns = static_cast<std::uint64_t>(*count);
        } else if (key == "nrows") {
            rows = static_cast<std::uint64_t>(*count);
        }
    }
    if (!columns || !rows) {
        return std::nullopt;
    }
    const std::uint64_t cells = *columns * *rows;  // below 2^62
    const std::uint64_t most_cells = std::numeric_limits<std::uint64_t>::max() / bytes_a_value / 2;
    return std::min(cells, most_cells) * bytes_a_value + header_bytes;
}

void write_ascii_grid(std::ostream& out, const Raster<double>& raster) {
    write(out, raster);
}
void write_ascii_grid(std::ostream& out, const Raster<float>& raster) {
    write(out, raster);
}

}  // namespace config
