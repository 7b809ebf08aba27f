#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "rockfall/motion/rigid/joint_solve.hpp"

namespace rockfall::rigid {

/// A contact as the impact law sees it.
struct PercussionPoint {
    Eigen::Vector3d arm_m;      ///< from the centroid to the contact
    Eigen::Vector3d normal;     ///< unit, from the ground to the block
    double friction;            ///< Coulomb [-]
    double restitution;         ///< of the normal velocity [-], [0, 1]
    std::uint32_t feature = 0;  ///< of the block: percussions of the last step begin those of the next
};

/// What the solver gives for one contact.
struct Percussion {
    Eigen::Vector3d impulse_ns = Eigen::Vector3d::Zero();  ///< on the block
    double normal_ns = 0.0;
    std::uint32_t feature = 0;
};

/// Velocity of the centroid and spin in the axes of space.
struct Velocities {
    Eigen::Vector3d linear_mps;
    Eigen::Vector3d spin_radps;

    [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& arm_m) const {
        return linear_mps + spin_radps.cross(arm_m);
    }
};

/// Mass of a block where it is.
struct BlockMass {
    double inverse_mass_pkg;
    Eigen::Matrix3d inverse_inertia;  ///< in the axes of space [1/(kg m2)]
};

/// Which hypothesis restitution follows where several points touch.
enum class ImpactLaw : std::uint8_t {
    newton,   ///< velocities: U_n+ >= -e U_n- at each contact
    poisson,  ///< percussions: those of decompression are e times those of compression
};

struct SolverLaw {
    ImpactLaw impact = ImpactLaw::newton;
    double tolerance_mps = 1e-10;
    int most_sweeps = 200;
};

/// What a percussion did.
struct PercussionResult {
    Velocities after;
    double normal_work_j = 0.0;      ///< of the percussions along the normals: (U+ + U-) / 2 . P, <= 0
    double tangential_work_j = 0.0;  ///< along the ground
    double rolling_work_j = 0.0;     ///< of rolling resistance
    bool converged = true;

    [[nodiscard]] double work_j() const { return normal_work_j + tangential_work_j + rolling_work_j; }
};

/// Percussions of rigid contact with Coulomb friction and restitution (Leine et al. 2014; Moreau 1988).
///
/// 0 <= U_n+ + e U_n-  complementary to  P_n >= 0;  |P_t| <= mu P_n, opposite to U_t+ where it slides. Solved
/// by proximal-point Gauss-Seidel over the contacts, each with its 3 x 3 Delassus block, until no velocity
/// changes by more than the tolerance. Rolling resistance is one more percussion: a couple of at most
/// `rolling_arm_m` times the sum of all P_n, opposite to the spin.
///
/// `kick` is what acts besides in the same step (gravity times its duration), after which the percussions are
/// sought; energies count from `before` to the result.
///
/// No percussion adds energy. Without restitution that follows from the laws: with P . U+ <= 0 the change of
/// velocity q and the kick k give the work q M U+ - q M (k + q) / 2 <= k M k / 8, which is 0 of an impact
/// (k = 0). Newton's restitution with friction can raise the energy (Kane & Levinson 1985); then all e are
/// halved until it does not. Percussions that are no solution are scaled down along their segment until they
/// obey the same bound [choice], and count as not converged.
class PercussionSolver {
public:
    explicit PercussionSolver(const SolverLaw& law) : law_{law} {}

    PercussionResult solve(const BlockMass& mass, const Velocities& before, const Eigen::Vector3d& kick_mps,
                           std::span<const PercussionPoint> points, double rolling_arm_m);

    /// Those of the last call, contact by contact.
    [[nodiscard]] std::span<const Percussion> percussions() const { return percussions_; }
    [[nodiscard]] double normal_sum_ns() const;
    void forget() { percussions_.clear(); }

private:
    struct Row {
        Eigen::Vector3d arm_m;
        Eigen::Matrix3d frame;     ///< columns: normal and two tangents
        Eigen::Matrix3d delassus;  ///< in the frame
        Eigen::Matrix3d inverse;   ///< of the Delassus block
        Eigen::Vector3d impulse;   ///< in the frame
        double friction;
        double shift_mps;  ///< e U_n-, <= 0
        double least_ns;   ///< smallest normal percussion: of the decompression of Poisson's law
    };
    void build(const BlockMass& mass, const Velocities& before, std::span<const PercussionPoint> points);
    bool settle(const BlockMass& mass, const Velocities& without, double rolling_arm_m, Velocities& now);
    double resist_rolling(const BlockMass& mass, double rolling_arm_m, Velocities& now);
    void solve_all_at_once(const BlockMass& mass, const Velocities& without, double rolling_arm_m,
                           Velocities& now);
    double sweep(const BlockMass& mass, Velocities& now, double share);
    [[nodiscard]] double normal_sum_of_rows_ns() const;
    [[nodiscard]] Velocities with_percussions(const BlockMass& mass, Velocities now) const;
    PercussionResult result(const Velocities& before, const Velocities& after) const;
    [[nodiscard]] double most_work_j(const BlockMass& mass, const Velocities& before,
                                     const Eigen::Vector3d& kick_mps) const;
    void scale_down(const Velocities& before, const Eigen::Vector3d& kick_mps, double most_j,
                    PercussionResult& done);
    Velocities run(const BlockMass& mass, const Velocities& before, const Eigen::Vector3d& kick_mps,
                   std::span<const PercussionPoint> points, double rolling_arm_m, double restitution_share,
                   bool& converged);

    SolverLaw law_;
    std::vector<Row> rows_;
    Eigen::Vector3d couple_nms_ = Eigen::Vector3d::Zero();
    JointProblem joint_;
    std::vector<Percussion> percussions_;
};

}  // namespace rockfall::rigid
