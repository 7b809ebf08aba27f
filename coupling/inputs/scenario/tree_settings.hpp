#pragma once

#include <cstdint>
#include <string>

#include "config/errors/input_error.hpp"
#include "config/options/options.hpp"

namespace coupling {

/// How wide around a tree top of a canopy raster no other one is looked for
/// (inputs/forest/tops/canopy_tops.hpp).
enum class CanopyWindow : std::uint8_t { pitkaenen, popescu };

/// The settings of section [trees].
struct TreeSettings {
    std::string file;  ///< CSV; empty: none
    std::string
        canopy;  ///< instead: grid of vegetation heights above the ground, of which tree tops are taken
    CanopyWindow canopy_window = CanopyWindow::pitkaenen;
    double canopy_least_height_m = 5.0;  ///< of a tree top
    std::string species;  ///< of all trees of a list without a column species, or several with shares; empty:
                          ///< it needs one
    std::string species_areas;  ///< table or layer of areas with their species; empty: none
    std::string logs;           ///< CSV of lying logs; empty: none; without either bare slope only
    bool swap_xy = false;       ///< x_m and y_m of the tree list are exchanged
    bool swap_logs_xy = false;  ///< the same of the logs
    bool bounds = true;         ///< derived trees: rocks fall through the bounds of their forest, too

    /// The file of the trees, a list or a canopy raster; empty: none.
    [[nodiscard]] const std::string& source() const { return canopy.empty() ? file : canopy; }
};

void declare(config::Options& options, TreeSettings& settings);

/// Adds settings that do not fit together.
void check(const TreeSettings& settings, const config::Options& options, config::Problems& problems);

}  // namespace coupling
