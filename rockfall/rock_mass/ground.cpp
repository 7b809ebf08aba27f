#include "rockfall/rock_mass/ground.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rockfall/rock_mass/convex_cell.hpp"

namespace rockfall::rock_mass {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

GroundPrism prism_of(const Terrain& terrain, const Triangle& triangle) {
    std::array<Vector3d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vertex& vertex = terrain.vertices()[triangle.corners[k]];
        corners[k] = {vertex.x_m, vertex.y_m, vertex.z_m};
    }
    GroundPrism prism;
    const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    prism.top = {normal, normal.dot(corners[0])};
    prism.low_m = prism.high_m = corners[0].head<2>();
    prism.highest_m = corners[0].z();
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector3d along = corners[(k + 1) % 3] - corners[k];
        const Vector3d out = Vector3d{along.y(), -along.x(), 0.0}.normalized();
        prism.sides[k] = {out, out.dot(corners[k])};
        prism.low_m = prism.low_m.cwiseMin(corners[k].head<2>());
        prism.high_m = prism.high_m.cwiseMax(corners[k].head<2>());
        prism.highest_m = std::max(prism.highest_m, corners[k].z());
    }
    return prism;
}

/// The planes of a prism in the order of their bits.
const Plane3& plane_of(const GroundPrism& prism, std::size_t k) {
    return k == 0 ? prism.top : prism.sides[k - 1];
}

/// By vertex of a block: the planes of a prism that it lies outside of, as bits.
using PrismCodes = std::array<std::uint8_t, 2 * most_faces>;

/// By vertex of a block: its height over the top of a prism.
using PrismHeights = std::array<double, 2 * most_faces>;

/// Whether the part of a block below the plane of a prism's top lies beside the prism, by their boxes in
/// plan.
bool sinks_beside(const GroundPrism& prism, const PlacedBlock& block, const PrismHeights& top_m) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Vector2d low_m{infinite, infinite}, high_m{-infinite, -infinite};
    const auto add = [&](const Vector2d& place_m) {
        low_m = low_m.cwiseMin(place_m);
        high_m = high_m.cwiseMax(place_m);
    };
    for (std::size_t v = 0; v < block.vertices_m.size(); ++v) {
        if (top_m[v] <= 0.0) {
            add(block.vertices_m[v].head<2>());
        }
    }
    const auto is_beside = [&] {
        return low_m.x() > prism.high_m.x() || high_m.x() < prism.low_m.x() || low_m.y() > prism.high_m.y() ||
               high_m.y() < prism.low_m.y();
    };
    if (!is_beside()) {
        return false;
    }
    // Each edge belongs to two faces, which go along it in opposite directions.
    for (std::size_t g = 0; g < block.faces.size(); ++g) {
        const std::span<const std::uint16_t> corners = block.corners_of(g);
        std::uint16_t last = corners.back();
        for (const std::uint16_t corner : corners) {
            if (top_m[last] <= 0.0 && top_m[corner] > 0.0) {
                const Vector2d from_m = block.vertices_m[last].head<2>();
                add(from_m + top_m[last] / (top_m[last] - top_m[corner]) *
                                 (block.vertices_m[corner].head<2>() - from_m));
            }
            last = corner;
        }
    }
    return is_beside();
}

/// How far one of the planes of a prism keeps a block away; below 0 if none does, and 0 where what of the
/// block is deep enough lies beside the prism. The sphere of the block says it of most prisms.
double find_codes(const GroundPrism& prism, const PlacedBlock& block, PrismCodes& outside) {
    std::array<double, 4> centre_m;
    double farthest_m = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 4; ++k) {
        centre_m[k] = plane_of(prism, k).height_m(block.centre_m);
        farthest_m = std::max(farthest_m, centre_m[k]);
    }
    if (farthest_m >= block.radius_m) {
        return farthest_m - block.radius_m;
    }
    PrismHeights top_m;
    double away_m = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < block.vertices_m.size(); ++v) {
        top_m[v] = prism.top.height_m(block.vertices_m[v]);
        away_m = std::min(away_m, top_m[v]);
        outside[v] = top_m[v] > 0.0 ? 1 : 0;
    }
    if (away_m >= 0.0) {
        return away_m;
    }
    if (sinks_beside(prism, block, top_m)) {
        return 0.0;
    }
    for (std::size_t k = 1; k < 4; ++k) {
        if (centre_m[k] <= -block.radius_m) {
            continue;
        }
        const Plane3& plane = plane_of(prism, k);
        double lowest_m = std::numeric_limits<double>::infinity();
        for (std::size_t v = 0; v < block.vertices_m.size(); ++v) {
            const double height_m = plane.height_m(block.vertices_m[v]);
            lowest_m = std::min(lowest_m, height_m);
            outside[v] |= static_cast<std::uint8_t>(height_m > 0.0 ? 1U << k : 0U);
        }
        away_m = std::max(away_m, lowest_m);
        if (away_m >= 0.0) {
            break;
        }
    }
    return away_m;
}

/// Adds what of a block lies in a prism.
void add_prism(const GroundPrism& prism, const PlacedBlock& block, const PrismCodes& outside,
               const Vector3d& about_m, CutPolygon& piece, OverlapSums& sum, OverlapSlope* slope) {
    for (std::size_t g = 0; g < block.faces.size(); ++g) {
        unsigned all = 0xF, any = 0;
        for (const std::uint16_t corner : block.corners_of(g)) {
            all &= outside[corner];
            any |= outside[corner];
        }
        if (all != 0) {
            continue;
        }
        const std::span<const std::uint16_t> corners = block.corners_of(g);
        const FaceFrame frame{block.vertices_m[corners[0]], block.faces[g].normal};
        Polygon2& start = piece.start();
        start.add(Eigen::Vector2d::Zero());
        for (const std::uint16_t corner : corners.subspan(1)) {
            start.add(frame.in_plane(block.vertices_m[corner]));
        }
        bool left = true;
        for (std::size_t k = 0; k < 4 && left; ++k) {
            left = (any >> k & 1U) == 0 || piece.cut(frame.height_over(plane_of(prism, k)));
        }
        if (left) {
            FaceSums sums;
            const Height2 height = frame.height_over(prism.top);
            sums.add(piece.left(), height);
            sums.find_spread(piece.left(), height);
            add_face(frame, block.faces[g].normal, sums, about_m, sum);
            if (slope != nullptr) {
                slope->add(piece.left(), frame, block.faces[g].normal, prism.top.normal, about_m);
            }
        }
    }
}

}  // namespace

Ground::Ground(const Terrain& terrain) {
    for (const Triangle& triangle : terrain.triangles()) {
        prisms_.push_back(prism_of(terrain, triangle));
    }
    if (prisms_.empty()) {
        return;
    }
    Vector2d low = prisms_[0].low_m, high = prisms_[0].high_m;
    double mean_size_m = 0.0;
    for (const GroundPrism& prism : prisms_) {
        low = low.cwiseMin(prism.low_m);
        high = high.cwiseMax(prism.high_m);
        mean_size_m += (prism.high_m - prism.low_m).maxCoeff() / static_cast<double>(prisms_.size());
    }
    low_m_ = low;
    bin_m_ = std::max(mean_size_m, 1e-3 * (high - low).maxCoeff());
    for (std::size_t axis = 0; axis < 2; ++axis) {
        bins_[axis] = static_cast<int>((high - low)[static_cast<Eigen::Index>(axis)] / bin_m_) + 1;
    }
    std::vector<std::vector<std::uint32_t>> bins(bin_at(0, bins_[1]));
    for (std::uint32_t i = 0; i < prisms_.size(); ++i) {
        const BinRange range = bins_of(prisms_[i].low_m, prisms_[i].high_m);
        for (int row = range.from[1]; row <= range.to[1]; ++row) {
            for (int column = range.from[0]; column <= range.to[0]; ++column) {
                bins[bin_at(column, row)].push_back(i);
            }
        }
    }
    first_.push_back(0);
    for (const std::vector<std::uint32_t>& bin : bins) {
        listed_.insert(listed_.end(), bin.begin(), bin.end());
        first_.push_back(static_cast<std::uint32_t>(listed_.size()));
    }
}

Ground::BinRange Ground::bins_of(const Vector2d& low_m, const Vector2d& high_m) const {
    const auto place = [&](double at_m, std::size_t axis) {
        const double from_m = low_m_[static_cast<Eigen::Index>(axis)];
        return static_cast<int>(
            std::clamp(std::floor((at_m - from_m) / bin_m_), 0.0, static_cast<double>(bins_[axis] - 1)));
    };
    return {{place(low_m.x(), 0), place(low_m.y(), 1)}, {place(high_m.x(), 0), place(high_m.y(), 1)}};
}

std::vector<std::uint32_t> Ground::prisms_in(const Vector2d& low_m, const Vector2d& high_m) const {
    std::vector<std::uint32_t> found;
    if (empty()) {
        return found;
    }
    const BinRange range = bins_of(low_m, high_m);
    for (int row = range.from[1]; row <= range.to[1]; ++row) {
        for (int column = range.from[0]; column <= range.to[0]; ++column) {
            const std::size_t bin = bin_at(column, row);
            for (std::uint32_t k = first_[bin]; k < first_[bin + 1]; ++k) {
                const GroundPrism& prism = prisms_[listed_[k]];
                if ((prism.low_m.array() <= high_m.array()).all() &&
                    (prism.high_m.array() >= low_m.array()).all()) {
                    found.push_back(listed_[k]);
                }
            }
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

double Ground::highest_m(std::span<const std::uint32_t> prisms) const {
    double highest = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : prisms) {
        highest = std::max(highest, prisms_[i].highest_m);
    }
    return highest;
}

Overlap Ground::overlap_of(std::span<const std::uint32_t> prisms, const PlacedBlock& block,
                           const Vector3d& about_m, OverlapSlope* slope) const {
    OverlapSums sum;
    sum.gap_m = std::numeric_limits<double>::infinity();
    PrismCodes outside;
    CutPolygon piece;
    for (const std::uint32_t i : prisms) {
        const double away_m = find_codes(prisms_[i], block, outside);
        if (away_m < 0.0) {
            add_prism(prisms_[i], block, outside, about_m, piece, sum, slope);
        }
        sum.gap_m = std::clamp(away_m, 0.0, sum.gap_m);
    }
    if (slope != nullptr) {
        slope->turn_with(sum);
    }
    return sum.finished();
}

double Ground::energy_m4(std::span<const std::uint32_t> prisms, const PlacedBlock& block) const {
    double sum = 0.0;
    ConvexCell cell;
    for (const std::uint32_t i : prisms) {
        const GroundPrism& prism = prisms_[i];
        PrismCodes outside;
        if (find_codes(prism, block, outside) >= 0.0) {
            continue;
        }
        if (cell.faces.empty()) {
            cell = cell_of(block);
        }
        ConvexCell part = part_below(cell, prism.top);
        for (std::size_t k = 0; k < 3 && !part.faces.empty(); ++k) {
            part = part_below(part, prism.sides[k]);
        }
        if (!part.faces.empty()) {
            const VolumeAndCentre held = volume_and_centre(part);
            sum -= held.volume_m3 * prism.top.height_m(held.centre_m);
        }
    }
    return sum;
}

}  // namespace rockfall::rock_mass
