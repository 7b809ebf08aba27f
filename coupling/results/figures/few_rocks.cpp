#include "coupling/results/figures/few_rocks.hpp"

#include "config/text/joined.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling {

using config::joined;

std::string too_few_in_words(std::uint64_t bare_arrivals) {
    const std::string rocks = bare_arrivals == 0 ? report::page_text("no rock arrives")
                              : bare_arrivals == 1
                                  ? report::page_text("only 1 rock arrives")
                                  : report::page_text("only {bare_arrivals} rocks arrive",
                                                      {{"bare_arrivals", std::to_string(bare_arrivals)}});
    return report::page_text("{rocks} over the bare slope: too few for a protection figure",
                             {{"rocks", rocks}});
}

}  // namespace coupling
