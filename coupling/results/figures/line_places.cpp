#include "coupling/results/figures/line_places.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace coupling {

LinePlaces::LinePlaces(const rockfall::Target& target) {
    for (const std::vector<Eigen::Vector2d>& part : target.parts) {
        for (std::size_t i = 0; i + 1 < part.size(); ++i) {
            const double piece_m = (part[i + 1] - part[i]).norm();
            if (piece_m > 0.0) {
                pieces_.push_back({part[i], part[i + 1], length_m_, piece_m});
                length_m_ += piece_m;
            }
        }
    }
}

double LinePlaces::distance_of(const Eigen::Vector2d& place_m) const {
    double nearest = std::numeric_limits<double>::infinity();
    double found_m = 0.0;
    for (const Piece& piece : pieces_) {
        const Eigen::Vector2d along = (piece.to_m - piece.from_m) / piece.length_m;
        const double on_m = std::clamp(along.dot(place_m - piece.from_m), 0.0, piece.length_m);
        const double away = (place_m - piece.from_m - on_m * along).squaredNorm();
        if (away < nearest) {
            nearest = away;
            found_m = piece.begin_m + on_m;
        }
    }
    return found_m;
}

Eigen::Vector2d LinePlaces::at(double distance_m) const {
    assert(!pieces_.empty());
    const auto after = std::find_if(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
        return distance_m <= piece.begin_m + piece.length_m;
    });
    const Piece& piece = after == pieces_.end() ? pieces_.back() : *after;
    const double share = std::clamp((distance_m - piece.begin_m) / piece.length_m, 0.0, 1.0);
    return piece.from_m + share * (piece.to_m - piece.from_m);
}

}  // namespace coupling
