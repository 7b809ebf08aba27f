#include "coupling/inputs/plausible/odd_grounds.hpp"

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::plausible {

using config::joined;

void judge_restitutions(std::span<const rockfall::SurfaceType> types, const std::string& file,
                        Reading& reading) {
    std::size_t odd = 0;
    std::string first;
    for (const rockfall::SurfaceType& type : types) {
        if (type.restitution.normal > type.restitution.tangential && odd++ == 0) {
            first =
                joined("code ", std::to_string(type.code), " (r_n ", config::to_text(type.restitution.normal),
                       ", r_t ", config::to_text(type.restitution.tangential), ")");
        }
    }
    if (odd == 0) {
        return;
    }
    const std::string expected =
        "r_n below r_t: rocks keep less of their speed across the ground than along it";
    const std::string found =
        joined("r_n above r_t in ", std::to_string(odd), " of ", counted(types.size(), "ground type"));
    if (odd == types.size()) {
        reading.refuse({file}, joined(found, ": the columns look swapped"), expected,
                       "exchange the names of the columns r_n and r_t");
    } else {
        reading.warn({file}, joined(found, ", such as ", first), expected,
                     "check whether the two are swapped there", config::Effect::answer);
    }
}

}  // namespace coupling::plausible
