#include "validation/engine/slope/rebuild.hpp"

#include <algorithm>
#include <cmath>

#include "config/grid/raster.hpp"
#include "config/random/distributions.hpp"
#include "config/random/stream.hpp"
#include "coupling/inputs/ground/surface_types.hpp"
#include "rockfall/slope/profile_strip.hpp"
#include "rockfall/terrain/contact_zone.hpp"
#include "rockfall/terrain/mesh.hpp"

namespace coupling::validation {

namespace {

/// The ground types of a profile, each once, moved as the recipe wants.
class Ground {
public:
    Ground(const Recipe& recipe, const Profile& profile) : known_{shipped_surfaces(*recipe.options)} {
        for (const ProfileCorner& corner : profile) {
            if (index_of(corner.surface) == names_.size()) {
                names_.push_back(corner.surface);
                types_.push_back(moved(corner.surface, recipe));
            }
        }
    }

    [[nodiscard]] std::uint8_t id_of(const std::string& surface) const {
        return static_cast<std::uint8_t>(index_of(surface));
    }
    [[nodiscard]] const std::vector<rockfall::SurfaceType>& types() const { return types_; }

private:
    [[nodiscard]] std::size_t index_of(const std::string& surface) const {
        return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), surface) - names_.begin());
    }

    [[nodiscard]] rockfall::SurfaceType moved(const std::string& name, const Recipe& recipe) const {
        constexpr double most = 0.99;  // a rebound never gains energy
        const auto shipped = std::find_if(known_.begin(), known_.end(),
                                          [&](const ShippedSurface& s) { return s.name == name; });
        rockfall::SurfaceType type = shipped->type;
        if (recipe.p_stop_factor != 1.0) {
            constexpr double most_per_m = 100.0;
            type.stopping = type.stopping.times(recipe.p_stop_factor, 1.0);
            type.rolling_stops_per_m = type.rolling_stops_per_m.times(recipe.p_stop_factor, most_per_m);
        }
        const auto changed = [&](rockfall::Restitution restitution) {
            return rockfall::Restitution{std::clamp(restitution.normal + recipe.rn_change, 0.0, most),
                                         std::clamp(restitution.tangential + recipe.rt_change, 0.0, most)};
        };
        type.published = changed(type.as_published());
        type.restitution = changed(type.restitution);
        return type;
    }

    std::vector<ShippedSurface> known_;
    std::vector<std::string> names_;
    std::vector<rockfall::SurfaceType> types_;
};

/// The profile with corners where the relief has them, and its heights added.
Profile with_relief(const Profile& profile, const Relief& relief) {
    Profile rough;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const double to_m = i + 1 < profile.size() ? profile[i + 1].distance_m : profile[i].distance_m;
        rough.push_back(profile[i]);
        for (const double distance_m : relief.corners_m(profile[i].distance_m, to_m)) {
            rough.push_back({distance_m, height_at(profile, distance_m), profile[i].surface});
        }
    }
    for (ProfileCorner& corner : rough) {
        corner.height_m += relief.at(corner.distance_m, 0.0);
    }
    return rough;
}

/// The profile with its first and last piece drawn out by the margin.
Profile with_margins(const Profile& profile) {
    Profile longer = profile;
    const double above_m = profile.front().distance_m - margin_m;
    const double below_m = profile.back().distance_m + margin_m;
    longer.insert(longer.begin(), {above_m, height_at(profile, above_m), profile.front().surface});
    longer.push_back({below_m, height_at(profile, below_m), profile.back().surface});
    return longer;
}

rockfall::Slope strip(const Recipe& recipe, const Profile& profile) {
    const Ground ground{recipe, profile};
    std::vector<rockfall::ProfilePoint> points;
    for (const ProfileCorner& corner : with_relief(with_margins(profile), recipe.relief)) {
        points.push_back({corner.distance_m, corner.height_m, ground.id_of(corner.surface)});
    }
    const rockfall::GroundLaw& law = recipe.rockfall.ground;
    return rockfall::strip_slope(rockfall::contact_zone(points, law.contact_law(recipe.diameter_m)),
                                 ground.types());
}

/// Cells of which one column has its centre at the upper end and the middle row has it in the axis.
config::GridFrame frame_over(const Recipe& recipe, const Profile& profile) {
    const double cell_m = recipe.cell_m;
    const auto cells_for = [cell_m](double length_m) {
        return static_cast<int>(std::ceil(length_m / cell_m));
    };
    const int above = cells_for(margin_m);
    const int below = cells_for(profile.back().distance_m - profile.front().distance_m + margin_m);
    const int beside = cells_for(0.5 * recipe.width_m);
    return {.columns = above + below + 1,
            .rows = 2 * beside + 1,
            .x_west_m = profile.front().distance_m - (above + 0.5) * cell_m,
            .y_south_m = -(beside + 0.5) * cell_m,
            .cell_width_m = cell_m,
            .cell_height_m = cell_m};
}

config::Raster<double> heights_of(const Recipe& recipe, const Profile& profile) {
    config::Raster<double> heights{frame_over(recipe, profile)};
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const config::Cell cell = heights.frame.cell_of(i);
        const double x_m = heights.frame.x_centre_m(cell.column);
        const double out =
            std::min(std::abs(heights.frame.y_centre_m(cell.row)) / recipe.channel_half_width_m, 1.0);
        double height_m = height_at(profile, x_m) + recipe.channel_depth_m * out * out +
                          recipe.relief.at(x_m, heights.frame.y_centre_m(cell.row));
        if (recipe.relief_m > 0.0) {
            config::RandomStream stream{{.seed = recipe.relief_seed, .id = i}, config::Purpose::relief};
            height_m += config::normal(stream.uniform(), 0.0, recipe.relief_m);
        }
        heights.values[i] = height_m;
    }
    return heights;
}

/// Borders between surfaces as sharp as along a strip.
rockfall::SurfaceMap surfaces_of(const Profile& profile, const Ground& ground,
                                 const Eigen::Vector2d& origin_m) {
    const double from_m = profile.front().distance_m;
    const double length_m = profile.back().distance_m - from_m;
    const int columns = std::max(1, static_cast<int>(std::ceil(length_m / rockfall::profile_surface_cell_m)));
    config::GridFrame frame{columns, 1, from_m, -0.5, length_m / columns, 1.0};
    std::vector<std::uint8_t> ids;
    for (int column = 0; column < columns; ++column) {
        ids.push_back(ground.id_of(profile[corner_above(profile, frame.x_centre_m(column))].surface));
    }
    frame.x_west_m -= origin_m.x();
    frame.y_south_m -= origin_m.y();
    return {frame, std::move(ids)};
}

rockfall::Slope in_space(const Recipe& recipe, const Profile& profile) {
    const Ground ground{recipe, profile};
    const rockfall::GroundLaw& law = recipe.rockfall.ground;
    const config::Raster<double> heights = heights_of(recipe, profile);
    rockfall::Terrain terrain = rockfall::triangulate(
        rockfall::contact_zone(heights, law.contact_law(recipe.diameter_m), rockfall::HeightNoise{heights}),
        law.vertical_tolerance_m);
    rockfall::SurfaceMap surface = surfaces_of(profile, ground, terrain.origin_m());
    return {std::move(terrain), std::move(surface), ground.types()};
}

}  // namespace

rockfall::Target RebuiltSlope::line_at(const std::string& name, double distance_m) const {
    // Beyond the sides: no rock passes beside the line.
    const double side_m = width_m + margin_m;
    rockfall::Target line;
    line.id = name;
    line.name = name;
    line.parts = {{on_terrain(distance_m, -side_m), on_terrain(distance_m, side_m)}};
    return rockfall::with_bounds(std::move(line));
}

RebuiltSlope rebuild(const Recipe& recipe, const Profile& surveyed) {
    Profile profile = with_slope_change(surveyed, recipe.slope_change_deg);
    rockfall::Slope slope =
        recipe.head.kind == CaseKind::profile ? strip(recipe, profile) : in_space(recipe, profile);
    return {std::move(slope), std::move(profile), recipe.width_m, recipe.start_height_m > 0.0};
}

rockfall::StartLaw start_law(const Recipe& recipe) {
    rockfall::StartLaw law;
    law.diameter = rockfall::DiameterLaw::fixed(recipe.diameter_m);
    law.density_kgpm3 = recipe.density_kgpm3;
    law.height_m = recipe.start_height_m;
    law.speed_mps = recipe.start_speed_mps;
    law.dip = config::Angle::from_degrees(recipe.start_dip_deg);
    law.random_place = false;
    law.along_x_on_flat = true;
    return law;
}

}  // namespace coupling::validation
