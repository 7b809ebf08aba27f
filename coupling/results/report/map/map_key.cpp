#include "coupling/results/report/map/map_key.hpp"

#include "coupling/results/templates/page_template.hpp"

namespace coupling::report {

std::string map_key(bool with_targets, bool with_nets) {
    return filled_template("map_key.html", {{"shows_targets", with_targets}, {"shows_nets", with_nets}});
}

}  // namespace coupling::report
