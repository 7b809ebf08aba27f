#include "coupling/results/figures/few_rocks.hpp"

#include "config/text/joined.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling {

using config::joined;

std::string too_few_in_words(std::uint64_t bare_arrivals) {
    const std::string rocks = bare_arrivals == 0 ? report::page_text("few_rocks.no_rock_arrives")
                              : bare_arrivals == 1
                                  ? report::page_text("few_rocks.only_1_rock_arrives")
                                  : report::page_text("few_rocks.only_rocks_arrive",
                                                      {{"bare_arrivals", std::to_string(bare_arrivals)}});
    return report::page_text("few_rocks.over_the_bare_slope_too_few_for", {{"rocks", rocks}});
}

}  // namespace coupling
