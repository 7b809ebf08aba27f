#include "coupling/results/geopackage/spatial_reference.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

#include "config/text/numbers.hpp"

namespace coupling::geopackage {
namespace {

/// The text in double quotes that follows a place; "" without any.
std::string next_quoted(const std::string& text, std::size_t from) {
    const std::size_t open = text.find('"', from);
    const std::size_t close = open == std::string::npos ? open : text.find('"', open + 1);
    return close == std::string::npos ? std::string{} : text.substr(open + 1, close - open - 1);
}

/// Where the outermost AUTHORITY begins: those of the datum and the units stand in deeper brackets.
std::size_t outer_authority(const std::string& text) {
    int depth = 0;
    bool in_quotes = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') {
            in_quotes = !in_quotes;
        } else if (in_quotes) {
            continue;
        } else if (c == '[' || c == '(') {
            ++depth;
        } else if (c == ']' || c == ')') {
            --depth;
        } else if (depth == 1 && (text.compare(i, 9, "AUTHORITY") == 0)) {
            return i;
        }
    }
    return std::string::npos;
}

}  // namespace

SpatialReference spatial_reference(const std::string& projection) {
    const auto is_blank = [](unsigned char c) { return std::isspace(c) != 0; };
    if (std::all_of(projection.begin(), projection.end(), is_blank)) {
        return {};
    }
    SpatialReference reference{own_reference, next_quoted(projection, 0), "NONE", own_reference, projection};
    const std::size_t authority = outer_authority(projection);
    if (authority == std::string::npos || next_quoted(projection, authority) != "EPSG") {
        return reference;
    }
    const std::size_t number = projection.find(',', authority);
    const auto code =
        number == std::string::npos ? std::nullopt : config::parse_whole(next_quoted(projection, number));
    if (code && *code > 0 && *code < own_reference) {
        reference.id = static_cast<std::int32_t>(*code);
        reference.organization = "EPSG";
        reference.organization_id = reference.id;
    }
    return reference;
}

}  // namespace coupling::geopackage
