#include "coupling/results/few_rocks.hpp"

#include "config/text/joined.hpp"

namespace coupling {

using config::joined;

std::string too_few_in_words(std::uint64_t bare_arrivals) {
    const std::string rocks = bare_arrivals == 0 ? "no rock arrives"
                              : bare_arrivals == 1
                                  ? "only 1 rock arrives"
                                  : joined("only ", std::to_string(bare_arrivals), " rocks arrive");
    return joined(rocks, " over the bare slope: too few for a protection figure");
}

}  // namespace coupling
