#include "coupling/results/report/map/energy_classes.hpp"

#include <array>

#include "coupling/results/figures/colours.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {

const std::string& energy_class_name(std::size_t energy_class) {
    constexpr std::array<const char*, energy_class_colours.size()> keys{
        "below 30 kJ", "30 to 100 kJ", "100 to 300 kJ", "300 to 1000 kJ", "1000 to 3000 kJ", "above 3000 kJ"};
    return page_text(keys[energy_class]);
}

}  // namespace coupling::report
