#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/inputs/site.hpp"
#include "coupling/results/figures/figures.hpp"

namespace coupling::report {

struct SceneMass;

// What the view in three dimensions shows, as numbers for its script
// (coupling/page_scripts/sources/slope.js).

enum class TreeState : std::uint8_t { living, dead, broken };

/// A tree to be drawn. A crown without radius is estimated by the script from height and species.
struct SceneTree {
    double x_m = 0.0;  ///< absolute
    double y_m = 0.0;
    double dbh_cm = 0.0;
    double height_m = 0.0;  ///< of what stands
    double crown_base_m = 0.0;
    double crown_radius_m = 0.0;  ///< 0: not known
    std::uint8_t species = 0;     ///< place in the scene's list
    TreeState state = TreeState::living;
    friend bool operator==(const SceneTree&, const SceneTree&) = default;
};

/// A lying stem.
struct SceneLog {
    double x_m = 0.0;  ///< absolute, of one end
    double y_m = 0.0;
    double length_m = 0.0;
    double direction_rad = 0.0;  ///< counter-clockwise from east
    friend bool operator==(const SceneLog&, const SceneLog&) = default;
};

/// A path of a rock among the trees of a stand.
using ScenePath = std::vector<rockfall::PathPoint>;

/// What stands in one year under one regime, and where rocks fell then.
struct SceneStand {
    std::string regime;  ///< empty where there is one
    std::int32_t year = 0;
    std::vector<SceneTree> trees;
    std::vector<SceneLog> logs{};
    std::vector<ScenePath> paths{};  ///< in coordinates of the terrain
    /// Place of an earlier stand with the same trees, which are then not repeated here.
    std::optional<std::size_t> same_as{};
};

struct SceneSpecies {
    std::string name;
    std::string colour;  ///< "#rrggbb"
    bool conifer = false;
};

struct Scene {
    const config::Raster<double>& heights;  ///< absolute; NaN: none
    std::vector<SceneSpecies> species{};
    std::vector<SceneStand> stands{};
    std::vector<const rockfall::PathRecord*> paths{};  ///< in coordinates of the terrain
    std::span<const rockfall::Target> targets{};
    Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();  ///< of the terrain
    const SceneMass* mass = nullptr;                     ///< of a run of a rock mass
    const GroundPicture* picture = nullptr;              ///< of the maps of the page; none: nullptr
};

/// A figure that the script fills; without scripts or WebGL it says what is missing and where else to look
/// (`instead`, HTML). The ground keeps at most 256 heights a side, a stand at most as many of the thickest
/// trees and longest logs and, evenly chosen, of the paths as let all stands together have 400 000 trees,
/// 60 000 logs and 100 000 corners of paths.
std::string scene_figure(const Scene& scene, const std::string& instead);

}  // namespace coupling::report
