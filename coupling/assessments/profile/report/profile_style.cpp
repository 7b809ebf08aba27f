#include "config/text/embedded.hpp"
#include "coupling/assessments/profile/report/profile_page.hpp"

BANNWALD_EMBED(profile_css, BANNWALD_EMBEDDED_FILE)

namespace coupling::profile {

std::string_view style_of_profile() {
    return BANNWALD_EMBEDDED(profile_css);
}

}  // namespace coupling::profile
