#include "coupling/results/report/style.hpp"

#include "config/text/embedded.hpp"

BANNWALD_EMBED(page_css, BANNWALD_EMBEDDED_FILE)

namespace coupling::report {

std::string_view style() {
    return BANNWALD_EMBEDDED(page_css);
}

}  // namespace coupling::report
