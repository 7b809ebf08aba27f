#pragma once

#include <string>

namespace coupling::formats {

/// Well-known text (as ESRI writes it in .prj files) of a coordinate system that is given by a code such as
/// "EPSG:31254" or by a definition of PROJ; empty where the library and its tables do not know it.
///
/// Text of a file must not come here: it is for codes and for definitions that libgeotiff made.
std::string esri_text_of(const std::string& definition);

/// Well-known text to the bracket that closes its first one: ESRI writes the system of heights behind it.
std::string first_element(const std::string& text);

}  // namespace coupling::formats
