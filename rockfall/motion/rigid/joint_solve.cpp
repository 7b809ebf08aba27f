#include "rockfall/motion/rigid/joint_solve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rockfall::rigid {
namespace {

using Vector = JointProblem::Vector;

/// Equations of one Newton step: rows of the Jacobian with their right sides, all in units of percussions.
struct Equations {
    std::array<Vector, JointProblem::most_unknowns> rows;
    Vector right;
    int count = 0;

    /// By elimination with pivots of rows. False where no pivot is left.
    bool eliminate(Vector& step) {
        for (int k = 0; k < count; ++k) {
            int best = k;
            for (int i = k + 1; i < count; ++i) {
                best = std::abs(rows[i][k]) > std::abs(rows[best][k]) ? i : best;
            }
            if (!(std::abs(rows[best][k]) > 0.0)) {
                return false;
            }
            std::swap(rows[best], rows[k]);
            std::swap(right[best], right[k]);
            const double inverse = 1.0 / rows[k][k];
            for (int i = k + 1; i < count; ++i) {
                const double factor = rows[i][k] * inverse;
                if (factor == 0.0) {
                    continue;
                }
                for (int j = k + 1; j < count; ++j) {
                    rows[i][j] -= factor * rows[k][j];
                }
                right[i] -= factor * right[k];
            }
        }
        for (int k = count - 1; k >= 0; --k) {
            double rest = right[k];
            for (int j = k + 1; j < count; ++j) {
                rest -= rows[k][j] * step[j];
            }
            step[k] = rest / rows[k][k];
        }
        return true;
    }
};

/// Share of the diagonal that the proximal term adds to rows of velocities: percussions that hold against
/// each other grow until one of them slips.
constexpr double proximal = 1e-9;

/// Newton's method on one joint problem.
class JointNewton {
public:
    JointNewton(const JointProblem& problem, Vector& z) : problem_{problem}, z_{z} {}

    bool run(double tolerance_mps) {
        constexpr int most_steps = 20;
        for (int step = 0; step < most_steps; ++step) {
            find_velocities();
            equations_.count = problem_.unknowns();
            off_mps_ = 0.0;
            for (int i = 0; i < problem_.contacts; ++i) {
                normal_row(i);
                cone_rows(3 * i + 1, 2, problem_.friction[i], {3 * i, 1});
            }
            if (problem_.has_couple) {
                cone_rows(3 * problem_.contacts, 3, problem_.rolling_arm_m, {0, problem_.contacts});
            }
            if (off_mps_ <= tolerance_mps) {
                return true;
            }
            Vector way;
            if (!equations_.eliminate(way)) {
                return false;
            }
            const double share = until_first_parts(way);
            for (int k = 0; k < equations_.count; ++k) {
                z_[k] += share * way[k];
            }
        }
        return false;
    }

private:
    /// Normal percussions whose sum a cone's bound grows with: every third from the first on.
    struct Normals {
        int first;
        int count;
    };

    /// Share of a step after which the first contact no longer presses. Four contacts with nearly one normal
    /// leave percussions nearly undetermined, and a whole step would part more of them than do part.
    [[nodiscard]] double until_first_parts(const Vector& way) const {
        double share = 1.0;
        for (int i = 0; i < problem_.contacts; ++i) {
            const double spare_ns = z_[3 * i] - problem_.least_ns[i];
            if (spare_ns > 0.0 && spare_ns + way[3 * i] < 0.0) {
                share = std::min(share, -spare_ns / way[3 * i]);
            }
        }
        return share;
    }

    void find_velocities() {
        const int count = problem_.unknowns();
        for (int i = 0; i < count; ++i) {
            double sum = problem_.free[i];
            for (int j = 0; j < count; ++j) {
                sum += problem_.delassus[i][j] * z_[j];
            }
            velocity_[i] = sum;
        }
    }

    /// velocity + shift = 0.
    void velocity_row(int row, double shift) {
        const double mass = 1.0 / problem_.delassus[row][row];
        for (int j = 0; j < equations_.count; ++j) {
            equations_.rows[row][j] = mass * problem_.delassus[row][j];
        }
        equations_.rows[row][row] += proximal;
        equations_.right[row] = -mass * (velocity_[row] + shift);
        off_mps_ = std::max(off_mps_, std::abs(velocity_[row] + shift));
    }

    void unit_row(int row, double right_ns) {
        std::fill_n(equations_.rows[row].begin(), equations_.count, 0.0);
        equations_.rows[row][row] = 1.0;
        equations_.right[row] = right_ns;
    }

    void normal_row(int contact) {
        const int row = 3 * contact;
        const double shift = problem_.shift_mps[contact];
        const double least_ns = problem_.least_ns[contact];
        const double pressed_ns = z_[row] - (velocity_[row] + shift) / problem_.delassus[row][row];
        if (pressed_ns > least_ns) {
            velocity_row(row, shift);
        } else {
            unit_row(row, least_ns - z_[row]);
            off_mps_ = std::max(off_mps_, std::abs(least_ns - z_[row]) * problem_.delassus[row][row]);
        }
    }

    /// |P| <= factor * sum of normals, opposite to its velocity; `size` rows from `first` on.
    void cone_rows(int first, int size, double factor, const Normals& normals) {
        double trace = 0.0, normal_ns = 0.0;
        for (int k = first; k < first + size; ++k) {
            trace += problem_.delassus[k][k];
        }
        for (int i = 0; i < normals.count; ++i) {
            normal_ns += z_[normals.first + 3 * i];
        }
        const double step = 1.0 / trace;
        const double most_ns = factor * std::max(0.0, normal_ns);
        std::array<double, 3> way{};
        double squared = 0.0;
        for (int k = 0; k < size; ++k) {
            way[k] = z_[first + k] - step * velocity_[first + k];
            squared += way[k] * way[k];
        }
        if (squared <= most_ns * most_ns && most_ns > 0.0) {
            for (int k = 0; k < size; ++k) {
                velocity_row(first + k, 0.0);
            }
            return;
        }
        const double length = std::sqrt(squared);
        const double inverse = length > 0.0 ? 1.0 / length : 0.0;
        const double turn = most_ns * inverse;
        for (int k = 0; k < size; ++k) {
            way[k] *= inverse;
        }
        for (int k = 0; k < size; ++k) {
            const double off_ns = z_[first + k] - most_ns * way[k];
            unit_row(first + k, -off_ns);
            off_mps_ = std::max(off_mps_, std::abs(off_ns) * trace);
        }
        for (int k = 0; k < size; ++k) {
            for (int i = 0; i < normals.count; ++i) {
                equations_.rows[first + k][normals.first + 3 * i] -= factor * way[k];
            }
            // The direction turns with percussion and velocity across it.
            for (int l = 0; l < size; ++l) {
                const double across = turn * ((k == l ? 1.0 : 0.0) - way[k] * way[l]);
                equations_.rows[first + k][first + l] -= across;
                for (int j = 0; j < equations_.count; ++j) {
                    equations_.rows[first + k][j] += across * step * problem_.delassus[first + l][j];
                }
            }
        }
    }

    const JointProblem& problem_;
    Vector& z_;
    Vector velocity_{};
    Equations equations_{};
    double off_mps_ = 0.0;  ///< largest residual, as a velocity
};

}  // namespace

bool solve_jointly(const JointProblem& problem, double tolerance_mps, Vector& z) {
    return JointNewton{problem, z}.run(tolerance_mps);
}

}  // namespace rockfall::rigid
