#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coupling {

/// What rocks do past the thinnest and the thickest forest that derived trees may be.
struct ForestBounds {
    /// A figure as it is with the derived trees, and with both bounds.
    struct Figure {
        std::optional<std::size_t> target{};  ///< nothing: of all rocks of the slope
        double derived = 0.0;  ///< share of the rocks that the forest stops, or mean run-out in m
        double thin = 0.0;
        double thick = 0.0;
    };

    bool are_of_records = false;  ///< drawn from stands; else tree tops of which heights are known
    std::uint64_t rocks = 0;      ///< that fell once more
    std::vector<Figure> figures;  ///< of targets where enough rocks arrive, then of all rocks
};

}  // namespace coupling
