#include "tests/rockfall/terrain/cgal_oracle.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace rockfall {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;

}  // namespace

struct CgalOracle::Mesh {
    Delaunay delaunay;
};

CgalOracle::CgalOracle(const Terrain& terrain) : mesh_{std::make_unique<Mesh>()} {
    std::vector<std::pair<Kernel::Point_2, std::uint32_t>> points;
    for (const Vertex& vertex : terrain.vertices()) {
        points.emplace_back(Kernel::Point_2{vertex.x_m, vertex.y_m},
                            static_cast<std::uint32_t>(points.size()));
    }
    mesh_->delaunay.insert(points.begin(), points.end());
}

CgalOracle::~CgalOracle() = default;

CgalOracle::Found CgalOracle::locate(double x_m, double y_m) const {
    Delaunay::Locate_type type{};
    int index = 0;
    const Delaunay::Face_handle face = mesh_->delaunay.locate({x_m, y_m}, type, index);
    if (type == Delaunay::OUTSIDE_CONVEX_HULL) {
        return {Found::Kind::outside};
    }
    if (type != Delaunay::FACE) {
        return {Found::Kind::edge_or_corner};
    }
    std::array<std::uint32_t, 3> corners = {face->vertex(0)->info(), face->vertex(1)->info(),
                                            face->vertex(2)->info()};
    std::sort(corners.begin(), corners.end());
    return {Found::Kind::triangle, corners};
}

}  // namespace rockfall
