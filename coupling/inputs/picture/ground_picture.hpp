#pragma once

#include <memory>

#include "coupling/inputs/picture/picture_file.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling {

/// What lies behind the maps of pages: the part of an aerial picture or map that shows the terrain.
struct GroundPicture {
    picture::Pixels pixels;
    config::GridFrame frame;  ///< of its pixels, absolute; it may reach a pixel over the map
};

namespace picture {

/// At most so many pixels a side are kept [choice]: a screen shows no more of a map.
inline constexpr std::uint32_t most_pixels_a_side = 1600;

/// The part of a picture that lies on a map, reduced to at most `most_a_side` pixels a side. A pixel is the
/// mean of those that it stands for. Requires that the two overlap.
GroundPicture cut_out(const PlacedPicture& placed, const config::GridFrame& map,
                      std::uint32_t most_a_side = most_pixels_a_side);

/// The share of a map that a picture covers [0, 1].
double covered_share(const config::GridFrame& picture, const config::GridFrame& map);

}  // namespace picture

/// Reads terrain.picture; nullptr without it. One that lies beside the map is refused, one that covers a part
/// of it is noted, and its system joins those that have to be one (Reading::check_systems).
std::shared_ptr<const GroundPicture> read_ground_picture(const config::GridFrame& map, Reading& reading);

}  // namespace coupling
