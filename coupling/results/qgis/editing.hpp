#pragma once

#include <span>
#include <string>
#include <vector>

namespace coupling::qgis {

/// A value that a field may have, and how the form lists it.
struct Choice {
    std::string value;
    std::string label;
};

/// A field in the form of QGIS.
struct FormField {
    std::string column;
    std::string alias;              ///< beside the field, instead of the name of the column
    std::vector<Choice> choices{};  ///< a list to choose from; none: any text or number
    bool is_needed = false;         ///< a feature without it is not saved
};

/// How QGIS edits a layer, as XML for its <maplayer>.
std::string form_of(std::span<const FormField> fields);

}  // namespace coupling::qgis
