#include "coupling/inputs/grids/xml_elements.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"

namespace coupling::grids {
namespace {

constexpr std::string_view blanks = " \t\r\n";
constexpr std::size_t most_levels = 64;
constexpr std::size_t most_elements = 1'000'000;

/// The letter of an entity by number, where it is one of ASCII: others do not stand in names of files here.
std::optional<char> letter_of(std::string_view digits) {
    const auto number = config::parse_whole(digits);
    return number && *number > 0 && *number < 128 ? std::optional{static_cast<char>(*number)} : std::nullopt;
}

std::string without_entities(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, char>, 5> entities{
        {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};
    std::string plain;
    plain.reserve(text.size());
    while (!text.empty()) {
        const auto known = std::find_if(entities.begin(), entities.end(),
                                        [&](const auto& entity) { return text.starts_with(entity.first); });
        if (known != entities.end()) {
            plain += known->second;
            text.remove_prefix(known->first.size());
            continue;
        }
        if (const std::size_t end = text.starts_with("&#") ? text.find(';') : std::string_view::npos;
            end != std::string_view::npos && end < 8) {
            if (const auto letter = letter_of(text.substr(2, end - 2))) {
                plain += *letter;
                text.remove_prefix(end + 1);
                continue;
            }
        }
        plain += text.front();
        text.remove_prefix(1);
    }
    return plain;
}

/// Goes through a text from mark to mark.
class XmlReader {
public:
    XmlReader(std::string_view text, const std::string& file)
        : text_{config::without_byte_order_mark(text)}, file_{file} {}

    std::vector<XmlElement> read() {
        while (at_ < text_.size()) {
            const std::size_t mark = std::min(text_.find('<', at_), text_.size());
            take_text(text_.substr(at_, mark - at_));
            go_to(mark);
            if (mark == text_.size()) {
                break;
            }
            const std::string_view rest = text_.substr(at_);
            if (rest.starts_with("<![CDATA[")) {
                const std::size_t end = end_of("]]>");
                if (!open_.empty()) {
                    elements_[open_.back()].text += text_.substr(at_ + 9, end - at_ - 9);
                }
                go_to(end + 3);
            } else if (rest.starts_with("<!--")) {
                go_to(end_of("-->") + 3);
            } else if (rest.starts_with("<?") || rest.starts_with("<!")) {
                go_to(end_of(">") + 1);
            } else if (rest.starts_with("</")) {
                close();
            } else {
                begin();
            }
        }
        if (elements_.empty() || !open_.empty()) {
            refuse("an XML file that ends before its last element");
        }
        for (XmlElement& element : elements_) {
            element.text = config::trimmed(element.text);
        }
        return std::move(elements_);
    }

private:
    [[noreturn]] void refuse(std::string found) const {
        config::fail(config::ExitCode::data, {file_, line_}, std::move(found), "a complete XML file",
                     "make the file again");
    }
    void go_to(std::size_t place) {
        line_ +=
            static_cast<std::size_t>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                                text_.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
        at_ = place;
    }
    std::size_t end_of(std::string_view mark) const {
        const std::size_t end = text_.find(mark, at_);
        if (end == std::string_view::npos) {
            refuse(config::joined("an XML file without a ", config::in_quotes(mark)));
        }
        return end;
    }
    void take_text(std::string_view piece) {
        if (!open_.empty()) {
            elements_[open_.back()].text += without_entities(piece);
        }
    }
    void close() {
        const std::size_t end = end_of(">");
        const std::string_view name = config::trimmed(text_.substr(at_ + 2, end - at_ - 2));
        if (open_.empty() || elements_[open_.back()].name != name) {
            refuse(
                config::joined("an XML file in which ", config::in_quotes(name), " ends before it begins"));
        }
        open_.pop_back();
        go_to(end + 1);
    }
    void begin() {
        if ((elements_.empty() ? 0U : open_.size()) >= most_levels || elements_.size() >= most_elements ||
            (!elements_.empty() && open_.empty())) {
            refuse("an XML file of too many elements or levels");
        }
        const std::size_t end = end_of_tag();
        std::string_view tag = text_.substr(at_ + 1, end - at_ - 1);
        const bool is_empty = tag.ends_with('/');
        tag.remove_suffix(is_empty ? 1 : 0);
        const std::size_t blank = std::min(tag.find_first_of(blanks), tag.size());
        XmlElement element;
        element.name = tag.substr(0, blank);
        element.line = line_;
        element.parent = open_.empty() ? 0 : open_.back();
        element.attributes = attributes_of(tag.substr(blank));
        elements_.push_back(std::move(element));
        if (!is_empty) {
            open_.push_back(elements_.size() - 1);
        }
        go_to(end + 1);
    }
    /// The `>` of a tag: one in quotes is part of a value.
    std::size_t end_of_tag() const {
        char quote = '\0';
        for (std::size_t place = at_; place < text_.size(); ++place) {
            const char c = text_[place];
            if (quote != '\0') {
                quote = c == quote ? '\0' : quote;
            } else if (c == '"' || c == '\'') {
                quote = c;
            } else if (c == '>') {
                return place;
            }
        }
        refuse("an XML file that ends within a tag");
    }
    std::map<std::string, std::string> attributes_of(std::string_view text) const {
        std::map<std::string, std::string> attributes;
        for (text = config::trimmed(text); !text.empty(); text = config::trimmed(text)) {
            const std::size_t equals = text.find('=');
            const std::string key{config::trimmed(text.substr(0, std::min(equals, text.size())))};
            text.remove_prefix(std::min(equals, text.size() - 1) + 1);
            text = config::trimmed(text);
            const char quote = text.empty() ? '\0' : text.front();
            const std::size_t end =
                quote == '"' || quote == '\'' ? text.find(quote, 1) : std::string_view::npos;
            if (end == std::string_view::npos) {
                refuse(config::joined("an XML file with an attribute ", config::in_quotes(key),
                                      " without a value"));
            }
            attributes[key] = without_entities(text.substr(1, end - 1));
            text.remove_prefix(end + 1);
        }
        return attributes;
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    std::vector<XmlElement> elements_;
    std::vector<std::size_t> open_;  ///< numbers of the elements around the place
};

}  // namespace

std::vector<XmlElement> elements_of_xml(std::string_view text, const std::string& file) {
    return XmlReader{text, file}.read();
}

}  // namespace coupling::grids
