#include "coupling/results/figures/few_rocks.hpp"

#include "config/units/constants.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling {

bool too_few_for_protection(const PairedCounts& counts) {
    const auto effect = protection_effect(counts);
    return too_few_for_protection(counts.bare()) ||
           (effect &&
            says_nothing(config::percent * effect->interval.low, config::percent * effect->interval.high));
}

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
