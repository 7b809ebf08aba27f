#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/assessments/nets/figures/net_paths.hpp"
#include "coupling/assessments/nets/figures/net_uphill.hpp"
#include "coupling/assessments/nets/siting/net_design.hpp"
#include "coupling/assessments/nets/siting/protected_line.hpp"
#include "coupling/assessments/nets/siting/stretches.hpp"
#include "rockfall/draws/strata.hpp"

namespace coupling::siting {

/// What comes to one line, slope by slope, in the order of rocks.
struct Arrivals {
    std::array<std::vector<LineArrival>, rockfall::covers> by_cover;
    /// In the same order: unit vectors in plan in which the rocks move there.
    std::array<std::vector<Eigen::Vector2d>, rockfall::covers> directions;
};

/// A stretch of a line, and which way is upslope of it.
struct SitedStretch {
    std::uint32_t line = 0;
    Stretch stretch;
    std::optional<Uphill> uphill;  ///< nothing: no way is upslope
};

/// A line upslope of a stretch on which a net may stand.
struct Candidate {
    std::uint32_t stretch = 0;
    double distance_m = 0.0;              ///< in plan, upslope of the stretch
    std::vector<Eigen::Vector2d> line_m;  ///< longer than the stretch: rocks come at an angle
    double starts_m = 0.0;                ///< along the line to protect, of its first corner
};

/// The line of a candidate: the stretch and what lies beside it up to the distance on both sides, moved
/// upslope. Shorter where it would leave the terrain or run through a house; nothing where the stretch itself
/// would.
std::optional<Candidate> candidate_at(const ProtectedLine& line, const SitedStretch& stretch,
                                      double distance_m, const rockfall::Terrain& terrain,
                                      std::span<const rockfall::Target> houses);

/// What passes a candidate on one slope.
struct Passing {
    std::vector<CrossingRock> of_stretch;  ///< rocks that come to the stretch, in the order of rocks
    std::vector<PassingRock> all;          ///< every crossing of the line, in the order of rocks
};

/// Follows paths past lines to protect.
class LineWatch {
public:
    LineWatch(std::span<const ProtectedLine> lines, const rockfall::Terrain& terrain);
    void look(const StoredPath& path);
    [[nodiscard]] const Arrivals& of(std::size_t line) const { return arrivals_[line]; }

private:
    const rockfall::Terrain& terrain_;
    rockfall::NetIndex index_;
    std::vector<Arrivals> arrivals_;
};

/// Follows paths past candidates on their way to the lines.
class CandidateWatch {
public:
    CandidateWatch(std::span<const ProtectedLine> lines, std::span<const SitedStretch> stretches,
                   std::span<const Candidate> candidates, const rockfall::Terrain& terrain,
                   const config::GridFrame& frame, const rockfall::Strata& strata = {});
    void look(const StoredPath& path);
    [[nodiscard]] const Passing& of(std::size_t candidate, rockfall::Cover cover) const {
        return passing_[candidate][static_cast<std::size_t>(cover)];
    }
    /// Rocks that come to any of the lines, counted once in each cell that they pass on their way to it;
    /// NaN: none.
    [[nodiscard]] const config::Raster<float>& ways(rockfall::Cover cover) const {
        return ways_[static_cast<std::size_t>(cover)];
    }

private:
    /// Marks the cells under a path up to a piece and a time in it.
    void mark_way(const StoredPath& path, std::pair<std::size_t, double> until);

    std::span<const SitedStretch> stretches_;
    std::span<const Candidate> candidates_;
    const rockfall::Terrain& terrain_;
    rockfall::Strata strata_;
    rockfall::NetIndex lines_;
    rockfall::NetIndex index_;
    std::vector<std::array<Passing, rockfall::covers>> passing_;
    std::array<config::Raster<float>, rockfall::covers> ways_;
    config::Raster<std::uint32_t> last_path_;
    std::uint32_t paths_ = 0;
};

/// What still comes to the lines past nets that stand together, in the order of rocks.
class LeftWatch {
public:
    LeftWatch(std::span<const ProtectedLine> lines, std::span<const NetRecord> nets,
              const rockfall::Terrain& terrain);
    void look(const StoredPath& path);
    [[nodiscard]] const std::vector<LineArrival>& of(std::size_t line, rockfall::Cover cover) const {
        return left_[line][static_cast<std::size_t>(cover)];
    }

private:
    const rockfall::Terrain& terrain_;
    rockfall::NetIndex lines_;
    rockfall::NetIndex nets_;
    std::vector<std::array<std::vector<LineArrival>, rockfall::covers>> left_;
};

/// From where the rocks of a stretch come: against the mean of their directions with forest, or over the bare
/// slope where none comes through it; up the gradient where they come from all sides or none comes.
std::optional<Uphill> uphill_of(const ProtectedLine& line, const Stretch& stretch, const Arrivals& arrivals,
                                const rockfall::Terrain& terrain);

}  // namespace coupling::siting
