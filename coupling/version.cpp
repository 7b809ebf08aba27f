#include "coupling/version.hpp"

namespace coupling {

std::string version() {
    return BANNWALD_VERSION;
}

std::string commit() {
    return BANNWALD_COMMIT;
}

}  // namespace coupling
