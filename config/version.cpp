#include "config/version.hpp"

namespace config {

std::string version() {
    return BANNWALD_VERSION;
}

std::string commit() {
    return BANNWALD_COMMIT;
}

}  // namespace config
