#include "rockfall/release/elongation.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "config/math/elementary.hpp"
#include "rockfall/solids/block_shape.hpp"

namespace rockfall {
namespace {

/// Extents along the given axes: those of the sides as they were written.
double elongation_of(const BlockShape& shape) {
    if (!shape.hull) {
        return 1.0;
    }
    Eigen::Vector3d low_m = shape.hull->vertices_m.front();
    Eigen::Vector3d high_m = low_m;
    for (const Eigen::Vector3d& vertex_m : shape.hull->vertices_m) {
        low_m = low_m.cwiseMin(vertex_m);
        high_m = high_m.cwiseMax(vertex_m);
    }
    const Eigen::Vector3d sides_m = high_m - low_m;
    return sides_m.maxCoeff() / sides_m.minCoeff();
}

}  // namespace

ElongationLaw::ElongationLaw() : ElongationLaw{usual_elongation, usual_elongation_scatter} {}

ElongationLaw::ElongationLaw(double median, double log_deviation)
    : medians_(1, std::pair{1.0, median}), log_deviation_{log_deviation} {}

ElongationLaw::ElongationLaw(const ShapeLaw& shapes)
    // A side that is uniform within a share s of itself scatters by s / sqrt 3; two sides make the ratio.
    : log_deviation_{std::sqrt(2.0 / 3.0) * shapes.sides_scatter()} {
    medians_.clear();
    double sum = 0.0;
    for (const BlockShape& shape : shapes.shapes()) {
        sum += shape.share;
        medians_.emplace_back(sum, elongation_of(shape));
    }
    for (auto& [share, median] : medians_) {
        share /= sum;
    }
}

double ElongationLaw::at(double u, double z) const {
    const auto chosen = std::find_if(medians_.begin(), medians_.end() - 1,
                                     [&](const auto& shape) { return u < shape.first; });
    return std::max(1.0, chosen->second * config::exp_of(log_deviation_ * z));
}

}  // namespace rockfall
