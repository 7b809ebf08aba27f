#include "forest/deadwood/decay_class.hpp"

namespace forest {

int decay_class_of(double density_share) {
    std::size_t at = 0;
    while (at + 1 < decay_class_count &&
           density_share < 0.5 * (density_of_decay_class[at] + density_of_decay_class[at + 1])) {
        ++at;
    }
    return static_cast<int>(at) + 1;
}

}  // namespace forest
