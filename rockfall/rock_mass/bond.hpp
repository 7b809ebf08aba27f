#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "rockfall/rock_mass/contact.hpp"
#include "rockfall/rock_mass/laws.hpp"

namespace rockfall::rock_mass {

/// The section of a bond: integrals over the polygon that two blocks share, about its middle, in the axes of
/// the bond: two principal axes of the polygon, then its normal.
struct BondSection {
    double area_m2 = 0.0;
    double about_first_m4 = 0.0;   ///< integral of y^2 dA
    double about_second_m4 = 0.0;  ///< integral of x^2 dA
    double reach_m = 0.0;          ///< of the corner farthest from the middle
    std::vector<Eigen::Vector2d> corners_m;

    [[nodiscard]] double polar_m4() const { return about_first_m4 + about_second_m4; }
};

/// A section with its place and axes in space.
struct PlacedSection {
    BondSection section;
    Eigen::Vector3d middle_m;
    Eigen::Quaterniond axes;  ///< turns vectors of the bond's axes into space
};

/// Requires a plane convex polygon with an area and its unit normal; corners in either direction.
PlacedSection section_of(std::span<const Eigen::Vector3d> corners_m, const Eigen::Vector3d& normal);

/// The same area as a disc of the given radius: as PFC's parallel bonds.
BondSection disc_section(double radius_m);

/// Strength of a bond [Pa].
struct BondStrength {
    double tensile_pa = 0.0;
    double shear_pa = 0.0;  ///< without pressure
};

/// How far a bond is strained, in its axes.
struct BondStrain {
    Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();  ///< z: opening
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();     ///< twice the sines of half the angles
};

/// Stiffness of a bond by area, and its section.
struct BondStiffness {
    double normal_npm3 = 0.0;
    double shear_npm3 = 0.0;
};

/// Force and moment with which a strained bond resists, in its axes: F_n = k_n A u_n, F_s = k_s A u_s,
/// M_t = k_s J theta_t, M_b = k_n I theta_b (Potyondy & Cundall 2004, Int. J. Rock Mech. Min. Sci. 41:1329),
/// from the total strain.
struct BondLoad {
    Eigen::Vector3d force_n;
    Eigen::Vector3d moment_nm;
};
BondLoad bond_load(const BondSection& section, const BondStiffness& stiffness, const BondStrain& strain);

/// Largest stresses in the section: F_n / A + M_b R / I, exact at its corners (tension > 0), and
/// F_s / A + |M_t| R / J.
struct BondStress {
    double tension_pa;
    double shear_pa;
    double pressure_pa;  ///< mean over the section, >= 0
};
BondStress bond_stress(const BondSection& section, const BondStiffness& stiffness, const BondStrain& strain);

/// Whether the bond breaks: tension beyond its strength, or shear beyond c + sigma tan(phi).
bool breaks(const BondStress& stress, const BondStrength& strength, double angle_tan);

/// Energy of a strained bond by its parts [J].
struct BondEnergy {
    double normal_j = 0.0;
    double shear_j = 0.0;
    double bending_j = 0.0;
    double twist_j = 0.0;
    [[nodiscard]] double sum_j() const { return normal_j + shear_j + bending_j + twist_j; }
    void operator+=(const BondEnergy& other) {
        normal_j += other.normal_j;
        shear_j += other.shear_j;
        bending_j += other.bending_j;
        twist_j += other.twist_j;
    }
};
BondEnergy bond_energy(const BondSection& section, const BondStiffness& stiffness, const BondStrain& strain);

/// A bond between two blocks with its anchors in their principal axes.
struct Bond {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    BondSection section;
    BondStiffness stiffness;
    BondStrength strength;
    Eigen::Vector3d anchor_in_first_m;
    Eigen::Vector3d anchor_in_second_m;
    Eigen::Quaterniond axes_in_first;  ///< turns vectors of the bond's axes into those of the block
    Eigen::Quaterniond axes_in_second;
    bool intact = true;
    Eigen::Vector3d dashpot_n = Eigen::Vector3d::Zero();  ///< of the last step, on the second block
    Eigen::Vector3d point_m = Eigen::Vector3d::Zero();    ///< where it acted
};

/// Where a block is.
struct BlockPose {
    Eigen::Vector3d centre_m;
    Eigen::Quaterniond attitude;
};

/// The strain of a bond: the place and attitude of the second anchor as the first block sees it.
struct PlacedStrain {
    BondStrain strain;
    Eigen::Quaterniond axes;   ///< of the bond, with the first block
    Eigen::Vector3d anchor_m;  ///< of the second block, in space
    double half_turn_cosine;
};
PlacedStrain strain_of(const Bond& bond, const BlockPose& first, const BlockPose& second);

/// The force of a strained bond on its blocks, the exact gradient of its energy: momentum, angular momentum
/// and energy are kept.
PairForce bond_force(const Bond& bond, const PlacedStrain& placed, const Mover& first, const Mover& second);

/// The dashpot beside an intact bond: 2 beta sqrt(m_eff k) times the relative speed of the anchors, normal
/// and shear.
PairForce bond_dashpot(Bond& bond, const PlacedStrain& placed, const Mover& first, const Mover& second,
                       double damping_ratio, double effective_mass_kg, double step_s, Losses& losses);

}  // namespace rockfall::rock_mass
