#include "config/text/embedded.hpp"
#include "coupling/assessments/compare/page/parts.hpp"

BANNWALD_EMBED(compare_css, BANNWALD_EMBEDDED_FILE)

namespace coupling::compare {

std::string_view run_style() {
    return BANNWALD_EMBEDDED(compare_css);
}

}  // namespace coupling::compare
