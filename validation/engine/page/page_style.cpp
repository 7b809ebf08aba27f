#include "config/text/embedded.hpp"
#include "validation/engine/page/page_parts.hpp"

BANNWALD_EMBED(validation_css, BANNWALD_EMBEDDED_FILE)

namespace coupling::validation {

std::string_view page_style() {
    return BANNWALD_EMBEDDED(validation_css);
}

}  // namespace coupling::validation
