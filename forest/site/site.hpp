#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "config/units/angle.hpp"
#include "forest/light/site.hpp"
#include "forest/production/water_balance.hpp"
#include "forest/stand/patch.hpp"
#include "forest/stand/self_thinning.hpp"

namespace forest {

/// Patches that share climate and soil: the same 50 m of elevation, eighth of the compass and soil [choice].
struct SiteUnit {
    double elevation_m = 0.0;  ///< mean of its patches
    Soil soil;
    std::vector<PatchId> patches;
};

/// Patches of one site unit in one management unit, whose trees share what the unit produces.
struct ProductionUnit {
    std::uint32_t site_unit = 0;
    std::uint32_t management_unit = 0;
};

/// Sky, ground and horizons of a forest, for the light model.
struct LightFrame {
    Sky sky;
    LightGround ground;             ///< of all cells of the frame
    std::vector<Horizon> horizons;  ///< one for all cells or one each
    LightSettings settings{};
};

/// Everything about the place of a forest that the years do not change. Made once, shared by all runs on it.
class Site {
public:
    /// Requires a light ground on the frame of the grid.
    Site(const PatchGrid& grid, config::Angle latitude, const LightFrame& light);

    [[nodiscard]] config::Angle latitude() const { return latitude_; }
    [[nodiscard]] const LightSite& light() const { return light_; }
    [[nodiscard]] const ThinningWindows& windows() const { return windows_; }
    [[nodiscard]] const std::vector<SiteUnit>& units() const { return units_; }
    [[nodiscard]] const std::vector<ProductionUnit>& production_units() const { return production_units_; }
    [[nodiscard]] std::uint32_t unit_of(PatchId patch) const { return unit_of_patch_[index_of(patch)]; }
    [[nodiscard]] std::uint32_t production_unit_of(PatchId patch) const {
        return production_unit_of_patch_[index_of(patch)];
    }
    /// Column of a patch in the light model.
    [[nodiscard]] std::size_t column_of(PatchId patch) const { return column_of_patch_[index_of(patch)]; }
    [[nodiscard]] const WaterStore& water_store(PatchId patch) const { return stores_[index_of(patch)]; }

private:
    config::Angle latitude_;
    LightSite light_;
    ThinningWindows windows_;
    std::vector<SiteUnit> units_;
    std::vector<ProductionUnit> production_units_;
    std::vector<std::uint32_t> unit_of_patch_;
    std::vector<std::uint32_t> production_unit_of_patch_;
    std::vector<std::size_t> column_of_patch_;
    std::vector<WaterStore> stores_;
};

}  // namespace forest
