#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "forest/light/canopy.hpp"
#include "forest/light/site.hpp"

namespace forest {

/// Radiation and leaves of a year, month by month.
struct LightYear {
    MonthlyRadiation radiation;  ///< on the flat
    /// Months in which deciduous trees have leaves.
    std::array<bool, 12> leaves_on{false, false, false, false, true,  true,
                                   true,  true,  true,  true,  false, false};
    /// Months that light ratios and ground light are means of; leaves are on then.
    std::array<bool, 12> season{false, false, false, false, true,  true,
                                true,  true,  true,  false, false, false};
};

/// Light of a year in all columns and on all trees of an area.
///
/// Energies are of global radiation. A field may be filled again year after year without new memory.
struct LightField {
    /// Of a cell: fluence in each month with the correction for thick cells, then that of the season at the
    /// centre of the cell [MJ/m2 on a plane at right angles to each ray]. Cells well above the highest leaves
    /// of a column are 0.
    static constexpr std::size_t season_value = 12;
    static constexpr std::size_t values_of_cell = 16;
    std::vector<float> cells;

    std::vector<float>
        ground_light;  ///< by column: season's energy on the ground relative to the open slope [0, 1]
    std::vector<float>
        june_sun_hours;               ///< by column: hours a day of direct sun on the ground in June, T > 0.5
    std::vector<float> open_season;   ///< by column: fluence of the season without trees [MJ/m2]
    std::vector<float> ground_mjpm2;  ///< by column and month: energy on the ground per area on the map
    std::vector<float> incoming_mjpm2;  ///< by column and month: the same without trees

    std::vector<float>
        light_ratio;  ///< by tree: light in the crown without its own shade relative to the open [0, 1]
    std::vector<float> absorbed_mj;  ///< by tree and month

    /// By month: (incoming - ground) / absorbed before trees were scaled with it [-]; 1 where nothing is
    /// absorbed.
    std::array<double, 12> closure{};

    [[nodiscard]] const float* cell(std::size_t column, std::size_t layer) const {
        return cells.data() + (column * canopy_layers + layer) * values_of_cell;
    }
};

/// Room for the light of a site and a number of trees.
[[nodiscard]] LightField make_light_field(const LightSite& site, std::size_t trees);

/// Fills the columns [first, last) of a field. Different columns may be filled at the same time.
///
/// Transmittance is exp(-tau) from the centre of each cell to each zone (Beer-Lambert through columns of even
/// leaf area). The fluence of a cell is that of its centre times sinh(x) / x, the mean of exp(-tau) over a
/// cell of depth 2 x: along the path through its own leaves, or from its upper to its lower side, whichever
/// is more. Where less than a twentieth of the leaves fall, months without leaves are taken for months with
/// them.
void compute_columns(const LightSite& site, const Canopy& canopy, const LightYear& year, std::size_t first,
                     std::size_t last, LightField& field);

/// Fills the trees [first, last) of a field whose columns are filled. Different trees may be filled at the
/// same time.
///
/// Light ratio: min(1, mean fluence over the leaves / open fluence / s), s = (1 - exp(-t))/t the mean light
/// in the tree's own shade, t = extinction * leaf area / 100 m2.
void compute_trees(const Canopy& canopy, const LightYear& year, std::span<const LightTree> trees,
                   std::size_t first, std::size_t last, LightField& field);

/// Scales what the trees absorb in each month so that absorbed + ground = incoming over the area.
///
/// Only where the area has no open edges: light enters and shade leaves through those. There closure is
/// noted, not used.
void close_budget(const LightSite& site, LightField& field);

/// Means of values of columns over patches of `side` x `side` columns, in the order of a frame of the
/// patches: for columns finer than the patches of a forest. Requires that the patches fill the frame.
[[nodiscard]] std::vector<float> mean_over_patches(const config::GridFrame& columns,
                                                   std::span<const float> values, int side);

/// All of it, one after the other.
[[nodiscard]] LightField compute_light(const LightSite& site, const Canopy& canopy, const LightYear& year,
                                       std::span<const LightTree> trees);

}  // namespace forest
