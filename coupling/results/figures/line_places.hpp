#pragma once

#include <Eigen/Core>
#include <vector>

#include "rockfall/tally/target.hpp"

namespace coupling {

/// Distances along the parts of a line, one part after the other, in plan.
class LinePlaces {
public:
    explicit LinePlaces(const rockfall::Target& target);

    [[nodiscard]] double length_m() const { return length_m_; }
    /// Distance along the line of its point nearest to a place.
    [[nodiscard]] double distance_of(const Eigen::Vector2d& place_m) const;
    /// The point at a distance along the line. Requires a line with a length.
    [[nodiscard]] Eigen::Vector2d at(double distance_m) const;

private:
    struct Piece {
        Eigen::Vector2d from_m;
        Eigen::Vector2d to_m;
        double begin_m;  ///< distance along the line where it begins
        double length_m;
    };
    std::vector<Piece> pieces_;
    double length_m_ = 0.0;
};

}  // namespace coupling
