#include "coupling/results/report/map/map_key.hpp"

#include "coupling/results/templates/page_template.hpp"

namespace coupling::report {

std::string map_key(const OnMaps& drawn) {
    return filled_template("map_key.html", {{"shows_sources", drawn.sources},
                                            {"shows_targets", drawn.targets},
                                            {"shows_nets", drawn.nets},
                                            {"shows_works", drawn.works}});
}

}  // namespace coupling::report
