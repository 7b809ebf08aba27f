#include "coupling/results/figures/stop_causes.hpp"

namespace coupling {

const char* name_of(StopCause cause) {
    constexpr std::array<const char*, stop_causes> names{"tree",   "log",          "net",
                                                         "ground", "left_terrain", "gave_up"};
    return names[static_cast<std::size_t>(cause)];
}

StopCause cause_of(rockfall::StopReason reason) {
    if (reason == rockfall::StopReason::tree) {
        return StopCause::tree;
    }
    if (reason == rockfall::StopReason::log) {
        return StopCause::log;
    }
    if (reason == rockfall::StopReason::net) {
        return StopCause::net;
    }
    if (rockfall::came_to_rest(reason)) {
        return StopCause::ground;
    }
    return reason == rockfall::StopReason::left_terrain ? StopCause::left_terrain : StopCause::gave_up;
}

std::array<Share, stop_causes> shares_by_cause(const SlopeFigures& slope) {
    std::array<std::uint64_t, stop_causes> parts{};
    for (std::size_t reason = 0; reason < rockfall::stop_reasons; ++reason) {
        parts[static_cast<std::size_t>(cause_of(static_cast<rockfall::StopReason>(reason)))] +=
            slope.by_reason[reason].part;
    }
    std::array<Share, stop_causes> shares;
    for (std::size_t cause = 0; cause < stop_causes; ++cause) {
        shares[cause] = share_of(parts[cause], slope.rocks);
    }
    return shares;
}

}  // namespace coupling
