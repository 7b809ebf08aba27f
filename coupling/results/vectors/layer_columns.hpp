#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coupling/results/geopackage/package.hpp"
#include "coupling/results/text/element.hpp"

namespace coupling::vectors {

/// The unit of a column in words for readers, such as "kJ"; "" for words and for what has none.
std::string unit_of(const geopackage::Column& column);

/// "12.3 kJ".
std::string with_unit(const std::string& field, const geopackage::Column& column);

/// What a feature is called: its name, or else its first field.
std::string name_of(const geopackage::Plan& plan, const std::vector<std::string>& fields);

/// The first line of an XML text.
inline constexpr const char* xml_line = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

/// Both tags of an element of XML that is written piece by piece, each with the end of its line.
struct Tags {
    std::string begin;
    std::string end;
};
Tags tags_of(std::string_view name, const report::Attributes& attributes = {});

}  // namespace coupling::vectors
