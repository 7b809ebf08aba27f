#pragma once

#include <span>
#include <string>
#include <vector>

#include "coupling/inputs/nets/net_record.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/terrain/terrain_input.hpp"
#include "rockfall/release/release.hpp"
#include "rockfall/tally/target.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling::plausible {

/// What lies on one terrain, in its coordinates: where rocks start, and what they are to meet or to be
/// stopped by.
struct OnSlope {
    const rockfall::Terrain& terrain;
    double spacing_m = 1.0;  ///< of the heights: slopes are measured over this distance
    std::span<const rockfall::ReleaseSource> sources;
    std::span<const rockfall::Target> targets;
    std::span<const NetRecord> nets;
};

/// How the places of the sources look.
struct SourceSlopes {
    /// Slope of the ground at the sources, each by the steepest place within 10 m or a cell (sources are
    /// often drawn along the upper edge of a cliff); median over the rocks [degrees];
    /// NaN where it is known at none.
    double median_deg = 0.0;
    /// Mean of the same slope over the rocks, and the largest mean that all sources have together when they
    /// are moved by one and the same vector of 40 to 200 m.
    double mean_deg = 0.0;
    double best_mean_deg = 0.0;
    /// Share of the ground on which sources lie, and how often the ground at a source is steeper than that of
    /// a place without one [-].
    double covered = 0.0;
    double steeper_than_rest = 1.0;
    std::size_t places = 0;                                 ///< squares of 50 m with a source
    Eigen::Vector2d best_move_m = Eigen::Vector2d::Zero();  ///< with which they have it
    /// The largest mean that they have on the same ground mirrored about its middle or turned by 180 degrees:
    /// what rows or columns in the wrong order make of it.
    double best_mirrored_deg = 0.0;
    bool mirrored_west_east = false;  ///< with which they have it; both: turned
    bool mirrored_north_south = false;
};

SourceSlopes source_slopes(const OnSlope& site);

/// Which targets or nets lie wholly above all sources: rocks only fall.
struct BelowWhat {
    double rocks_below_all = 0.0;      ///< share of the rocks that start below every target on the terrain
    double rocks_inside = 0.0;         ///< share that start inside a target that is an area
    std::vector<std::size_t> targets;  ///< above all sources
    std::vector<std::size_t> nets;
};

BelowWhat sources_below(const OnSlope& site);

/// Of a grid the size of its cells, of points their mean distance, rounded up.
double spacing_of(const HeightInput& heights);

/// Holds the sources against the slope and against what is to be protected.
///
/// - An error where all sources lie below all targets.
/// - Warnings: single targets and nets that lie above all sources; most rocks below every target, or inside
///   one; sources on most of the terrain, or on its gentler parts, as a mask that is the wrong way round
///   leaves them; sources on ground of less than 25 degrees; sources off the steep ground beside them, as a
///   shift between two coordinate systems leaves them, or as mirrored heights do.
///
/// `file` names the sources in messages.
void judge_source_places(const OnSlope& site, const std::string& file, Reading& reading);

}  // namespace coupling::plausible
