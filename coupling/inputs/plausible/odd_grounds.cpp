#include "coupling/inputs/plausible/odd_grounds.hpp"

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::plausible {

using config::joined;

void judge_restitutions(std::span<const rockfall::SurfaceType> types, const std::string& file,
                        Reading& reading) {
    const auto excess = [](const rockfall::SurfaceType& type) {
        return type.restitution.normal - type.restitution.tangential;
    };
    std::size_t odd = 0;
    const rockfall::SurfaceType* worst = nullptr;  // the same one in any order of the rows
    for (const rockfall::SurfaceType& type : types) {
        if (excess(type) > 0.0) {
            ++odd;
            if (worst == nullptr || excess(type) > excess(*worst) ||
                (excess(type) == excess(*worst) && type.code < worst->code)) {
                worst = &type;
            }
        }
    }
    if (odd == 0) {
        return;
    }
    const std::string expected =
        "r_n below r_t: rocks keep less of their speed normal to the ground than along it";
    const std::string found =
        joined("r_n above r_t in ", std::to_string(odd), " of ", counted(types.size(), "ground type"));
    if (odd == types.size()) {
        reading.refuse({file}, joined(found, ": the columns look swapped"), expected,
                       "exchange the names of the columns r_n and r_t");
    } else {
        reading.warn({file},
                     joined(found, ", such as code ", std::to_string(worst->code), " (r_n ",
                            config::to_text(worst->restitution.normal), ", r_t ",
                            config::to_text(worst->restitution.tangential), ")"),
                     expected, "check whether the two are swapped there", config::Effect::answer);
    }
}

}  // namespace coupling::plausible
