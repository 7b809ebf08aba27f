#include "rockfall/terrain/joining.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "rockfall/terrain/upright.hpp"

namespace rockfall {

void join_vertices(Tin& tin, TinChanges& changes) {
    const auto place = [&](std::uint32_t i) {
        const Eigen::Vector3d& v = tin.vertices_m[i];
        return std::tuple{v.x(), v.y(), v.z()};
    };
    std::vector<std::uint32_t> order(tin.vertices_m.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
    std::vector<std::uint32_t> kept(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool again = i > 0 && place(order[i]) == place(order[i - 1]);
        kept[order[i]] = again ? kept[order[i - 1]] : order[i];
        changes.joined += again ? 1 : 0;
    }
    for (TinFace& face : tin.faces) {
        for (std::uint32_t& corner : face.corners) {
            corner = kept[corner];
        }
    }
    changes.left_out = std::erase_if(tin.faces, [](const TinFace& face) {
        const auto& [a, b, c] = face.corners;
        return a == b || b == c || c == a;
    });
}

void drop_unused_vertices(Tin& tin) {
    std::vector<std::uint32_t> place(tin.vertices_m.size(), no_triangle);
    std::vector<Eigen::Vector3d> used;
    for (TinFace& face : tin.faces) {
        for (std::uint32_t& corner : face.corners) {
            if (place[corner] == no_triangle) {
                place[corner] = static_cast<std::uint32_t>(used.size());
                used.push_back(tin.vertices_m[corner]);
            }
            corner = place[corner];
        }
    }
    tin.vertices_m = std::move(used);
}

void turn_over_if_all_look_down(Tin& tin, TinChanges& changes) {
    double sum_m2 = 0.0;
    for (const TinFace& face : tin.faces) {
        sum_m2 += area2_of(tin, face).z();
    }
    changes.turned_over = sum_m2 < 0.0;
    if (changes.turned_over) {
        for (TinFace& face : tin.faces) {
            std::swap(face.corners[1], face.corners[2]);
        }
    }
}

}  // namespace rockfall
