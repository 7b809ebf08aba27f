#include "rockfall/solids/block_shape.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "config/math/elementary.hpp"
#include "rockfall/solids/shapes.hpp"

namespace rockfall {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

enum class Body : std::uint8_t { ball, box, rounded, octahedron, ellipsoid };

/// Sides of the middle of each class [choice]; rounded blocks have the edges of a chamfered box.
struct NamedShape {
    std::string_view name;
    Body body;
    double a, b, c;
};

constexpr std::array shapes_by_name{
    NamedShape{"sphere", Body::ball, 1.0, 1.0, 1.0},
    NamedShape{"cube", Body::box, 1.0, 1.0, 1.0},
    NamedShape{"octahedron", Body::octahedron, 1.0, 1.0, 1.0},
    NamedShape{"ellipsoid", Body::ellipsoid, 1.0, 0.8, 0.6},
    NamedShape{"equant", Body::rounded, 1.0, 0.95, 0.9},
    NamedShape{"plate", Body::box, 1.0, 1.0, 0.25},
    NamedShape{"column", Body::box, 1.0, 0.4, 0.4},
    NamedShape{"compact", Body::rounded, 1.0, 0.9, 0.8},
    NamedShape{"compact-platy", Body::rounded, 1.0, 0.95, 0.6},
    NamedShape{"compact-bladed", Body::rounded, 1.0, 0.8, 0.6},
    NamedShape{"compact-elongate", Body::rounded, 1.0, 0.66, 0.6},
    NamedShape{"platy", Body::rounded, 1.0, 0.9, 0.4},
    NamedShape{"bladed", Body::rounded, 1.0, 0.7, 0.4},
    NamedShape{"elongate", Body::rounded, 1.0, 0.5, 0.4},
    NamedShape{"very-platy", Body::rounded, 1.0, 0.9, 0.2},
    NamedShape{"very-bladed", Body::rounded, 1.0, 0.6, 0.2},
    NamedShape{"very-elongate", Body::rounded, 1.0, 0.3, 0.2},
};

solids::Solid scaled_solid(const solids::Solid& unit, double factor, double density_kgpm3) {
    solids::Solid solid = unit;
    const double volume_factor = factor * factor * factor;
    solid.volume_m3 *= volume_factor;
    solid.mass_kg = density_kgpm3 * solid.volume_m3;
    solid.inertia_kgm2 *= density_kgpm3 * volume_factor * factor * factor;
    solid.centroid_m *= factor;
    solid.bounding_radius_m *= factor;
    for (Vector3d& vertex_m : solid.hull.vertices_m) {
        vertex_m *= factor;
    }
    for (solids::Face& face : solid.hull.faces) {
        face.offset_m *= factor;
    }
    return solid;
}

/// Sine and cosine of an angle in turns on [0, 1).
config::SinCos of_turns(double turns) {
    const double quarters = 4.0 * turns;
    const int quarter = static_cast<int>(quarters);
    const config::SinCos rest = config::sin_cos_of((quarters - quarter) * 0.5 * std::numbers::pi);
    switch (quarter) {
        case 0:
            return rest;
        case 1:
            return {rest.cos, -rest.sin};
        case 2:
            return {-rest.sin, -rest.cos};
        default:
            return {-rest.cos, rest.sin};
    }
}

Quaterniond any_attitude(const config::FourUniforms& draws) {
    const double low = std::sqrt(1.0 - draws[0]);
    const double high = std::sqrt(draws[0]);
    const config::SinCos one = of_turns(draws[1]);
    const config::SinCos other = of_turns(draws[2]);
    return Quaterniond{high * other.cos, low * one.sin, low * one.cos, high * other.sin}.normalized();
}

}  // namespace

std::vector<std::string> named_shapes() {
    std::vector<std::string> names;
    for (const NamedShape& shape : shapes_by_name) {
        names.emplace_back(shape.name);
    }
    return names;
}

std::optional<solids::Hull> hull_of_shape(std::string_view name) {
    const auto* const found = std::find_if(shapes_by_name.begin(), shapes_by_name.end(),
                                           [&](const NamedShape& shape) { return shape.name == name; });
    assert(found != shapes_by_name.end());
    const Vector3d sides{found->a, found->b, found->c};
    constexpr int divisions = 2;
    switch (found->body) {
        case Body::box:
            return solids::box(sides);
        case Body::rounded:
            return solids::chamfered_box(sides, rounded_cut);
        case Body::octahedron:
            return solids::double_pyramid({1.0, 1.0, std::numbers::sqrt2});
        case Body::ellipsoid:
            return solids::ellipsoid(sides, divisions);
        case Body::ball:
            break;
    }
    return std::nullopt;
}

ShapeLaw::ShapeLaw(std::vector<BlockShape> shapes, double sides_scatter, std::optional<Quaterniond> attitude)
    : shapes_{std::move(shapes)}, sides_scatter_{sides_scatter}, attitude_{std::move(attitude)} {
    assert(!shapes_.empty() && sides_scatter >= 0.0 && sides_scatter < 1.0);
    for (const BlockShape& shape : shapes_) {
        unit_solids_.push_back(shape.hull ? solids::solid_of(*shape.hull, 1.0) : solids::ball_of(1.0, 1.0));
    }
}

DrawnBlock ShapeLaw::draw(double diameter_m, double density_kgpm3, const config::StreamKey& key) const {
    const config::RandomStream stream{key, config::Purpose::block_shape};
    const config::FourUniforms draws = stream.uniforms_of(0);
    double sum = 0.0;
    for (const BlockShape& shape : shapes_) {
        sum += shape.share;
    }
    std::size_t chosen = 0;
    for (double below = shapes_[0].share; chosen + 1 < shapes_.size() && draws[0] * sum >= below;) {
        below += shapes_[++chosen].share;
    }
    const BlockShape& shape = shapes_[chosen];
    const double volume_m3 = std::numbers::pi / 6.0 * diameter_m * diameter_m * diameter_m;
    solids::Solid solid;
    if (!shape.hull) {
        solid = solids::ball_of(diameter_m, density_kgpm3);
    } else {
        const solids::Solid& unit = unit_solids_[chosen];
        const solids::Solid* source = &unit;
        solids::Solid changed;
        if (sides_scatter_ > 0.0) {
            Vector3d factors;
            for (int axis = 0; axis < 3; ++axis) {
                factors[axis] =
                    1.0 + sides_scatter_ * (2.0 * draws[static_cast<std::size_t>(axis) + 1] - 1.0);
            }
            changed = solids::solid_of(solids::scaled(*shape.hull, factors), 1.0);
            source = &changed;
        }
        const double factor = shape.own_size ? 1.0 : config::pow_of(volume_m3 / source->volume_m3, 1.0 / 3.0);
        solid = scaled_solid(*source, factor, density_kgpm3);
    }
    DrawnBlock block;
    block.attitude = attitude_ ? *attitude_ : any_attitude(stream.uniforms_of(1));
    block.solid = std::make_shared<const solids::Solid>(std::move(solid));
    return block;
}

double ShapeLaw::largest_radius_m(double diameter_m) const {
    double largest_m = 0.0;
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
        const solids::Solid& unit = unit_solids_[i];
        const double factor = shapes_[i].own_size ? 1.0 : diameter_m / unit.diameter_m();
        // Sides that scatter change the ratio of the sides at most by their two factors.
        const double spread = (1.0 + sides_scatter_) / (shapes_[i].own_size ? 1.0 : 1.0 - sides_scatter_);
        largest_m = std::max(largest_m, factor * spread * unit.bounding_radius_m);
    }
    return largest_m;
}

std::optional<double> ShapeLaw::own_diameter_m() const {
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
        if (shapes_[i].own_size) {
            return unit_solids_[i].diameter_m();
        }
    }
    return std::nullopt;
}

}  // namespace rockfall
