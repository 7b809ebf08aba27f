#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/nets/figures/net_paths.hpp"
#include "coupling/inputs/nets/net_record.hpp"
#include "rockfall/obstacles/nets/net_index.hpp"

namespace coupling {

/// The direction in which a net is moved away from the line that it is to protect.
struct Uphill {
    enum class From : std::uint8_t { rocks, gradient, given };
    Eigen::Vector2d direction;  ///< unit vector in plan
    From from;
    std::uint64_t rocks = 0;  ///< From::rocks: how many came from there

    /// Clockwise from north, [0, 360).
    [[nodiscard]] double azimuth_deg() const;
};

/// "rocks", "gradient", "given".
const char* name_of(Uphill::From from);

/// Requires an azimuth clockwise from north.
Uphill uphill_along(double azimuth_deg);

/// The unit vector in plan that leads uphill across a line, from the mean gradient of the ground below it;
/// nothing on level ground.
std::optional<Eigen::Vector2d> uphill_across(const rockfall::Net& net, const rockfall::Terrain& terrain);

/// Nets on lines so low that every rock passes over: they only show who crosses.
rockfall::NetIndex lines_alone(std::span<const NetRecord> lines);

/// From where rocks come to lines: the mean of their directions as they first cross each.
class Arrivals {
public:
    Arrivals(std::span<const NetRecord> lines, const rockfall::Terrain& terrain);
    void look(const StoredPath& path);

    /// Against the way of the rocks with forest, or over the bare slope where none comes through it. Where no
    /// rock comes, or they come from all sides, along the gradient; nothing on level ground.
    [[nodiscard]] std::optional<Uphill> uphill(std::uint32_t line) const;

private:
    struct Sum {
        Eigen::Vector2d directions = Eigen::Vector2d::Zero();  ///< of unit vectors
        std::uint64_t rocks = 0;
    };
    std::span<const NetRecord> lines_;
    const rockfall::Terrain& terrain_;
    rockfall::NetIndex index_;
    std::vector<std::array<Sum, rockfall::covers>> sums_;  ///< by line
};

}  // namespace coupling
