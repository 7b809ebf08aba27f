#include "coupling/results/figures/few_rocks.hpp"

#include "coupling/results/text/page_text.hpp"

namespace coupling {

std::string too_few_in_words(std::uint64_t bare_arrivals) {
    return bare_arrivals == 0
               ? report::page_text("no rock arrives over the bare slope: too few for a protection figure")
               : report::page_text(
                     bare_arrivals == 1
                         ? "only {rocks} rock arrives over the bare slope: too few for a protection figure"
                         : "only {rocks} rocks arrive over the bare slope: too few for a protection figure",
                     {{"rocks", std::to_string(bare_arrivals)}});
}

}  // namespace coupling
