#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "rockfall/laws/flight.hpp"
#include "rockfall/motion/rigid/body.hpp"
#include "rockfall/motion/rigid/contact_search.hpp"
#include "rockfall/motion/rigid/ground_patch.hpp"
#include "rockfall/motion/rigid/law.hpp"
#include "rockfall/motion/rigid/ledger.hpp"
#include "rockfall/motion/rigid/percussion.hpp"
#include "rockfall/motion/rigid/scarring.hpp"
#include "rockfall/motion/rigid/turning.hpp"
#include "rockfall/slope/slope.hpp"

namespace rockfall::rigid {

/// How a free flight ends.
enum class FlightStop : std::uint8_t { contact, left_terrain };

/// A free flight from where the block is.
struct FreeFlight {
    double duration_s;
    FlightStop end;
};

/// What an impact did, or a step in contact.
struct Touchdown {
    bool touched = false;                               ///< some contact was closed
    double into_ground_mps = 0.0;                       ///< fastest approach of a contact
    Eigen::Vector3d point_m = Eigen::Vector3d::Zero();  ///< of that contact
    std::uint32_t triangle = no_triangle;               ///< under it
    bool lasts = false;                                 ///< the block stays on the ground
};

/// Memory that blocks reuse.
struct BlockScratch {
    PatchMarks marks;
    GroundPatch patch;
    PosedBlock posed;
    std::vector<TouchPoint> touches;
    std::vector<PercussionPoint> points;
    std::vector<NearTriangle> corridor;
};

/// One rigid block on a slope: free flights with located impacts, and steps of lasting contact.
///
/// Flight: nothing can touch while the ball around the block is clear of all triangles near its parabola.
/// Then time advances by lower bounds of the first contact until a gap is below 0, which is located to 1e-12
/// s. Lasting contact: Moreau's midpoint rule (half a drift, contacts there, one percussion with all of
/// gravity's kick, half a drift). Obstacles are none of its business.
class Block {
public:
    Block(const SlopeView& slope, const Law& law, const solids::Solid& solid, const Body& start,
          std::uint32_t triangle, BlockScratch& scratch, const Bumps& bumps = {});

    [[nodiscard]] const Body& body() const { return body_; }
    [[nodiscard]] const solids::Solid& solid() const { return solid_; }
    [[nodiscard]] std::uint32_t triangle() const { return triangle_; }
    [[nodiscard]] const Ledger& ledger() const { return ledger_; }
    [[nodiscard]] double slip_m() const { return slip_m_; }
    /// A sweep of the solver ended before its tolerance was met, so often.
    [[nodiscard]] std::uint32_t unsolved() const { return unsolved_; }
    /// Percussions solved so far.
    [[nodiscard]] std::uint64_t percussions() const { return percussions_; }

    /// The free flight that begins now; the block stays where it is.
    FreeFlight fly();
    /// Where the flight that fly() began has the block after a time.
    [[nodiscard]] Body flown(double time_s);
    /// Takes the block there. Requires a time up to the flight's end.
    void go_on(double time_s);

    /// The impact where the block is now.
    Touchdown strike();
    /// A step of lasting contact. False in `inside`: the block has left the terrain.
    Touchdown step(double duration_s, bool& inside);

    /// Speed and spin change at an obstacle: velocity as given, spin times a factor; the loss is booked.
    void meet_obstacle(const Eigen::Vector3d& velocity_mps, double spin_factor);
    /// The block stays where it is: what it has left is booked.
    void come_to_rest(double& booked_j);
    void rest_at_obstacle() { come_to_rest(ledger_.obstacles_j); }
    void rest_on_ground() { come_to_rest(ledger_.other_j); }

    /// Takes out what overlap is left of lasting contact, before a flight begins.
    void clear_overlap();

    /// Smallest gap to the ground where the block is, at most `reach_m`.
    [[nodiscard]] double gap_m(double reach_m);
    void move_by(const Eigen::Vector3d& by_m);
    /// Energy now less what the ledger says.
    [[nodiscard]] double residual_j() const {
        return ledger_.residual_j(body_.kinetic_j(solid_) + body_.potential_j(solid_));
    }

private:
    bool is_over_ground(const Body& body);
    void pose(const Body& body);
    [[nodiscard]] double ball_clear_until_s(double from_s, bool& leaves);
    [[nodiscard]] bool ball_is_clear() const;
    double worst_gap_m(double time_s, double reach_m);
    double locate_impact_s(double clear_s, double hit_s);
    [[nodiscard]] Ground ground_at(const TouchPoint& touch) const;
    void take_points(const Velocities& before, double plastic_mps);
    Touchdown percuss(const Velocities& before, const Eigen::Vector3d& kick_mps);
    [[nodiscard]] Velocities velocities_of(const Body& body) const;
    [[nodiscard]] bool is_pressed(const Velocities& now) const;
    void take_velocities(const Velocities& velocities);
    void find_contacts(double reach_m);
    [[nodiscard]] const TouchPoint* deepest_touch() const;
    [[nodiscard]] std::optional<Eigen::Vector3d> overlap_of_impact_m() const;
    void keep_at_ground();
    void lift(const Eigen::Vector3d& by_m);
    void begin_scar(const Eigen::Vector3d& along, const Eigen::Vector3d& kick_mps);
    void plough(double way_m);
    void slow_down(double factor);
    void drag_in_contact(double duration_s);
    [[nodiscard]] double patch_radius_m() const;

    SlopeView slope_;
    const Law& law_;
    const solids::Solid& solid_;
    BlockScratch& scratch_;
    Bumps bumps_;
    Body body_;
    std::uint32_t triangle_;
    Turning turning_;
    Flight flight_{};  ///< of the centroid
    PercussionSolver solver_;
    Ledger ledger_;
    double slip_m_ = 0.0;
    double beta_ps_ = 0.0;     ///< of the ground touched last
    double drag_ps_ = 0.0;     ///< likewise
    Scar scar_;                ///< the present one
    double airborne_s_ = 0.0;  ///< of the flight that ended last
    std::uint32_t unsolved_ = 0;
    std::uint64_t percussions_ = 0;
};

}  // namespace rockfall::rigid
