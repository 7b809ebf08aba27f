#pragma once

#include <string>
#include <string_view>

namespace config {

/// A text in lower case without accents, as names are compared: umlauts are written out ("Höhe" is "hoehe"),
/// accents are dropped ("Diamètre" is "diametre"). Other letters and signs stay.
std::string plain_letters(std::string_view text);

}  // namespace config
