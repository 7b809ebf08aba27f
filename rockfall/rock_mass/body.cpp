#include "rockfall/rock_mass/body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "rockfall/rock_mass/interfaces.hpp"
#include "rockfall/solids/hull.hpp"

namespace rockfall::rock_mass {

using Eigen::Vector3d;

namespace {

/// Pieces of facets that are smaller do not divide a cell [m].
constexpr double thin_m = 1e-7;

Vector3d area_of(const std::vector<Vector3d>& corners_m) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t k = 1; k + 1 < corners_m.size(); ++k) {
        sum += (corners_m[k] - corners_m[0]).cross(corners_m[k + 1] - corners_m[0]);
    }
    return 0.5 * sum;
}

/// The part of a polygon below a plane.
std::vector<Vector3d> cut_polygon(const std::vector<Vector3d>& corners_m, const Plane3& plane) {
    std::vector<Vector3d> kept;
    for (std::size_t i = 0; i < corners_m.size(); ++i) {
        const Vector3d& from = corners_m[i];
        const Vector3d& to = corners_m[(i + 1) % corners_m.size()];
        const double at_from = plane.height_m(from), at_to = plane.height_m(to);
        if (at_from <= 0.0) {
            kept.push_back(from);
        }
        if ((at_from <= 0.0) != (at_to <= 0.0)) {
            kept.push_back(from + at_from / (at_from - at_to) * (to - from));
        }
    }
    return kept;
}

/// The part of a polygon strictly within a cell; nothing where it only touches a face.
std::optional<std::vector<Vector3d>> within(const std::vector<Vector3d>& polygon_m, const ConvexCell& cell) {
    std::vector<Vector3d> rest = polygon_m;
    for (const CellFace& face : cell.faces) {
        rest = cut_polygon(rest, {face.plane.normal, face.plane.offset_m - thin_m});
        if (rest.size() < 3) {
            return std::nullopt;
        }
    }
    if (area_of(rest).norm() < thin_m * thin_m) {
        return std::nullopt;
    }
    return rest;
}

Division divide_by(const ConvexCell& cell, const Body& body, std::vector<std::vector<Vector3d>> facets,
                   int made_by) {
    // Facets that do not reach into this cell divide nothing here.
    std::erase_if(facets, [&](const std::vector<Vector3d>& facet) { return !within(facet, cell); });
    if (facets.empty()) {
        Division whole;
        (body.contains(volume_and_centre(cell).centre_m) ? whole.inside : whole.outside).push_back(cell);
        return whole;
    }
    // The largest one first: fewest pieces.
    const auto largest = std::max_element(facets.begin(), facets.end(), [&](const auto& a, const auto& b) {
        return area_of(*within(a, cell)).squaredNorm() < area_of(*within(b, cell)).squaredNorm();
    });
    const Vector3d normal = area_of(*largest).normalized();
    const Plane3 plane{normal, normal.dot((*largest)[0])};
    const ConvexCell below = part_below(cell, plane, made_by);
    const ConvexCell above = part_below(cell, {-plane.normal, -plane.offset_m}, made_by);
    facets.erase(largest);
    if (below.faces.empty() || above.faces.empty()) {
        return divide_by(cell, body, std::move(facets), made_by);
    }
    Division low = divide_by(below, body, facets, made_by);
    Division high = divide_by(above, body, std::move(facets), made_by);
    if (low.inside.empty() && high.inside.empty()) {
        return {{}, {cell}};
    }
    if (low.outside.empty() && high.outside.empty()) {
        return {{cell}, {}};
    }
    low.inside.insert(low.inside.end(), high.inside.begin(), high.inside.end());
    low.outside.insert(low.outside.end(), high.outside.begin(), high.outside.end());
    return low;
}

struct CellBox {
    Vector3d low_m;
    Vector3d high_m;
};

CellBox cell_box(const ConvexCell& cell) {
    CellBox box{Vector3d::Constant(std::numeric_limits<double>::infinity()),
                Vector3d::Constant(-std::numeric_limits<double>::infinity())};
    for (const CellFace& face : cell.faces) {
        for (const Vector3d& corner_m : face.corners_m) {
            box.low_m = box.low_m.cwiseMin(corner_m);
            box.high_m = box.high_m.cwiseMax(corner_m);
        }
    }
    return box;
}

/// Two cells as one, if that is convex.
std::optional<ConvexCell> united(const ConvexCell& a, const ConvexCell& b) {
    std::vector<Vector3d> corners = corners_of(a);
    const std::vector<Vector3d> others = corners_of(b);
    corners.insert(corners.end(), others.begin(), others.end());
    ConvexCell hull = cell_of(solids::convex_hull(corners), 0);
    const double sum_m3 = volume_and_centre(a).volume_m3 + volume_and_centre(b).volume_m3;
    if (volume_and_centre(hull).volume_m3 > sum_m3 * (1.0 + 1e-9)) {
        return std::nullopt;
    }
    for (CellFace& face : hull.faces) {
        for (const ConvexCell* part : {&a, &b}) {
            for (const CellFace& old : part->faces) {
                if (old.plane.normal.dot(face.plane.normal) > 1.0 - 1e-9 &&
                    std::abs(old.plane.offset_m - face.plane.offset_m) < 1e-6) {
                    face.made_by = old.made_by;
                }
            }
        }
    }
    return hull;
}

}  // namespace

Division divide(const ConvexCell& cell, const Body& body, std::span<const std::uint32_t> facets,
                int made_by) {
    std::vector<std::vector<Vector3d>> polygons;
    for (const std::uint32_t number : facets) {
        polygons.push_back(body.border[number].corners_m);
    }
    return divide_by(cell, body, std::move(polygons), made_by);
}

FacetIndex::FacetIndex(const Body& body, double bin_m) : bin_m_{bin_m} {
    low_m_ = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector2d high = -low_m_;
    for (const Facet& facet : body.border) {
        FacetBox box{facet.corners_m[0], facet.corners_m[0]};
        for (const Vector3d& corner_m : facet.corners_m) {
            box.low_m = box.low_m.cwiseMin(corner_m);
            box.high_m = box.high_m.cwiseMax(corner_m);
        }
        low_m_ = low_m_.cwiseMin(box.low_m.head<2>());
        high = high.cwiseMax(box.high_m.head<2>());
        boxes_.push_back(box);
    }
    columns_ = static_cast<int>((high.x() - low_m_.x()) / bin_m_) + 1;
    rows_ = static_cast<int>((high.y() - low_m_.y()) / bin_m_) + 1;
    bins_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
        for (int row = static_cast<int>((boxes_[i].low_m.y() - low_m_.y()) / bin_m_);
             row <= static_cast<int>((boxes_[i].high_m.y() - low_m_.y()) / bin_m_); ++row) {
            for (int column = static_cast<int>((boxes_[i].low_m.x() - low_m_.x()) / bin_m_);
                 column <= static_cast<int>((boxes_[i].high_m.x() - low_m_.x()) / bin_m_); ++column) {
                bins_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                      static_cast<std::size_t>(column)]
                    .push_back(i);
            }
        }
    }
}

std::vector<std::uint32_t> FacetIndex::near(const ConvexCell& cell) const {
    const CellBox box = cell_box(cell);
    const auto bin = [&](double at_m, double from_m, int count) {
        return static_cast<int>(std::clamp(std::floor((at_m - from_m) / bin_m_), 0.0, count - 1.0));
    };
    std::vector<std::uint32_t> found;
    for (int row = bin(box.low_m.y(), low_m_.y(), rows_); row <= bin(box.high_m.y(), low_m_.y(), rows_);
         ++row) {
        for (int column = bin(box.low_m.x(), low_m_.x(), columns_);
             column <= bin(box.high_m.x(), low_m_.x(), columns_); ++column) {
            for (const std::uint32_t i :
                 bins_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                       static_cast<std::size_t>(column)]) {
                if ((boxes_[i].low_m.array() <= box.high_m.array()).all() &&
                    (boxes_[i].high_m.array() >= box.low_m.array()).all()) {
                    found.push_back(i);
                }
            }
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

Merged merge_slivers(std::vector<ConvexCell> cells, double least_size_m) {
    std::vector<std::vector<Interface>> shared(cells.size());
    for (Interface& face : shared_faces(cells)) {
        shared[face.first].push_back(face);
        std::swap(face.first, face.second);
        shared[face.first].push_back(std::move(face));
    }
    // A cell that went into another one is that one from then on.
    std::vector<std::uint32_t> now(cells.size());
    for (std::uint32_t i = 0; i < cells.size(); ++i) {
        now[i] = i;
    }
    Merged result;
    std::vector<std::uint8_t> gone(cells.size(), 0);
    for (std::uint32_t i = 0; i < cells.size(); ++i) {
        if (gone[i] != 0 || size_m(cells[i]) >= least_size_m) {
            continue;
        }
        std::stable_sort(shared[i].begin(), shared[i].end(),
                         [](const Interface& a, const Interface& b) { return a.area_m2 > b.area_m2; });
        bool found = false;
        for (const Interface& face : shared[i]) {
            std::uint32_t other = face.second;
            while (now[other] != other) {
                other = now[other];
            }
            if (other == i || gone[other] != 0) {
                continue;
            }
            if (std::optional<ConvexCell> both = united(cells[i], cells[other])) {
                cells[other] = std::move(*both);
                now[i] = other;
                found = true;
                break;
            }
        }
        gone[i] = 1;
        if (found) {
            ++result.merged;
        } else {
            ++result.left_out;
            result.left_out_m3 += volume_and_centre(cells[i]).volume_m3;
        }
    }
    for (std::uint32_t i = 0; i < cells.size(); ++i) {
        if (gone[i] == 0) {
            result.cells.push_back(std::move(cells[i]));
        }
    }
    return result;
}

}  // namespace rockfall::rock_mass
