#include "tests/coupling/results/markup_checks.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include "config/text/joined.hpp"

namespace coupling::text_checks {
namespace {

using config::joined;

/// "" or what is wrong between two tags.
std::string text_fault(const std::string& text) {
    for (std::size_t at = text.find('&'); at != std::string::npos; at = text.find('&', at + 1)) {
        const std::string rest = text.substr(at, 8);
        const auto is = [&](const char* entity) { return rest.starts_with(entity); };
        if (!is("&amp;") && !is("&lt;") && !is("&gt;") && !is("&quot;")) {
            return joined("bare & in: ", text.substr(at, 40));
        }
    }
    return text.find('>') != std::string::npos ? joined("bare > in: ", text.substr(0, 80)) : "";
}

/// "" or what is wrong with ` name="value" name="value"`, what follows the name of a tag.
std::string attributes_fault(const std::string& tag) {
    std::set<std::string> names;
    std::size_t at = std::min(tag.size(), tag.find_first_of(" \n/"));
    while (true) {
        const std::size_t name = tag.find_first_not_of(" \n/", at);
        if (name == std::string::npos) {
            return "";
        }
        const std::size_t equals = tag.find("=\"", name);
        const std::size_t end = equals == std::string::npos ? equals : tag.find('"', equals + 2);
        if (name == at || end == std::string::npos ||
            tag.substr(name, equals - name).find_first_of(" \n\"<'") != std::string::npos ||
            tag.substr(equals, end - equals).find('<') != std::string::npos) {
            return joined("attributes of <", tag.substr(0, 80), ">");
        }
        if (!names.insert(tag.substr(name, equals - name)).second) {
            return joined("attribute twice in <", tag.substr(0, 80), ">");
        }
        at = end + 1;
    }
}

/// Where a tag ends: the next > outside quotes.
std::size_t end_of_tag(const std::string& text, std::size_t at) {
    for (char quote = '\0'; at < text.size(); ++at) {
        const char c = text[at];
        if (quote != '\0') {
            quote = c == quote ? '\0' : quote;
        } else if (c == '"') {
            quote = c;
        } else if (c == '>') {
            return at;
        }
    }
    return std::string::npos;
}

}  // namespace

std::string without_scripts(const std::string& text) {
    std::string rest;
    std::size_t at = 0;
    for (std::size_t begin = text.find("<script"); begin != std::string::npos;
         begin = text.find("<script", at)) {
        const std::size_t first = std::min(text.size(), text.find('>', begin) + 1);
        rest += text.substr(at, first - at);
        at = std::min(text.size(), text.find("</script>", first));
    }
    return rest + text.substr(at);
}

std::string markup_fault(const std::string& page) {
    const std::string text = without_scripts(page);
    static const std::set<std::string> never_closed{"!DOCTYPE", "?xml"};
    std::vector<std::string> open;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t next = std::min(text.find('<', at), text.size());
        if (open.empty() || open.back() != "style") {
            if (const std::string fault = text_fault(text.substr(at, next - at)); !fault.empty()) {
                return fault;
            }
        }
        if (next == text.size()) {
            break;
        }
        const std::size_t last = end_of_tag(text, next);
        if (last == std::string::npos) {
            return joined("a tag does not end: ", text.substr(next, 80));
        }
        const std::string tag = text.substr(next + 1, last - next - 1);
        const std::string name = tag.substr(tag.starts_with('/') ? 1 : 0,
                                            tag.find_first_of(" \n/", 1) - (tag.starts_with('/') ? 1 : 0));
        at = last + 1;
        if (never_closed.contains(name)) {
            continue;
        }
        if (tag.starts_with('/')) {
            if (open.empty() || open.back() != tag.substr(1)) {
                return joined("</", tag.substr(1), "> closes ", open.empty() ? "nothing" : open.back());
            }
            open.pop_back();
            continue;
        }
        if (const std::string fault = attributes_fault(tag); !fault.empty()) {
            return fault;
        }
        if (!tag.ends_with('/')) {
            open.push_back(name);
        }
    }
    return open.empty() ? "" : joined("<", open.back(), "> stays open");
}

}  // namespace coupling::text_checks
