#include "rockfall/motion/rigid/percussion.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace rockfall::rigid {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int whole_sweeps = 50;
/// A last step of the couple of rolling resistance may change the spin by this.
constexpr double still_radps = 1e-6;
constexpr int half_sweeps = 120;

Matrix3d cross_matrix(const Vector3d& v) {
    Matrix3d m;
    m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return m;
}

Matrix3d frame_of(const Vector3d& normal) {
    const Vector3d other = std::abs(normal.x()) < 0.7 ? Vector3d::UnitX() : Vector3d::UnitY();
    Matrix3d frame;
    frame.col(0) = normal;
    frame.col(1) = normal.cross(other).normalized();
    frame.col(2) = normal.cross(frame.col(1));
    return frame;
}

/// Impulse that brings the contact to rest, if it is within the cone of friction.
bool sticks(const Matrix3d& inverse, const Vector3d& free_mps, double shift_mps, double least_ns,
            double friction, Vector3d& impulse) {
    const Vector3d wanted = -(inverse * (free_mps + Vector3d{shift_mps, 0.0, 0.0}));
    if (wanted.x() < least_ns ||
        wanted.tail<2>().squaredNorm() > friction * friction * wanted.x() * wanted.x()) {
        return false;
    }
    impulse = wanted;
    return true;
}

/// Slip in direction d takes P_t = -mu P_n d, and P_n from the line of the normal; d is that of the slip
/// itself. Newton steps on the angle of d, from the present slip. False where they find none.
bool slips_by_angle(const Matrix3d& delassus, const Vector3d& free_mps, double shift_mps, double friction,
                    Vector3d& impulse) {
    const double normal_mps = free_mps.x() + shift_mps;
    const Eigen::Vector2d coupling = delassus.block<2, 1>(1, 0);
    const Eigen::Matrix2d tangential = delassus.bottomRightCorner<2, 2>();
    const Eigen::Vector2d slip_mps = free_mps.tail<2>() + delassus.bottomRows<2>() * impulse;
    const double speed_mps = slip_mps.norm();
    const double hold_ns = impulse.tail<2>().norm();
    Eigen::Vector2d d = hold_ns > 0.0     ? Eigen::Vector2d{-impulse.tail<2>() / hold_ns}
                        : speed_mps > 0.0 ? Eigen::Vector2d{slip_mps / speed_mps}
                                          : Eigen::Vector2d{1.0, 0.0};
    constexpr int most = 12;
    constexpr double still_rad = 1e-14;
    constexpr double rounding = 4e-16;
    for (int i = 0; i < most; ++i) {
        const Eigen::Vector2d across{-d.y(), d.x()};
        const double stiffness = delassus(0, 0) - friction * coupling.dot(d);
        if (stiffness <= 0.0) {
            return false;
        }
        const double normal_ns = -normal_mps / stiffness;
        const Eigen::Vector2d pull = coupling - friction * tangential * d;
        const Eigen::Vector2d moves_mps = free_mps.tail<2>() + normal_ns * pull;
        // The slip across d is sought to vanish; by the angle of d it changes as follows.
        const double off_mps = across.dot(moves_mps);
        const double normal_rate = normal_ns * friction * coupling.dot(across) / stiffness;
        const double rate = -d.dot(moves_mps) + across.dot(normal_rate * pull) -
                            normal_ns * friction * across.dot(tangential * across);
        if (rate == 0.0) {
            return false;
        }
        const double turn_rad = std::clamp(-off_mps / rate, -0.5, 0.5);
        // A contact that hardly slips: its direction is known no better than its slip is.
        const double rounding_mps = rounding * (free_mps.tail<2>().norm() + normal_ns * pull.norm());
        if (std::abs(turn_rad) <= still_rad || std::abs(off_mps) <= rounding_mps) {
            impulse << normal_ns, -friction * normal_ns * d;
            return d.dot(moves_mps) >= 0.0;
        }
        d = (d + turn_rad * across).normalized();
    }
    return false;
}

/// The same by proximal steps, which begin from the last impulse.
void slips_by_steps(const Matrix3d& delassus, const Vector3d& free_mps, double shift_mps, double least_ns,
                    double friction, Vector3d& impulse) {
    const double step_ns = 1.0 / (delassus(1, 1) + delassus(2, 2));
    constexpr int most = 60;
    constexpr double still = 1e-13;
    for (int i = 0; i < most; ++i) {
        const Vector3d before = impulse;
        const double rest_mps =
            free_mps.x() + shift_mps + delassus(0, 1) * impulse.y() + delassus(0, 2) * impulse.z();
        impulse.x() = std::max(least_ns, -rest_mps / delassus(0, 0));
        const Eigen::Vector2d slip_mps = free_mps.tail<2>() + delassus.bottomRows<2>() * impulse;
        Eigen::Vector2d along = impulse.tail<2>() - step_ns * slip_mps;
        const double most_ns = friction * impulse.x();
        const double size = along.norm();
        if (size > most_ns) {
            along *= most_ns / size;
        }
        impulse.tail<2>() = along;
        const double change = (impulse - before).norm();
        if (change <= still * (impulse.norm() + 1e-300)) {
            break;
        }
    }
}

void slips(const Matrix3d& delassus, const Vector3d& free_mps, double shift_mps, double least_ns,
           double friction, Vector3d& impulse) {
    const Vector3d before = impulse;
    if (least_ns == 0.0 && slips_by_angle(delassus, free_mps, shift_mps, friction, impulse) &&
        impulse.x() >= 0.0) {
        return;
    }
    impulse = before;
    slips_by_steps(delassus, free_mps, shift_mps, least_ns, friction, impulse);
}

}  // namespace

double PercussionSolver::normal_sum_ns() const {
    double sum = 0.0;
    for (const Percussion& percussion : percussions_) {
        sum += percussion.normal_ns;
    }
    return sum;
}

void PercussionSolver::build(const BlockMass& mass, const Velocities& before,
                             std::span<const PercussionPoint> points) {
    rows_.clear();
    for (const PercussionPoint& point : points) {
        Row row;
        row.arm_m = point.arm_m;
        row.frame = frame_of(point.normal);
        const Matrix3d arm = cross_matrix(point.arm_m) * row.frame;
        row.delassus =
            mass.inverse_mass_pkg * Matrix3d::Identity() + arm.transpose() * mass.inverse_inertia * arm;
        row.inverse = row.delassus.inverse();
        row.friction = point.friction;
        row.shift_mps = point.restitution * std::min(0.0, point.normal.dot(before.at(point.arm_m)));
        row.least_ns = 0.0;
        row.impulse = Vector3d::Zero();
        for (const Percussion& last : percussions_) {
            if (last.feature == point.feature) {
                row.impulse = row.frame.transpose() * last.impulse_ns;
            }
        }
        rows_.push_back(row);
    }
}

Velocities PercussionSolver::with_percussions(const BlockMass& mass, Velocities now) const {
    for (const Row& row : rows_) {
        const Vector3d impulse = row.frame * row.impulse;
        now.linear_mps += mass.inverse_mass_pkg * impulse;
        now.spin_radps += mass.inverse_inertia * row.arm_m.cross(impulse);
    }
    now.spin_radps += mass.inverse_inertia * couple_nms_;
    return now;
}

double PercussionSolver::sweep(const BlockMass& mass, Velocities& now, double share) {
    double change_mps = 0.0;
    for (Row& row : rows_) {
        const Vector3d velocity_mps = row.frame.transpose() * now.at(row.arm_m);
        const Vector3d free_mps = velocity_mps - row.delassus * row.impulse;
        Vector3d impulse = row.impulse;
        if (free_mps.x() + row.shift_mps >= 0.0 && row.least_ns == 0.0) {
            impulse.setZero();
        } else if (!sticks(row.inverse, free_mps, row.shift_mps, row.least_ns, row.friction, impulse)) {
            slips(row.delassus, free_mps, row.shift_mps, row.least_ns, row.friction, impulse);
        }
        const Vector3d more = impulse - row.impulse;
        change_mps = std::max(change_mps, (row.delassus * more).cwiseAbs().maxCoeff());
        const Vector3d taken = share * more;
        row.impulse += taken;
        const Vector3d more_ns = row.frame * taken;
        now.linear_mps += mass.inverse_mass_pkg * more_ns;
        now.spin_radps += mass.inverse_inertia * row.arm_m.cross(more_ns);
    }
    return change_mps;
}

double PercussionSolver::normal_sum_of_rows_ns() const {
    double sum = 0.0;
    for (const Row& row : rows_) {
        sum += row.impulse.x();
    }
    return sum;
}

/// A step of the couple of rolling resistance against the spin, at most to its bound. Gives by how much it
/// changes the spin.
double PercussionSolver::resist_rolling(const BlockMass& mass, double rolling_arm_m, Velocities& now) {
    const double step = 1.0 / mass.inverse_inertia.trace();
    Vector3d couple_nms = couple_nms_ - step * now.spin_radps;
    const double most_nms = rolling_arm_m * normal_sum_of_rows_ns();
    if (const double size = couple_nms.norm(); size > most_nms) {
        couple_nms *= most_nms / size;
    }
    const Vector3d change_radps = mass.inverse_inertia * (couple_nms - couple_nms_);
    couple_nms_ = couple_nms;
    now.spin_radps += change_radps;
    return change_radps.norm();
}

/// All contacts and the couple as one system; keeps what there is where that finds no end.
void PercussionSolver::solve_all_at_once(const BlockMass& mass, const Velocities& without,
                                         double rolling_arm_m, Velocities& now) {
    const int contacts = static_cast<int>(rows_.size());
    if (contacts > JointProblem::most_contacts) {
        return;
    }
    joint_.contacts = contacts;
    joint_.has_couple = rolling_arm_m > 0.0;
    joint_.rolling_arm_m = rolling_arm_m;
    JointProblem::Vector all{};
    std::array<Matrix3d, JointProblem::most_contacts + 1> turns, inertia_turns;
    const auto put = [&](int row, int column, const Matrix3d& block) {
        for (int k = 0; k < 3; ++k) {
            for (int l = 0; l < 3; ++l) {
                joint_.delassus[row + k][column + l] = block(k, l);
                joint_.delassus[column + l][row + k] = block(k, l);
            }
        }
    };
    const auto put_vector = [](JointProblem::Vector& into, int row, const Vector3d& v) {
        for (int k = 0; k < 3; ++k) {
            into[row + k] = v[k];
        }
    };
    for (int i = 0; i < contacts; ++i) {
        const Row& row = rows_[i];
        turns[i] = cross_matrix(row.arm_m) * row.frame;
        inertia_turns[i] = mass.inverse_inertia * turns[i];
        for (int j = 0; j < i; ++j) {
            put(3 * i, 3 * j,
                mass.inverse_mass_pkg * row.frame.transpose() * rows_[j].frame +
                    turns[i].transpose() * inertia_turns[j]);
        }
        put(3 * i, 3 * i, row.delassus);
        put_vector(joint_.free, 3 * i, row.frame.transpose() * without.at(row.arm_m));
        put_vector(all, 3 * i, row.impulse);
        joint_.friction[i] = row.friction;
        joint_.shift_mps[i] = row.shift_mps;
        joint_.least_ns[i] = row.least_ns;
        if (joint_.has_couple) {
            put(3 * contacts, 3 * i, inertia_turns[i]);
        }
    }
    if (joint_.has_couple) {
        put(3 * contacts, 3 * contacts, mass.inverse_inertia);
        put_vector(joint_.free, 3 * contacts, without.spin_radps);
        put_vector(all, 3 * contacts, couple_nms_);
    }
    if (!solve_jointly(joint_, 0.1 * law_.tolerance_mps, all)) {
        return;
    }
    for (int i = 0; i < contacts; ++i) {
        rows_[i].impulse = Vector3d{all[3 * i], all[3 * i + 1], all[3 * i + 2]};
    }
    if (joint_.has_couple) {
        couple_nms_ = Vector3d{all[3 * contacts], all[3 * contacts + 1], all[3 * contacts + 2]};
    }
    now = with_percussions(mass, without);
}

bool PercussionSolver::settle(const BlockMass& mass, const Velocities& without, double rolling_arm_m,
                              Velocities& now) {
    const bool is_direct = rows_.size() == 1 && rolling_arm_m <= 0.0;
    now = with_percussions(mass, without);
    for (int done = 1; done <= law_.most_sweeps; ++done) {
        // Contacts that keep changing between sticking and slipping take a part of each step only.
        const double share = done < whole_sweeps ? 1.0 : done < half_sweeps ? 0.5 : 0.25;
        const double change_mps = sweep(mass, now, share);
        const double change_radps = rolling_arm_m > 0.0 ? resist_rolling(mass, rolling_arm_m, now) : 0.0;
        if (is_direct || (change_mps <= law_.tolerance_mps && change_radps <= still_radps)) {
            return true;
        }
        if (std::has_single_bit(static_cast<unsigned>(done + 1))) {
            solve_all_at_once(mass, without, rolling_arm_m, now);
        }
    }
    // Whatever is left unsolved, each percussion obeys the law of its contact.
    sweep(mass, now, 1.0);
    return false;
}

Velocities PercussionSolver::run(const BlockMass& mass, const Velocities& before, const Vector3d& kick_mps,
                                 std::span<const PercussionPoint> points, double rolling_arm_m,
                                 double restitution_share, bool& converged) {
    build(mass, before, points);
    couple_nms_.setZero();
    const bool poisson = law_.impact == ImpactLaw::poisson;
    for (Row& row : rows_) {
        row.shift_mps *= poisson ? 0.0 : restitution_share;
    }
    Velocities now;
    converged = settle(mass, {before.linear_mps + kick_mps, before.spin_radps}, rolling_arm_m, now);
    if (!poisson) {
        return now;
    }
    // Decompression: what compression stored at each contact comes back, and no contact may close.
    const std::vector<Row> compression = rows_;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const double e = points[i].normal.dot(before.at(points[i].arm_m)) < 0.0 ? points[i].restitution : 0.0;
        rows_[i].least_ns = restitution_share * e * compression[i].impulse.x();
        rows_[i].impulse.setZero();
    }
    const Vector3d couple_nms = couple_nms_;
    couple_nms_.setZero();
    converged = settle(mass, Velocities{now}, rolling_arm_m, now) && converged;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        rows_[i].impulse += compression[i].impulse;
    }
    couple_nms_ += couple_nms;
    return now;
}

PercussionResult PercussionSolver::result(const Velocities& before, const Velocities& after) const {
    PercussionResult result;
    result.after = after;
    for (const Row& row : rows_) {
        const Vector3d mean_mps = 0.5 * row.frame.transpose() * (before.at(row.arm_m) + after.at(row.arm_m));
        result.normal_work_j += mean_mps.x() * row.impulse.x();
        result.tangential_work_j += mean_mps.tail<2>().dot(row.impulse.tail<2>());
    }
    result.rolling_work_j = 0.5 * (before.spin_radps + after.spin_radps).dot(couple_nms_);
    return result;
}

/// What the percussions of a solution can add at most (class comment), with the tolerances of the solution:
/// each velocity and the spin are known no better.
double PercussionSolver::most_work_j(const BlockMass& mass, const Velocities& before,
                                     const Vector3d& kick_mps) const {
    constexpr double rounding = 1e-12;
    double sum_ns = 0.0;
    for (const Row& row : rows_) {
        sum_ns += row.impulse.lpNorm<1>();
    }
    const double kinetic_j = 0.5 * before.linear_mps.squaredNorm() / mass.inverse_mass_pkg;
    return kick_mps.squaredNorm() / (8.0 * mass.inverse_mass_pkg) + rounding * kinetic_j +
           law_.tolerance_mps * sum_ns + still_radps * couple_nms_.norm();
}

/// The work of percussions scaled by s is s a + s^2 b / 2, with b the work that they do on what they change:
/// takes the largest share that does the work allowed.
void PercussionSolver::scale_down(const Velocities& before, const Vector3d& kick_mps, double most_j,
                                  PercussionResult& done) {
    const Velocities without{before.linear_mps + kick_mps, before.spin_radps};
    const double change_j = result(without, done.after).work_j() - result(without, without).work_j();
    const double b_j = 2.0 * change_j;
    const double a_j = done.work_j() - change_j;
    const double root_j = std::sqrt(a_j * a_j + 2.0 * std::max(0.0, b_j) * most_j);
    const double share = a_j < 0.0      ? (root_j - a_j) / b_j
                         : root_j > 0.0 ? 2.0 * most_j / (a_j + root_j)
                                        : 0.0;
    for (Row& row : rows_) {
        row.impulse *= share;
    }
    couple_nms_ *= share;
    const Velocities after{without.linear_mps + share * (done.after.linear_mps - without.linear_mps),
                           without.spin_radps + share * (done.after.spin_radps - without.spin_radps)};
    done = result(before, after);
    done.converged = false;
}

PercussionResult PercussionSolver::solve(const BlockMass& mass, const Velocities& before,
                                         const Vector3d& kick_mps, std::span<const PercussionPoint> points,
                                         double rolling_arm_m) {
    constexpr int most_halvings = 6;
    PercussionResult done;
    for (int halved = 0; halved <= most_halvings; ++halved) {
        const double share = halved == most_halvings ? 0.0 : 1.0 / (1 << halved);
        bool converged = true;
        const Velocities after = run(mass, before, kick_mps, points, rolling_arm_m, share, converged);
        done = result(before, after);
        done.converged = converged;
        const bool rebounds = std::any_of(points.begin(), points.end(), [](const PercussionPoint& point) {
            return point.restitution > 0.0;
        });
        if (!rebounds || done.work_j() <= most_work_j(mass, before, kick_mps)) {
            break;
        }
    }
    if (const double most_j = most_work_j(mass, before, kick_mps); done.work_j() > most_j) {
        scale_down(before, kick_mps, most_j, done);
        assert(done.work_j() <= most_j * (1.0 + 1e-6));
    }
    percussions_.resize(rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        percussions_[i] = {rows_[i].frame * rows_[i].impulse, rows_[i].impulse.x(), points[i].feature};
    }
    return done;
}

}  // namespace rockfall::rigid
