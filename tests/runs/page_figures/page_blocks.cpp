#include "tests/runs/page_figures/page_blocks.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

namespace coupling::page_figures {
namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

/// "10" and raised digits behind it become the exponent of what stands before.
void write_powers(std::string& text) {
    constexpr std::string_view times = "\u00a0\u00b7\u00a010";
    constexpr std::array<std::pair<std::string_view, char>, 11> raised{{{"\u207b", '-'},
                                                                        {"\u2070", '0'},
                                                                        {"\u00b9", '1'},
                                                                        {"\u00b2", '2'},
                                                                        {"\u00b3", '3'},
                                                                        {"\u2074", '4'},
                                                                        {"\u2075", '5'},
                                                                        {"\u2076", '6'},
                                                                        {"\u2077", '7'},
                                                                        {"\u2078", '8'},
                                                                        {"\u2079", '9'}}};
    for (std::size_t at = text.find(times); at != std::string::npos; at = text.find(times, at)) {
        std::string exponent = "e";
        std::size_t end = at + times.size();
        for (bool more = true; more;) {
            more = false;
            for (const auto& [sign, plain] : raised) {
                if (std::string_view{text}.substr(end).starts_with(sign)) {
                    exponent += plain;
                    end += sign.size();
                    more = true;
                }
            }
        }
        text.replace(at, end - at, exponent);
        at += exponent.size();
    }
}

/// A narrow blank between digits separates their groups.
void join_groups(std::string& text) {
    constexpr std::string_view narrow = "\u202f";
    for (std::size_t at = text.find(narrow); at != std::string::npos; at = text.find(narrow, at)) {
        const bool between =
            at > 0 && is_digit(text[at - 1]) && at + narrow.size() < text.size() && is_digit(text[at + 3]);
        text.replace(at, narrow.size(), between ? "" : " ");
    }
}

std::string plain(std::string text) {
    write_powers(text);
    join_groups(text);
    for (const auto& [from, to] : {std::pair{"\u00a0", " "},
                                   {"\u2212", "-"},
                                   {"&lt;", "<"},
                                   {"&gt;", ">"},
                                   {"&quot;", "\""},
                                   {"&#39;", "'"},
                                   {"&amp;", "&"}}) {
        replace_all(text, from, to);
    }
    std::string single;
    for (const char c : text) {
        const bool is_blank = std::isspace(static_cast<unsigned char>(c)) != 0;
        if (!is_blank) {
            single += c;
        } else if (!single.empty() && single.back() != ' ') {
            single += ' ';
        }
    }
    if (single.ends_with(' ')) {
        single.pop_back();
    }
    return single;
}

constexpr std::array<std::string_view, 3> unread{"script", "style", "head"};
/// Of words and groups of drawings.
constexpr std::array<std::string_view, 7> of_axes{"axis-number", "axis-title", "distance", "name",
                                                  "coordinates", "bar",        "north"};
constexpr std::array<std::string_view, 19> breaking{
    "p",  "li",      "ul",    "dl",    "dt",    "dd",         "div",    "section", "details", "summary",
    "h1", "caption", "table", "thead", "tbody", "figcaption", "figure", "main",    "footer"};

template <class Names>
bool is_among(const Names& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Reads tag after tag.
class Reader {
public:
    std::vector<PageBlock> blocks;

    void text(std::string_view more) { text_ += more; }
    void tag(std::string_view name, bool closes) {
        if (name == "h2" || name == "h3") {
            heading(name, closes);
        } else if (name == "tr") {
            closes ? end_row() : begin_row();
        } else if (name == "td" || name == "th") {
            closes ? end_cell() : text_.clear();
        } else if (in_row_) {
            text_ += name == "br" || is_among(breaking, name) ? " " : "";
        } else if (is_among(breaking, name)) {
            flush();
            if (name == "table") {
                now_.group.clear();
                first_cell_.clear();
            }
        } else if (name == "br") {
            text_ += ' ';
        }
    }
    /// A drawing that was met: it does not end the sentence around it.
    void drawing(const std::string& words) {
        if (!words.empty()) {
            blocks.push_back(now_);
            blocks.back().group.clear();
            blocks.back().text = words;
            blocks.back().is_drawn = true;
        }
    }
    void flush() { add(plain(std::exchange(text_, {}))); }

private:
    void add(std::string text) {
        if (!text.empty()) {
            blocks.push_back(now_);
            blocks.back().text = std::move(text);
        }
    }
    void heading(std::string_view name, bool closes) {
        if (!closes) {
            flush();
            return;
        }
        std::string words = plain(std::exchange(text_, {}));
        now_.group.clear();
        if (name == "h2") {
            now_.section = std::move(words);
            now_.part.clear();
        } else {
            now_.part = std::move(words);
        }
    }
    void begin_row() {
        flush();
        in_row_ = true;
        cells_.clear();
    }
    void end_cell() { cells_.push_back(plain(std::exchange(text_, {}))); }

public:
    /// The warnings of the first screen belong to no heading, wherever they stand.
    void begin_warnings() {
        flush();
        around_ = now_;
        now_ = {};
    }
    void end_warnings() {
        flush();
        if (around_) {
            now_ = *std::exchange(around_, std::nullopt);
        }
    }

private:
    void end_row() {
        in_row_ = false;
        if (cells_.size() == 1) {
            now_.group = cells_.front();
            first_cell_.clear();
            add(cells_.front());
            return;
        }
        if (!cells_.empty()) {
            first_cell_ = cells_.front().empty() ? first_cell_ : cells_.front();
            cells_.front() = first_cell_;
        }
        while (!cells_.empty() && cells_.back().empty()) {
            cells_.pop_back();
        }
        std::string row;
        for (const std::string& cell : cells_) {
            row += (row.empty() ? "" : " | ") + cell;
        }
        add(std::move(row));
    }

    PageBlock now_;
    std::optional<PageBlock> around_;  ///< of the warnings that are being read
    std::string text_;
    std::vector<std::string> cells_;
    std::string first_cell_;
    bool in_row_ = false;
};

/// End of the element that begins at `at`, behind its closing tag.
std::size_t end_of(std::string_view page, std::string_view name, std::size_t at) {
    const std::string open = "<" + std::string{name};
    const std::string close = "</" + std::string{name} + ">";
    int depth = 0;
    while (true) {
        const std::size_t next_close = page.find(close, at);
        const std::size_t next_open = page.find(open, at);
        if (next_close == std::string_view::npos) {
            return page.size();
        }
        if (next_open < next_close) {
            const std::size_t tag_end = page.find('>', next_open);
            depth += page[tag_end - 1] == '/' ? 0 : 1;
            at = tag_end;
            continue;
        }
        at = next_close + close.size();
        if (--depth <= 0) {
            return at;
        }
    }
}

/// The class of a tag; "": it has none.
std::string_view class_of(std::string_view tag) {
    constexpr std::string_view attribute = "class=\"";
    const std::size_t begin = tag.find(attribute);
    if (begin == std::string_view::npos) {
        return {};
    }
    const std::string_view rest = tag.substr(begin + attribute.size());
    return rest.substr(0, rest.find('"'));
}

/// The words of a drawing.
std::string words_drawn(std::string_view svg) {
    std::string words;
    for (std::size_t at = svg.find('<', 1); at < svg.size(); at = svg.find('<', at + 1)) {
        const std::string_view tag = svg.substr(at, svg.find('>', at) - at);
        const bool is_group = tag.starts_with("<g ");
        const bool is_text = tag.starts_with("<text ");
        if (!is_group && !is_text) {
            continue;
        }
        const bool is_of_axis = is_among(of_axes, class_of(tag));
        const std::size_t end = end_of(svg, is_group ? "g" : "text", at);
        if (is_text && !is_of_axis) {
            words += (words.empty() ? "" : " | ") + as_in_blocks(svg.substr(at, end - at));
        }
        at = is_text || is_of_axis ? end - 1 : at;
    }
    return words;
}

}  // namespace

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

std::vector<PageBlock> blocks_of(std::string_view page) {
    Reader reader;
    for (std::size_t at = 0; at < page.size();) {
        if (page[at] != '<') {
            const std::size_t end = std::min(page.find('<', at), page.size());
            reader.text(page.substr(at, end - at));
            at = end;
            continue;
        }
        const bool closes = page.substr(at).starts_with("</");
        const std::size_t begin = at + (closes ? 2 : 1);
        const std::size_t end = std::min(page.find_first_of(" />\n", begin), page.size());
        const std::string_view name = page.substr(begin, end - begin);
        if (!closes && is_among(unread, name)) {
            at = end_of(page, name, at);
            continue;
        }
        if (!closes && name == "svg") {
            const std::size_t behind = end_of(page, name, at);
            reader.drawing(words_drawn(page.substr(at, behind - at)));
            at = behind;
            continue;
        }
        reader.tag(name, closes);
        if (page.substr(at).starts_with("<section class=\"alert\"")) {
            reader.begin_warnings();
        } else if (closes && name == "section") {
            reader.end_warnings();
        }
        at = std::min(page.find('>', begin), page.size() - 1) + 1;
    }
    reader.flush();
    return reader.blocks;
}

std::string as_in_blocks(std::string_view html) {
    std::string text;
    bool in_tag = false;
    for (const char c : html) {
        in_tag = in_tag || c == '<';
        if (!in_tag) {
            text += c;
        }
        in_tag = in_tag && c != '>';
    }
    return plain(text);
}

std::vector<std::string> sentences_of(std::string_view text) {
    std::vector<std::string> sentences;
    std::size_t begin = 0;
    for (std::size_t at = text.find(". "); at != std::string_view::npos; at = text.find(". ", at + 1)) {
        const char next = at + 2 < text.size() ? text[at + 2] : ' ';
        if (std::isupper(static_cast<unsigned char>(next)) != 0 || is_digit(next) || next == '{') {
            sentences.emplace_back(text.substr(begin, at + 1 - begin));
            begin = at + 2;
        }
    }
    sentences.emplace_back(text.substr(begin));
    return sentences;
}

}  // namespace coupling::page_figures
