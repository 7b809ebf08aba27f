#pragma once

#include <memory>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/assessments/collapse/handed_ground.hpp"
#include "coupling/inputs/collapse_settings.hpp"
#include "coupling/inputs/site.hpp"
#include "rockfall/rock_mass/rock_mass.hpp"

namespace coupling::collapse {

/// What is known of the blocks before they move.
struct BlockCount {
    std::size_t free = 0;   ///< blocks that may move
    std::size_t fixed = 0;  ///< of the rock that stays, around them
    std::size_t bonds = 0;
    std::size_t open_faces = 0;
    double body_m3 = 0.0;      ///< volume of the mass
    double blocks_m3 = 0.0;    ///< of its blocks
    double left_out_m3 = 0.0;  ///< slivers that fit no neighbour
    std::size_t merged = 0;    ///< slivers that went to a neighbour
};

/// Everything that a collapse begins with, read, checked and valid. Coordinates of the terrain.
struct CollapseSite {
    std::vector<InputFile> inputs;
    config::Raster<double> heights;  ///< on the map frame, absolute; NaN: none
    config::GridFrame map_frame;     ///< absolute
    std::string projection;
    Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();
    std::shared_ptr<const GroundPicture> picture;  ///< behind the maps of the page; null: none
    std::vector<rockfall::Target> targets;
    std::vector<TreeRecord> trees;
    std::vector<rockfall::rock_mass::BlockStart> blocks;  ///< the free ones first
    std::vector<rockfall::rock_mass::BondStart> bonds;
    rockfall::rock_mass::Ground ground;  ///< without the mass
    std::vector<rockfall::rock_mass::StandingStem> stems;
    std::shared_ptr<const HandedGround> handed_ground;  ///< of single blocks; null: none is handed over
    BlockCount count;
};

/// Opens, reads and checks every file, and cuts the blocks. Throws InputError.
CollapseSite open_collapse(const CollapseScenario& scenario, config::Warnings& warnings);

}  // namespace coupling::collapse
