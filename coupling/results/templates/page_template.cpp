#include "coupling/results/templates/page_template.hpp"

#include <kainjow/mustache.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "config/text/joined.hpp"
#include "coupling/results/templates/page_files.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {

PageField::PageField(std::string of, std::string text) : name{std::move(of)}, value{std::move(text)} {}

PageField::PageField(std::string of, std::vector<PageFields> rows)
    : name{std::move(of)}, value{std::move(rows)} {}

PageField::PageField(std::string of, std::optional<PageFields> part)
    : name{std::move(of)}, value{std::vector<PageFields>(part ? 1 : 0, part.value_or(PageFields{}))} {}

namespace {

namespace mustache = kainjow::mustache;
using config::joined;

[[noreturn]] void broken_template(std::string_view file, std::string_view what, std::string_view where) {
    throw std::logic_error(joined("template ", file, ": ", what, ": ", where));
}

/// The text with each match replaced by what `by` makes of it.
template <class By>
std::string replaced(const std::string& text, const std::regex& wanted, const By& by) {
    std::string result;
    auto rest = text.begin();
    for (std::sregex_iterator at{text.begin(), text.end(), wanted}; at != std::sregex_iterator{}; ++at) {
        result.append(rest, (*at)[0].first).append(by(*at));
        rest = (*at)[0].second;
    }
    return result.append(rest, text.end());
}

std::string without_indents(std::string_view text) {
    std::string kept;
    bool begins_line = true;
    for (const char letter : text) {
        begins_line = begins_line && (letter == ' ' || letter == '\t');
        if (!begins_line) {
            kept += letter;
            begins_line = letter == '\n';
        }
    }
    return kept;
}

/// With the templates that it includes, without the blanks that begin its lines.
std::string with_parts(std::string_view file) {
    static const std::regex part{R"(\{\{>\s*(\w+)\s*\}\}\n?)"};
    return replaced(without_indents(page_file(file)), part,
                    [](const std::smatch& found) { return with_parts(joined(found.str(1), ".html")); });
}

/// A sentence in the language in use, its fields as those of the template.
std::string sentence_in_language(const std::string& text) {
    static const std::regex end_of_line{R"(\s*\n)"};
    static const std::regex field{R"(\{(\w+?)(_html)?\})"};
    static const std::regex choice{R"(\{(\w+)\?([^|}]*)\|([^}]*)\})"};
    const std::string english = std::regex_replace(text, end_of_line, " ");
    const std::string chosen =
        std::regex_replace(page_text(english), choice, "{{#$1?one}}$2{{/$1?one}}{{^$1?one}}$3{{/$1?one}}");
    return replaced(chosen, field, [](const std::smatch& name) {
        return name[2].matched ? joined("{{{", name.str(1), "_html}}}") : joined("{{", name.str(1), "}}");
    });
}

std::string in_language(std::string_view text) {
    constexpr std::string_view begin = "{{#t}}";
    constexpr std::string_view end = "{{/t}}";
    std::string result;
    while (true) {
        const std::size_t from = text.find(begin);
        const std::size_t to = text.find(end, from);
        if (from == text.npos || to == text.npos) {
            return result.append(text);
        }
        result.append(text.substr(0, from));
        result +=
            sentence_in_language(std::string{text.substr(from + begin.size(), to - from - begin.size())});
        text.remove_prefix(to + end.size());
    }
}

std::set<std::string> names_of(const std::string& text) {
    static const std::regex tag{R"(\{\{[{#^/]?(\w+)\}\})"};
    return {std::sregex_token_iterator{text.begin(), text.end(), tag, 1}, std::sregex_token_iterator{}};
}

/// Fields as the library wants them.
mustache::data data_of(const PageFields& fields);

struct AsData {
    mustache::data operator()(const std::string& text) const { return text; }
    mustache::data operator()(bool shown) const { return shown; }
    mustache::data operator()(const std::vector<PageFields>& rows) const {
        mustache::data list{mustache::data::type::list};
        for (const PageFields& row : rows) {
            list << data_of(row);
        }
        return list;
    }
};

mustache::data data_of(const PageFields& fields) {
    mustache::data data;
    for (const PageField& field : fields) {
        data.set(field.name, std::visit(AsData{}, field.value));
    }
    return data;
}

void check_names(std::string_view file, const PageFields& fields, const std::set<std::string>& wanted) {
    for (const PageField& field : fields) {
        if (!wanted.contains(field.name)) {
            broken_template(file, "a field that it does not name", field.name);
        }
        if (const auto* rows = std::get_if<std::vector<PageFields>>(&field.value)) {
            for (const PageFields& row : *rows) {
                check_names(file, row, wanted);
            }
        }
    }
}

/// The library leaves out what it does not find.
class AllFields : public mustache::context<std::string> {
public:
    AllFields(std::string_view file, const mustache::data& data) : context{&data}, file_{file} {}

    const mustache::data* get(const std::string& name) const override {
        const mustache::data* found = context::get(name.substr(0, name.find('?')));
        if (found == nullptr) {
            broken_template(file_, "no field for a name", name);
        }
        if (!name.ends_with("?one")) {
            return found;
        }
        return found->is_string() && is_of_one(found->string_value()) ? &yes_ : &no_;
    }

private:
    mustache::data yes_{true};
    mustache::data no_{false};
    std::string_view file_;
};

}  // namespace

std::string filled_template(std::string_view file, const PageFields& fields) {
    const std::string text = in_language(with_parts(file));
    check_names(file, fields, names_of(text));
    mustache::mustache library{text};
    library.set_custom_escape([](const std::string& value) { return escaped(value); });
    const mustache::data data = data_of(fields);
    AllFields context{file, data};
    std::ostringstream page;
    library.render(context, page);
    if (!library.is_valid()) {
        broken_template(file, "cannot be read", library.error_message());
    }
    return page.str();
}

}  // namespace coupling::report
