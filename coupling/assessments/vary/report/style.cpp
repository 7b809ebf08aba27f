#include "coupling/assessments/vary/report/style.hpp"

#include "config/text/embedded.hpp"

BANNWALD_EMBED(vary_css, BANNWALD_EMBEDDED_FILE)

namespace coupling::vary::report {

std::string_view page_style() {
    return BANNWALD_EMBEDDED(vary_css);
}

}  // namespace coupling::vary::report
