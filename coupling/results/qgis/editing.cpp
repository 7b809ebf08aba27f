#include "coupling/results/qgis/editing.hpp"

#include "config/text/joined.hpp"
#include "coupling/results/text/element.hpp"

namespace coupling::qgis {
namespace {

using config::joined;
using report::element;

std::string option_of(const Choice& choice) {
    return element("Option", {{"type", "Map"}},
                   element("Option", {{"type", "QString"}, {"name", choice.label}, {"value", choice.value}}));
}

/// A list in the order of the choices, as QGIS 3 writes it.
std::string list_to_choose_from(const std::vector<Choice>& choices) {
    std::string options;
    for (const Choice& choice : choices) {
        options += joined(option_of(choice), "\n");
    }
    const std::string map = element("Option", {{"type", "List"}, {"name", "map"}}, options);
    return element("editWidget", {{"type", "ValueMap"}},
                   element("config", {}, element("Option", {{"type", "Map"}}, map)));
}

}  // namespace

std::string form_of(std::span<const FormField> fields) {
    std::string widgets = "\n";
    std::string aliases = "\n";
    std::string constraints = "\n";
    for (const FormField& field : fields) {
        if (!field.choices.empty()) {
            widgets +=
                joined(element("field", {{"name", field.column}}, list_to_choose_from(field.choices)), "\n");
        }
        aliases += joined(element("alias", {{"field", field.column}, {"name", field.alias}}), "\n");
        if (field.is_needed) {
            constraints += joined(element("constraint", {{"field", field.column},
                                                         {"constraints", "1"},
                                                         {"notnull_strength", "1"},
                                                         {"unique_strength", "0"},
                                                         {"exp_strength", "0"}}),
                                  "\n");
        }
    }
    return joined(element("fieldConfiguration", {}, widgets), "\n", element("aliases", {}, aliases), "\n",
                  element("constraints", {}, constraints), "\n");
}

}  // namespace coupling::qgis
