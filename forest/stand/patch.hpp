#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "config/grid/raster.hpp"
#include "config/units/angle.hpp"

namespace forest {

/// Place of a patch in the list of patches of a stand.
enum class PatchId : std::uint32_t {};

constexpr std::size_t index_of(PatchId patch) {
    return static_cast<std::size_t>(patch);
}

/// Side of a patch [m] and its area [m2], on the map.
inline constexpr double patch_side_m = 10.0;
inline constexpr double square_metres_per_hectare = 10'000.0;
inline constexpr double patch_area_m2 = patch_side_m * patch_side_m;

/// What the ground of a patch offers; does not change with the years.
struct Soil {
    double water_capacity_mm =
        120.0;               ///< (0, 600], water that plants can take: between field capacity and wilting
    int texture_class = 3;   ///< 1 sand, 2 sandy loam, 3 clay loam, 4 clay (3-PG soil class)
    double fertility = 0.7;  ///< [0, 1], 3-PG's FR
    double nitrogen_kg_per_ha_year = 60;  ///< [0, 200], available to plants
    double ph = 5.5;                      ///< [2.5, 9], top soil
    friend bool operator==(const Soil&, const Soil&) = default;
};

/// A square of forest ground and what stays with it.
struct Patch {
    config::Cell cell{};     ///< place on the frame
    double ground_m = 0.0;   ///< height of the ground at the centre above sea level
    config::Angle slope{};   ///< [0, 80) degrees
    config::Angle aspect{};  ///< direction the slope faces, clockwise from north
    Soil soil{};
    std::uint16_t surface_code = 0;     ///< ground type of the rockfall side
    std::uint32_t management_unit = 0;  ///< the user's number of the stand that a treatment speaks of
};

/// What the seasons change on a patch.
struct PatchState {
    double soil_water_mm = 0.0;   ///< [0, capacity]
    double snow_water_mm = 0.0;   ///< >= 0
    double ground_light = 1.0;    ///< [0, 1], May to September light at the ground relative to the open
    double june_sun_hours = 0.0;  ///< hours a day of direct sun reaching the ground in June
    double drought_index = 0.0;  ///< [0, 1], share of the year's water demand that was not met; 0 = never dry
    double usual_degree_days = 0.0;  ///< >= 0, above 5.5 degC, mean of the last 30 years or so
    std::uint16_t warmth_years = 0;  ///< that this mean is made of
    std::uint16_t open_years = 0;    ///< years in a row with ground light above 0.3
    std::uint16_t fenced_years = 0;  ///< for which a fence still keeps deer out
    float herb_cover = 0.0F;         ///< [0, 1]
    std::uint16_t beetle_years = 0;  ///< age of the outbreak whose bark beetles winter here, 0 = none do
    float beetle_brood = 0.0F;       ///< [0, 1], how many they are, relative to a patch of spruces
};

/// The patches of a forest on a raster of 10 m cells. Cells without forest have no patch.
///
/// Patches are in row-major order from the north-west, whatever order they were given in.
class PatchGrid {
public:
    /// Requires square cells of patch_side_m and patches on different cells of the frame.
    PatchGrid(const config::GridFrame& frame, std::vector<Patch> patches);

    [[nodiscard]] const config::GridFrame& frame() const { return frame_; }
    [[nodiscard]] const std::vector<Patch>& patches() const { return patches_; }
    [[nodiscard]] std::size_t size() const { return patches_.size(); }
    [[nodiscard]] const Patch& operator[](PatchId id) const { return patches_[index_of(id)]; }

    /// Forest area on the map.
    [[nodiscard]] double area_m2() const { return static_cast<double>(size()) * patch_area_m2; }
    [[nodiscard]] double area_ha() const { return area_m2() / 10'000.0; }

    /// Nothing outside the frame or on a cell without forest.
    [[nodiscard]] std::optional<PatchId> at(config::Cell cell) const;
    [[nodiscard]] std::optional<PatchId> at(double x_m, double y_m) const;

    [[nodiscard]] double x_centre_m(PatchId id) const;
    [[nodiscard]] double y_centre_m(PatchId id) const;

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    config::GridFrame frame_;
    std::vector<Patch> patches_;
    std::vector<std::uint32_t> patch_of_cell_;
};

}  // namespace forest
