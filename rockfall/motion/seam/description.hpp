#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "rockfall/slope/slope.hpp"

namespace rockfall {

/// Of a ground type that has no such figure.
inline constexpr double no_figure = std::numeric_limits<double>::quiet_NaN();

/// A figure of the ground types that a motion model uses: a column of the table of ground types.
template <class Law>
struct GroundColumn {
    std::string_view name;  ///< of the column; coupling/assessments/today/figures/ground_columns.cpp has its
                            ///< unit and meaning
    std::string_view from;  ///< where the figure comes from, for the data dictionary
    std::string_view remark = {};  ///< what it is under this model, where that differs: "of the soil"
    /// The figure for a rock of this diameter [m], in the unit of the column; of a limiting angle its
    /// tangent. None for the one column of text, the soil's name.
    double (*value)(const SurfaceType& type, const Law& law, double diameter_m) = nullptr;
};

/// The same for readers who do not know the model's law.
struct GroundColumnText {
    std::string_view name;
    std::string_view from;
    std::string_view remark;
};

/// How a model turns rocks sideways at impacts, in words, and the settings that decide it.
struct SidewaysTurn {
    std::string words;                  ///< "at impacts ±16° (slow) to ±11° (fast rocks)"
    std::vector<std::string> settings;  ///< section.name
};

/// What the program has to know about a motion model beside its laws: all that `check`, pages, tables and
/// comparisons say about a model comes from here, so that none of them names one.
struct ModelDescription {
    std::string_view name;          ///< value of rockfall.motion, and the section of its settings
    std::string_view title;         ///< on pages
    std::string_view rocks;         ///< what its rocks do: "rocks jump, roll and spin"
    std::string_view law;           ///< its law in a few words, for `--help-all`
    std::string_view source;        ///< who published it
    std::string_view energy;        ///< what kinetic energy counts: "translation alone"
    bool spins = false;             ///< rocks have a spin, and energies count it
    bool has_shape = false;         ///< rocks have a shape of their own, and feel the terrain as it is
    bool needs_soils = false;       ///< each ground type must have a soil
    double path_bytes_per_m = 0.0;  ///< a stored path grows by this for each metre of drop (measured)
    /// A metre of path of a rock takes so long on one core (measured). 0: it depends on shapes and ground, so
    /// `check` simulates a few rocks and measures their time.
    double us_per_path_m = 0.0;
    /// Settings outside its section that only some models use, this one among them.
    std::vector<std::string> shared_settings{};
    /// Settings that do nothing but turn rocks sideways: without effect where they stay in a plane.
    std::vector<std::string> sideways_settings{};
    /// Which results of the model are not confirmed, and what to do: the first warning of each run with it.
    std::string_view caution{};
};

}  // namespace rockfall
