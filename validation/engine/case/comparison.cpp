#include "validation/engine/case/comparison.hpp"

namespace coupling::validation {

Figure Comparison::figure(const std::string& name) const {
    for (const Figure& candidate : figures) {
        if (candidate.name == name) {
            return candidate;
        }
    }
    return {};
}

}  // namespace coupling::validation
