#include "coupling/version.hpp"

namespace coupling {

std::string version() {
    return BANNWALD_VERSION;
}

}  // namespace coupling
