#include "coupling/results/figures/fall_doubts.hpp"

#include <string>
#include <utility>

#include "rockfall/motion/fall.hpp"

namespace coupling {

rockfall::FallFigures fall_figures_of(const SlopeFigures& slope) {
    constexpr auto left = static_cast<std::size_t>(rockfall::StopReason::left_terrain);
    return {slope.max_speed_mps.max, slope.by_reason[left].value};
}

void warn_of_falls(const rockfall::MotionLaws& laws, const rockfall::FallFigures& falls,
                   config::Warnings& warnings) {
    for (std::string& sentence : rockfall::doubts_of_falls(laws, falls)) {
        warnings.add(std::move(sentence), config::Effect::answer);
    }
}

}  // namespace coupling
