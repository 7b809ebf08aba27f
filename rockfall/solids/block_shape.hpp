#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/random/stream.hpp"
#include "rockfall/solids/mass_properties.hpp"

namespace rockfall {

/// A block as it is released.
struct DrawnBlock {
    std::shared_ptr<const solids::Solid> solid;
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  ///< of the given axes in space
};

/// A shape that rocks of a source can have.
struct BlockShape {
    std::string name;
    std::optional<solids::Hull> hull;  ///< in its given axes; none: a sphere
    bool own_size = false;             ///< as large as the hull; else scaled to the volume of the diameter
    double share = 1.0;                ///< of the rocks, relative to the other shapes, > 0
};

/// Which shapes the rocks of a source have, how their sides scatter and how they lie at release.
///
/// Shape, sides and attitude are drawn for each rock. Each side (extent along a given axis) is multiplied by
/// a factor that is uniform on [1 - scatter, 1 + scatter]; then the block gets the volume of the sphere of
/// its diameter, unless its shape has a size of its own. Attitudes at random are uniform over all rotations
/// (Shoemake 1992, Graphics Gems III).
class ShapeLaw {
public:
    /// Requires one shape or more, 0 <= sides_scatter < 1.
    ShapeLaw(std::vector<BlockShape> shapes, double sides_scatter,
             std::optional<Eigen::Quaterniond> attitude);

    [[nodiscard]] DrawnBlock draw(double diameter_m, double density_kgpm3,
                                  const config::StreamKey& key) const;
    [[nodiscard]] const std::vector<BlockShape>& shapes() const { return shapes_; }
    [[nodiscard]] double sides_scatter() const { return sides_scatter_; }
    /// Whether the attitude is drawn.
    [[nodiscard]] bool at_random() const { return !attitude_; }
    /// Largest distance of a vertex from the centroid over all shapes, for a diameter.
    [[nodiscard]] double largest_radius_m(double diameter_m) const;
    /// Diameter of the sphere of equal volume of a shape that has its own size; none without such shapes.
    [[nodiscard]] std::optional<double> own_diameter_m() const;

private:
    std::vector<BlockShape> shapes_;
    std::vector<solids::Solid> unit_solids_;  ///< of density 1, as large as given; a sphere has none
    double sides_scatter_;
    std::optional<Eigen::Quaterniond> attitude_;
};

/// Of half the shortest side, what the cut edges of a rounded block take [choice].
inline constexpr double rounded_cut = 0.35;

/// Names of the shapes that need no file: sphere, cube, octahedron, ellipsoid, equant, plate, column, and the
/// form classes of Sneed & Folk.
std::vector<std::string> named_shapes();

/// The hull of a named shape, of any size; none for a sphere. Requires a name of `named_shapes`.
std::optional<solids::Hull> hull_of_shape(std::string_view name);

}  // namespace rockfall
