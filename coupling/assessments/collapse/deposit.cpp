#include "coupling/assessments/collapse/deposit.hpp"

#include <algorithm>
#include <cmath>

namespace coupling::collapse {
namespace {

using Eigen::Vector3d;
using Polygon = std::vector<Vector3d>;

/// The part of a polygon on which sign x coordinate is at most sign x limit.
Polygon part_within(const Polygon& polygon, int axis, double sign, double limit_m) {
    Polygon part;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector3d& a = polygon[k];
        const Vector3d& b = polygon[(k + 1) % polygon.size()];
        const double beyond_a = sign * (a[axis] - limit_m), beyond_b = sign * (b[axis] - limit_m);
        if (beyond_a <= 0.0) {
            part.push_back(a);
        }
        if ((beyond_a < 0.0 && beyond_b > 0.0) || (beyond_a > 0.0 && beyond_b < 0.0)) {
            part.push_back(a + beyond_a / (beyond_a - beyond_b) * (b - a));
            part.back()[axis] = limit_m;
        }
    }
    return part;
}

/// The integral of height over the plan of a polygon, positive where it is seen counter-clockwise from above.
double height_integral_m3(const Polygon& polygon) {
    double sum = 0.0;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        const Vector3d b = polygon[k] - polygon[0], c = polygon[k + 1] - polygon[0];
        const double area_m2 = 0.5 * (b.x() * c.y() - b.y() * c.x());
        sum += area_m2 * (polygon[0].z() + polygon[k].z() + polygon[k + 1].z()) / 3.0;
    }
    return sum;
}

struct Extent {
    Eigen::Vector2d low_m = Eigen::Vector2d::Constant(1e300);
    Eigen::Vector2d high_m = Eigen::Vector2d::Constant(-1e300);
};

/// The faces of a block; heights from its centre, so that no digits are lost.
std::vector<Polygon> faces_of(const LyingBlock& block, Extent& extent) {
    const Eigen::Matrix3d turn = block.attitude.normalized().toRotationMatrix();
    const Vector3d in_plan_m{block.centre_m.x(), block.centre_m.y(), 0.0};
    std::vector<Polygon> faces;
    for (const auto& face : block.hull.faces) {
        Polygon& polygon = faces.emplace_back();
        for (const std::uint32_t corner : face.corners) {
            polygon.push_back(in_plan_m + turn * block.hull.vertices_m[corner]);
            extent.low_m = extent.low_m.cwiseMin(polygon.back().head<2>());
            extent.high_m = extent.high_m.cwiseMax(polygon.back().head<2>());
        }
    }
    return faces;
}

}  // namespace

void add_block(Deposit& deposit, const config::GridFrame& frame, const LyingBlock& block) {
    Extent extent;
    const std::vector<Polygon> faces = faces_of(block, extent);
    const config::Cell first = frame.cell_at(extent.low_m.x(), extent.high_m.y());
    const config::Cell last = frame.cell_at(extent.high_m.x(), extent.low_m.y());
    for (int column = std::max(0, first.column); column <= std::min(frame.columns - 1, last.column);
         ++column) {
        const double west_m = frame.x_west_m + column * frame.cell_width_m;
        std::vector<Polygon> strips;
        for (const Polygon& face : faces) {
            strips.push_back(
                part_within(part_within(face, 0, -1.0, west_m), 0, 1.0, west_m + frame.cell_width_m));
        }
        for (int row = std::max(0, first.row); row <= std::min(frame.rows - 1, last.row); ++row) {
            const double north_m = frame.y_north_m() - row * frame.cell_height_m;
            double volume_m3 = 0.0;
            for (const Polygon& strip : strips) {
                volume_m3 += height_integral_m3(
                    part_within(part_within(strip, 1, 1.0, north_m), 1, -1.0, north_m - frame.cell_height_m));
            }
            if (volume_m3 > 0.0) {
                const std::size_t cell = frame.index({column, row});
                deposit.volume_m3[cell] += volume_m3;
                deposit.largest_m[cell] = std::max(deposit.largest_m[cell], block.size_m);
            }
        }
    }
}

Deposit deposit_of(const CollapseResults& results) {
    const CollapseSite& site = results.site;
    Deposit deposit{site.map_frame.size()};
    for (std::size_t i = 0; i < site.count.free; ++i) {
        const SeenBlock block = results.seen(i);
        const double size_m = 2.0 * results.mass.blocks()[i].half_side_m;
        const double way_m = (block.centre_m - site.blocks[i].centre_m).norm();
        if (block.status == rockfall::rock_mass::BlockStatus::left || way_m <= moved_by_sizes * size_m) {
            continue;
        }
        Vector3d centre_m = block.centre_m;
        centre_m.head<2>() += site.origin_m;
        add_block(deposit, site.map_frame, {site.blocks[i].solid.hull, centre_m, block.attitude, size_m});
    }
    return deposit;
}

}  // namespace coupling::collapse
