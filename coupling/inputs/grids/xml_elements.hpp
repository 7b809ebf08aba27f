#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace coupling::grids {

/// An element of a text in XML.
struct XmlElement {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::string text;        ///< directly in it, without blanks at both ends
    std::size_t line = 1;    ///< where it begins
    std::size_t parent = 0;  ///< its number; that of the outermost is 0, its own

    /// The value of an attribute, "" without it.
    [[nodiscard]] std::string attribute(const std::string& key) const {
        const auto found = attributes.find(key);
        return found == attributes.end() ? std::string{} : found->second;
    }
};

/// The elements of a text in XML in the order in which they begin, the outermost first: enough for the small
/// files that describe rasters. Comments, processing instructions and a DOCTYPE are passed over, the five
/// named entities and those by number are replaced, others are kept as they stand: nothing is looked up.
///
/// Throws config::InputError (data) for a text that is no XML, more than 64 levels or a million elements.
std::vector<XmlElement> elements_of_xml(std::string_view text, const std::string& file);

}  // namespace coupling::grids
