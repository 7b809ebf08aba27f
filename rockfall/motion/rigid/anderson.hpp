#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>

namespace rockfall::rigid {

/// Anderson's mixing of a fixed-point iteration z <- g(z) (Walker & Ni 2011, SIAM J. Numer. Anal. 49:1715).
///
/// The next z is the combination of the last g(z) whose combination of residuals g(z) - z is smallest. Where
/// the iteration is linear, as that of contacts that keep sticking or slipping, a few steps end it; the fixed
/// points stay the same, so whoever iterates still decides by a plain step when it is done.
class AndersonMixing {
public:
    static constexpr int depth = 5;
    static constexpr int most_unknowns = 27;
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_unknowns, 1>;

    /// Forgets the steps taken so far.
    void begin() { steps_ = 0; }

    /// Takes a step from z to g(z). True: `mixed` is where to go on from, else that is g(z).
    bool take(const Vector& from, const Vector& to, Vector& mixed) {
        const Vector residual = to - from;
        if (steps_ > 0) {
            const int column = (steps_ - 1) % depth;
            residual_changes_.conservativeResize(to.size(), depth);
            changes_.conservativeResize(to.size(), depth);
            residual_changes_.col(column) = residual - last_residual_;
            changes_.col(column) = to - last_;
        }
        last_residual_ = residual;
        last_ = to;
        ++steps_;
        const int known = std::min(steps_ - 1, depth);
        if (known < 2) {
            return false;
        }
        // Changes of very different size: each counts by its direction.
        const Column sizes = residual_changes_.leftCols(known).colwise().norm().cwiseMax(1e-300);
        const auto unit = residual_changes_.leftCols(known) * sizes.cwiseInverse().asDiagonal();
        Square normal = unit.transpose() * unit;
        constexpr double regular = 1e-12;
        normal.diagonal().array() += regular;
        const Column share = normal.ldlt().solve(unit.transpose() * residual).cwiseQuotient(sizes);
        Vector way = -changes_.leftCols(known) * share;
        // Farther than this the steps were not those of one linear iteration.
        constexpr double farthest = 300.0;
        const double length = way.norm(), most = farthest * residual.norm();
        if (!(length < 1e300)) {
            return false;
        }
        if (length > most) {
            way *= most / length;
        }
        mixed = to + way;
        return true;
    }

private:
    using History = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_unknowns, depth>;
    using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, depth, depth>;
    using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, depth, 1>;
    int steps_ = 0;
    History residual_changes_;
    History changes_;
    Vector last_residual_;
    Vector last_;
};

}  // namespace rockfall::rigid
