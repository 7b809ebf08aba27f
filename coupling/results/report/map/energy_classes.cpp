#include "coupling/results/report/map/energy_classes.hpp"

#include <array>

#include "coupling/results/figures/colours.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {

const std::string& energy_class_name(std::size_t energy_class) {
    constexpr std::array<const char*, energy_class_colours.size()> keys{
        "energy_classes.below_30",    "energy_classes.30_to_100",    "energy_classes.100_to_300",
        "energy_classes.300_to_1000", "energy_classes.1000_to_3000", "energy_classes.above_3000"};
    return page_text(keys[energy_class]);
}

}  // namespace coupling::report
