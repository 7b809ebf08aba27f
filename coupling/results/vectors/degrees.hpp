#pragma once

#include <span>
#include <string>

#include "coupling/inputs/systems/system_way.hpp"
#include "coupling/results/geopackage/package.hpp"

namespace coupling::vectors {

/// Longitude and latitude (WGS 84) of places on the map, as text with eight decimals (about a millimetre).
class Degrees {
public:
    /// `projection`: well-known text of the map's system. Requires a way that PROJ knows: inputs are refused
    /// without one (inputs/terrain/known_degrees.hpp).
    explicit Degrees(const std::string& projection);

    struct Place {
        std::string longitude;
        std::string latitude;
    };
    /// Throws config::InputError (data) for a place that has none.
    [[nodiscard]] Place of(const geopackage::Vertex& corner);
    /// Where the coordinates of layers come from and how accurate they are, in a sentence.
    [[nodiscard]] std::string way_in_words(std::span<const geopackage::Written> layers);

private:
    systems::SystemWay way_;
};

}  // namespace coupling::vectors
