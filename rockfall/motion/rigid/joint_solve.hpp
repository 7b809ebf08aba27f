#pragma once

#include <array>

namespace rockfall::rigid {

/// The percussions of a few contacts and the couple of rolling resistance as one system of equations.
///
/// Unknowns z: normal and two tangential percussions of each contact, then the couple, if there is one.
/// Velocities are free + delassus z; those of the couple are the spin. Laws: P_n >= least_ns complementary to
/// U_n + shift >= 0; |P_t| <= mu P_n opposite to U_t; |C| <= rolling_arm_m sum P_n opposite to the spin.
struct JointProblem {
    static constexpr int most_contacts = 4;
    static constexpr int most_unknowns = 3 * most_contacts + 3;
    using Vector = std::array<double, most_unknowns>;

    int contacts = 0;
    bool has_couple = false;
    double rolling_arm_m = 0.0;
    std::array<Vector, most_unknowns> delassus;  ///< symmetric
    Vector free;                                 ///< velocities without percussions
    std::array<double, most_contacts> friction;
    std::array<double, most_contacts> shift_mps;
    std::array<double, most_contacts> least_ns;

    [[nodiscard]] int unknowns() const { return 3 * contacts + (has_couple ? 3 : 0); }
};

/// Solves all laws at once by Newton's method on their projections (Alart & Curnier 1991, Comput. Methods
/// Appl. Mech. Eng. 92:353): exact in one step where contacts keep sticking, slipping or parting, quadratic
/// where slip turns. Contacts that hold more than a rigid block needs leave the percussions undetermined;
/// a proximal term keeps near those at the start.
///
/// True where the steps came to an end. Whoever calls checks the laws themselves.
bool solve_jointly(const JointProblem& problem, double tolerance_mps, JointProblem::Vector& z);

}  // namespace rockfall::rigid
