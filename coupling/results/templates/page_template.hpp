#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace coupling::report {

struct PageField;
/// What a template is filled with.
using PageFields = std::vector<PageField>;

/// A named value of a template: a text for `{{name}}`; for `{{#name}}…{{/name}}` a condition, rows that the
/// section is repeated for, or a part that may be missing.
struct PageField {
    std::string name;
    std::variant<std::string, bool, std::vector<PageFields>> value;

    PageField(std::string of, std::string text);
    PageField(std::string of, std::same_as<bool> auto shown) : name{std::move(of)}, value{shown} {}
    PageField(std::string of, std::vector<PageFields> rows);
    PageField(std::string of, std::optional<PageFields> part);
};

/// The page or part of a page that a template (page_files.hpp) becomes with these fields, in the language in
/// use. Templates are Mustache:
///
///     <h2>{{#t}}Storms{{/t}}</h2>
///     {{#storms}}<p>{{#t}}{name} blew down {trees} trees.{{/t}}</p>{{{chart}}}{{/storms}}
///
/// - `{{#t}}…{{/t}}` holds a whole sentence or label in English, which may go on in the next line; pages.csv
///   has it in the other languages. `{name}` in it is a field.
/// - Escaped are all fields, `{{name}}` and those of sentences. Ready HTML stands as `{{{name}}}`, and in a
///   sentence under a name that ends with `_html`.
/// - `{{>other}}` is replaced by the template other.html. Blanks that begin a line go.
///
/// Throws std::logic_error for a template that does not exist or cannot be read, a sentence without a row in
/// pages.csv, a name without a field (in sections that are shown), and a field that the template does not
/// name.
std::string filled_template(std::string_view file, const PageFields& fields);

}  // namespace coupling::report
