#include "coupling/program/actions/describe_barriers.hpp"

#include <cmath>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/tables/words.hpp"
#include "coupling/program/actions/listing.hpp"

namespace coupling {

void describe_barriers(std::size_t nets, std::span<const WorkRecord> works, std::ostream& out) {
    if (nets > 0) {
        say(out, "nets", counted(nets, "net"));
    }
    if (!works.empty()) {
        say(out, "works", counted(works.size(), "work"));
    }
    for (const WorkRecord& work : works) {
        if (is_of_earth(work.kind)) {
            say(out, "",
                config::joined(name_of(work.kind), " ", work.name, ": ",
                               config::to_text(std::round(work.volume_m3)), " m3 of earth ",
                               work.kind == WorkKind::dam ? "heaped" : "dug", ", ",
                               config::to_text(std::round(work.ground_m2)), " m2 of ground"));
        }
    }
}

}  // namespace coupling
