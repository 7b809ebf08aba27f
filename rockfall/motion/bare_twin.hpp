#pragma once

#include <optional>

#include "rockfall/motion/fall.hpp"

namespace rockfall {

/// The same rock over the bare slope, which falls as the one in the forest does until that meets its first
/// stem or log. There the event loop lets the twin fall on to its end by itself, without stems and logs, past
/// the same nets. An observer that follows a twin takes over with `go_on_from` what another has seen.
template <class Observer>
struct BareTwin {
    FallScratch& kept;                ///< memory of the forest's fall while the twin falls on
    Observer& observer;               ///< of the twin, from where they part
    std::optional<FallEnd> end = {};  ///< of the twin; none: they never part, so both falls are one
};

/// Whether falls that report to it can have a twin.
template <class Observer>
concept FollowsTwin = requires(Observer& twin, const Observer& seen) {
    twin.go_on_from(seen);
};

}  // namespace rockfall
