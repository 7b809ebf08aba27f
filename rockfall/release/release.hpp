#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "config/geometry/shape.hpp"
#include "config/random/stream.hpp"
#include "config/units/angle.hpp"
#include "rockfall/motion/fall.hpp"
#include "rockfall/release/elongation.hpp"
#include "rockfall/slope/slope.hpp"
#include "rockfall/solids/block_shape.hpp"

namespace rockfall {

struct StartLaw;

/// A polygon that is smaller than the cells of the terrain: its rocks start inside it.
struct SourceOutline {
    config::Shape polygon;    ///< in coordinates of the terrain
    Eigen::Vector2d inner_m;  ///< a place inside it, on the terrain
};

/// Where rocks break off: a grid cell, a point or a piece of a line, in coordinates of the terrain.
struct ReleaseSource {
    enum class Kind : std::uint8_t { cell, line };  ///< a point is a line without length
    Kind kind = Kind::cell;
    Eigen::Vector2d first_m = Eigen::Vector2d::Zero();  ///< south-western corner, or one end
    Eigen::Vector2d last_m = Eigen::Vector2d::Zero();   ///< north-eastern corner, or the other end
    std::uint32_t zone = 0;                             ///< number that the user gave the release zone
    double weight = 1.0;                           ///< share of the rocks: true surface area, length or 1
    std::uint64_t first_rock = 0;                  ///< number of its first rock; set by `allot`
    std::uint32_t rocks = 0;                       ///< set by `allot`
    std::shared_ptr<const SourceOutline> outline;  ///< of a cell: only the part of it inside the polygon
    bool evenly = false;  ///< along a line: rock k of n starts in the k-th of n equal stretches
    std::shared_ptr<const StartLaw> own_start;  ///< how its rocks begin; null: as those of all others
};

/// Shares `total` rocks among the sources by `spread` and numbers them in order of the sources.
void allot(std::vector<ReleaseSource>& sources, std::uint64_t total);

/// Shares `total` rocks among sources: the weights laid end to end are cut into `total` equal stretches, and
/// the source in which the middle of a stretch lies gets its rock. So each source gets its share but for one
/// rock, and so does any run of sources that follow one another: few rocks are spread over all of them, and
/// none of them by its place in the list or by a large weight. Numbers nothing. Requires weights > 0.
void spread(std::span<ReleaseSource> sources, std::uint64_t total);

/// Numbers the rocks in order of the sources, each of which knows how many it has.
void number_rocks(std::span<ReleaseSource> sources);

/// How large the rocks are.
class DiameterLaw {
public:
    static DiameterLaw fixed(double diameter_m);
    /// Requires as many positive diameters as positive shares.
    static DiameterLaw classes(std::vector<double> diameters_m, const std::vector<double>& shares);
    static DiameterLaw uniform(double low_m, double high_m);
    /// Log-normal by the mean and standard deviation of the diameter itself, cut off to [low_m, high_m].
    static DiameterLaw lognormal(double mean_m, double deviation_m, double low_m, double high_m);

    /// The diameter at a uniform draw on [0, 1).
    [[nodiscard]] double at(double u) const;
    [[nodiscard]] double smallest_m() const;
    [[nodiscard]] double largest_m() const;
    [[nodiscard]] double mean_m() const;

private:
    /// All kinds as one table of quantiles: knots (share, diameter), straight between (steps for classes).
    std::vector<std::pair<double, double>> knots_;
    bool steps_ = false;
};

/// How rocks begin to move.
struct StartLaw {
    DiameterLaw diameter = DiameterLaw::fixed(1.0);
    ElongationLaw elongation;
    double density_kgpm3 = 2700.0;
    double height_m = 1.5;   ///< of the underside above ground; 0 starts rolling
    double speed_mps = 3.0;  ///< 0 lets the rock drop
    config::Angle dip = config::Angle::from_degrees(30.0);  ///< of the velocity below the horizon
    std::optional<config::Angle> azimuth;   ///< heading, clockwise from north (+y); none: the fall line
    config::Angle heading_scatter;          ///< largest turn away from the heading, uniform both ways
    bool random_place = true;               ///< anywhere in the source cell; off: at its centre
    std::shared_ptr<const ShapeLaw> shape;  ///< of models whose rocks have a shape; null: spheres
    bool along_x_on_flat = false;  ///< ground without a fall line: towards +x instead of anywhere (profiles)
};

/// Diameters over all rocks of the sources, each by the start that holds for it.
struct DiameterRange {
    double smallest_m = 0.0;
    double largest_m = 0.0;
    double mean_m = 0.0;  ///< over the rocks
};

/// Largest distance of any point of a rock from its centre over all starts [m]: what obstacles are indexed
/// for.
double largest_radius_m(const StartLaw& common, std::span<const ReleaseSource> sources);

/// Without sources that of the common start.
DiameterRange diameter_range(const StartLaw& common, std::span<const ReleaseSource> sources);

/// The start of a rock of a source; nothing if its place lies outside the terrain.
///
/// Direction: the azimuth, or down the fall line of the ground there (on flat ground any), turned by the
/// scatter. Drawn from the rock's own stream. `common` holds unless the source has a start of
/// its own; `size_factor` is on the diameters of `common`.
std::optional<RockStart> start_of(const Slope& slope, const ReleaseSource& source,
                                  std::uint32_t source_number, const StartLaw& common, config::StreamKey key,
                                  double size_factor = 1.0);

}  // namespace rockfall
