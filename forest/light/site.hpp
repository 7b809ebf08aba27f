#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "forest/light/ground.hpp"
#include "forest/light/ray_walk.hpp"
#include "forest/light/sky.hpp"

namespace forest {

/// How finely light is followed.
struct LightSettings {
    double reach_m = 300.0;  ///< (0, 1000] how far trees cast a shadow [choice]
    int ground_points = 1;   ///< 1 or 2: points on the ground of a column along each side
};

/// What a place without trees gets from each zone of the sky: energy on a plane at right angles to the zone's
/// direction per energy on the flat. Light of a zone that the terrain hides in part comes from the zone's
/// direction all the same.
struct SkyView {
    std::vector<float> diffuse;  ///< by zone, per energy of the whole sky [-]
    std::vector<float> beam;     ///< as Sky::beams, per energy of the month's beam [-]
    std::vector<float>
        on_ground;  ///< by zone, energy per ground area on the map per energy at right angles [-]
    std::uint64_t june_suns = 0;  ///< bit i: Sky::june_suns()[i] shines on the open ground
};

[[nodiscard]] SkyView view_from(const Sky& sky, const Exposure& place);

/// Everything about the light of an area that the years do not change: sky, ground, horizons, and which
/// columns each ray crosses.
class LightSite {
public:
    /// `places` has one entry for all columns, or one for each in the order of the frame.
    LightSite(Sky sky, const LightGround& ground, std::span<const Exposure> places,
              const LightSettings& settings = {});

    [[nodiscard]] const Sky& sky() const { return sky_; }
    [[nodiscard]] const PaddedGround& ground() const { return ground_; }
    [[nodiscard]] Edges edges() const { return edges_; }
    [[nodiscard]] const SkyView& view(std::size_t column) const {
        return views_[views_.size() == 1 ? 0 : column];
    }

    /// Whether a place receives light from a zone.
    [[nodiscard]] bool is_visible(const SkyView& view, std::size_t zone) const {
        return view.diffuse[zone] > 0.0F;
    }

    /// The walk from the centre of a column towards a zone.
    [[nodiscard]] const RayWalk& walk(std::size_t zone) const { return walks_[zone]; }
    /// Walks from the points on the ground besides the centre, empty where the centre is the only one.
    [[nodiscard]] std::span<const RayWalk> ground_walks(std::size_t zone) const {
        return {ground_walks_.data() + zone * points_, points_};
    }
    [[nodiscard]] const RayWalk& june_walk(std::size_t sun) const { return june_walks_[sun]; }

    /// Beams of a zone: from first_beam(zone) to before first_beam(zone + 1).
    [[nodiscard]] std::size_t first_beam(std::size_t zone) const { return first_beam_[zone]; }

private:
    Sky sky_;
    Edges edges_;
    PaddedGround ground_;
    std::vector<SkyView> views_;
    std::size_t points_;
    std::vector<RayWalk> walks_;
    std::vector<RayWalk> ground_walks_;
    std::vector<RayWalk> june_walks_;
    std::vector<std::size_t> first_beam_;
};

/// The exposure of every column of a ground: its slope and the horizon given for it; one horizon may serve
/// all.
[[nodiscard]] std::vector<Exposure> exposures_of(const LightGround& ground,
                                                 std::span<const Horizon> horizons);

}  // namespace forest
