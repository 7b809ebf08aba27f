#pragma once

#include <string>

#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {

/// "1 year", "0.5 years", in the language in use.
inline std::string years_in_words(double years) {
    return page_text(years == 1.0 ? "{years} year" : "{years} years", {{"years", exact(years)}});
}

}  // namespace coupling::report
