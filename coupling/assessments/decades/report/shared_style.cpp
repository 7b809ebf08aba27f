#include "config/text/embedded.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"

BANNWALD_EMBED(years_css, BANNWALD_EMBEDDED_FILE)

namespace coupling::decades {

std::string_view shared_style() {
    return BANNWALD_EMBEDDED(years_css);
}

}  // namespace coupling::decades
