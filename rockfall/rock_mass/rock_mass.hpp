#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "rockfall/rock_mass/bond.hpp"
#include "rockfall/rock_mass/broad_phase.hpp"
#include "rockfall/rock_mass/contact.hpp"
#include "rockfall/rock_mass/ground.hpp"
#include "rockfall/rock_mass/held_overlap.hpp"
#include "rockfall/rock_mass/laws.hpp"
#include "rockfall/rock_mass/ledger.hpp"
#include "rockfall/rock_mass/lone_blocks.hpp"
#include "rockfall/rock_mass/parallel.hpp"
#include "rockfall/rock_mass/standing_stem.hpp"
#include "rockfall/solids/free_rotation.hpp"
#include "rockfall/solids/mass_properties.hpp"

namespace rockfall::rock_mass {

/// A block as it starts: its solid, in principal axes, and where it lies.
struct BlockStart {
    solids::Solid solid;
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
    Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
    Eigen::Vector3d momentum_nms = Eigen::Vector3d::Zero();  ///< angular, in principal axes
    bool fixed = false;                                      ///< part of the rock that stays
};

/// The block that a solid in the axes of space makes.
BlockStart block_of(const solids::Hull& hull_in_space, double density_kgpm3, bool fixed);

/// A bond as it starts: the polygon that two blocks share, in space.
struct BondStart {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    std::vector<Eigen::Vector3d> polygon_m;
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, from the first to the second block
    BondStrength strength;
};

/// What becomes of a block.
enum class BlockStatus : std::uint8_t {
    moving,
    asleep,
    fixed,
    left,
    handed,  ///< goes on under another motion model
};

/// A block of a rock mass at a time.
struct Block {
    Eigen::Vector3d centre_m;
    Eigen::Vector3d velocity_mps;
    solids::Rotation rotation;
    BlockStatus status = BlockStatus::moving;
    double still_s = 0.0;  ///< how long it has been slow
    double alone_s = 0.0;  ///< how long it has been alone, since blocks are watched for that
    // Of the forces at this time, gravity included.
    Eigen::Vector3d force_n = Eigen::Vector3d::Zero();
    Eigen::Vector3d moment_nm = Eigen::Vector3d::Zero();  ///< about the centre, in space
    double dashpots_ps = 0.0;  ///< rate at which the dashpots of all its contacts would take its motion
    // What does not change.
    double mass_kg = 0.0;      ///< with what was added to it
    double mass_factor = 1.0;  ///< of the thinnest blocks, by Laws::heavier_share [-]; energies have it too
    double weight_n = 0.0;
    double volume_m3 = 0.0;
    Eigen::Vector3d inertia_kgm2;
    double radius_m = 0.0;     ///< of the bounding sphere
    double half_side_m = 0.0;  ///< of the cube of equal volume: r in L = r_i + r_j
    double start_height_m = 0.0;

    [[nodiscard]] Eigen::Vector3d spin_radps() const { return rotation.spin_radps(inertia_kgm2); }
    [[nodiscard]] double translation_j() const { return 0.5 * mass_kg * velocity_mps.squaredNorm(); }
    [[nodiscard]] double energy_j() const { return translation_j() + rotation.energy_j(inertia_kgm2); }
    /// Without the mass that was added.
    [[nodiscard]] double own_energy_j() const { return energy_j() / mass_factor; }
};

/// Blocks whose mass was scaled up.
struct ScaledMass {
    std::size_t blocks = 0;
    double largest_factor = 1.0;
    double added_share = 0.0;  ///< by the mass of all blocks that may move [-]
};

/// Speed below which a block may be put to rest, for how long, and share of its weight that wakes it
/// [choice].
inline constexpr double sleep_speed_mps = 0.05;
inline constexpr double sleep_after_s = 0.5;
inline constexpr double wake_share_of_weight = 0.1;

/// Local damping, friction and the most damping ratio of contacts while a mass is held [choice].
inline constexpr double held_damping = 0.7;
inline constexpr double held_friction = 100.0;
inline constexpr double most_held_damping_ratio = 0.2;
/// Largest step factor.
inline constexpr double most_step_factor = 0.5;
/// Largest step factor while a mass is held [choice].
inline constexpr double most_held_step_factor = 0.4;

/// Blocks, bonds, contacts, ground and stems in motion: velocity Verlet with the rotation of
/// Dullweber, Leimkuhler & McLachlan (solids/free_rotation).
///
/// Forces are computed per pair in fixed chunks, stored, and gathered per block in a fixed order; sums run
/// over chunks in their order. So the result has the same bits for any ParallelFor.
class RockMass {
public:
    RockMass(const Laws& laws, std::span<const BlockStart> blocks, std::span<const BondStart> bonds,
             Ground ground, std::vector<StandingStem> stems = {}, ParallelFor parallel = one_by_one);

    void step();
    void advance(std::uint64_t steps) {
        for (std::uint64_t i = 0; i < steps; ++i) {
            step();
        }
    }

    /// Brings the mass to rest under its own weight before it is let go: from `hold` to `let_go` nothing
    /// slides or breaks, nothing sleeps, and local damping takes the motion. `let_go` ends all motion and
    /// begins time and ledger again at 0. Where a held mass rests does not depend on its inertia: small
    /// blocks get more of it, not more weight, so that half of the blocks have the step of the middle one
    /// (`step_when_held_s`), by a step factor of at most most_held_step_factor.
    void hold();
    void let_go();
    /// Forces that are out of balance, by the weight of all blocks that may move [-]: 0 at rest.
    [[nodiscard]] double unbalanced_share() const;

    /// From now on blocks are watched for being alone: no intact bond, no contact with another block.
    void watch_lone_blocks() { watches_lone_ = true; }
    /// Blocks that move and have been alone for longer than a time, in ascending order; not those that the
    /// ground is about to throw back (lone_blocks.hpp).
    [[nodiscard]] std::vector<std::uint32_t> lone_blocks(double longer_than_s) const;
    /// Takes lone blocks out of the mass. Their energies leave the ledger, booked as handed over. Between
    /// steps.
    std::vector<HandedBlock> hand_over(std::span<const std::uint32_t> numbers);
    /// Takes blocks that were handed over back, with their own motion. One that lies in the ground is lifted
    /// out of it, and its motion pays for that as far as it can. Energies are booked, so that the ledger
    /// closes as before. Between steps.
    std::vector<TakenBack> take_back(std::span<const BlockBack> blocks);
    /// Books what a block that was handed over did to a stem: the energy is not of this ledger.
    void load_stem(std::size_t stem, double energy_j, bool breaks);

    [[nodiscard]] double step_s() const { return step_s_; }
    [[nodiscard]] double step_when_held_s() const { return step_when_held_s_; }
    /// Blocks whose mass was scaled up, and what was added by the mass of all that may move [-].
    [[nodiscard]] ScaledMass scaled_mass() const;
    [[nodiscard]] double time_s() const { return static_cast<double>(steps_) * step_s_; }
    [[nodiscard]] std::uint64_t steps() const { return steps_; }
    [[nodiscard]] std::span<const Block> blocks() const { return blocks_; }
    [[nodiscard]] PlacedBlock placed(std::size_t block) const;
    [[nodiscard]] std::span<const StandingStem> stems() const { return stems_; }
    [[nodiscard]] std::size_t bonds_intact() const;
    /// Pairs of blocks whose bond is intact.
    [[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> intact_bonds() const;
    [[nodiscard]] std::uint64_t broken_by_tension() const { return broken_by_tension_; }
    [[nodiscard]] std::uint64_t broken_by_shear() const { return broken_by_shear_; }
    [[nodiscard]] std::size_t pairs() const { return contacts_.size(); }
    /// All energies at this time: takes about as long as a few steps.
    [[nodiscard]] Ledger ledger() const;
    [[nodiscard]] double motion_at_start_j() const { return motion_at_start_j_; }
    /// Bytes that it holds, about.
    [[nodiscard]] std::size_t bytes() const;

    /// Searches pairs again and forgets what contacts are carried on by. A run that goes on from `packed`
    /// does so from here with the same bits.
    void refresh();
    /// Everything that changes, after `refresh`.
    [[nodiscard]] std::vector<double> packed() const;
    /// Requires what `packed` of an equal mass gave; false if it cannot be that.
    bool unpack(std::span<const double> numbers);

private:
    /// What a contact is carried on by; none before it was clipped.
    using KeptOverlap = std::unique_ptr<HeldOverlap>;
    /// Two blocks that are or may come in touch.
    struct Contact {
        std::uint32_t first = 0;
        std::uint32_t second = 0;
        ContactState state;
        PairForce force;
    };
    /// What says of most contacts that there is nothing to do: few bytes, one after the other.
    struct Watch {
        std::uint32_t first = 0;
        std::uint32_t second = 0;
        double free_m = 0.0;    ///< the blocks cannot meet before they have moved so far against each other
        double turned_m = 0.0;  ///< sum of both turn ways when that was found
        Eigen::Vector3d between_m = Eigen::Vector3d::Zero();  ///< from centre to centre then
        bool presses = false;                                 ///< it has a force
    };
    /// A bond, and the contact that takes its place when it is broken.
    struct Joint {
        Bond bond;
        ContactState state;
        PairForce force;
    };
    /// A block on the ground.
    struct Footing {
        ContactState state;
        PairForce force;
        std::vector<std::uint32_t> prisms;
        double highest_ground_m = 0.0;
        double free_way_m = 0.0;  ///< the block cannot meet the ground before it has gone so far
    };
    /// Of a block, what pairs look at in each step: two lines of the cache.
    struct alignas(64) Moved {
        Eigen::Vector3d centre_m;
        Eigen::Vector3d velocity_mps;
        Eigen::Vector3d spin_radps;
        Eigen::Quaterniond attitude;
        BlockStatus status = BlockStatus::moving;
    };
    /// And what does not change from step to step, but for the dashpots: one line.
    struct alignas(64) PairSide {
        double inverse_mass_pkg = 0.0;  ///< 0: fixed
        Eigen::Vector3d inverse_inertia;
        double half_side_m = 0.0;
        double radius_m = 0.0;
        double weight_n = 0.0;
        double dashpots_ps = 0.0;
    };
    /// What a pair does to one of its blocks; those of a block lie one after the other, in the order of its
    /// pairs. A line of the cache.
    struct alignas(64) EndLoad {
        Eigen::Vector3d force_n = Eigen::Vector3d::Zero();
        Eigen::Vector3d moment_nm = Eigen::Vector3d::Zero();
        double dashpots_ps = 0.0;  ///< rate at which its dashpots would take the motion of the block
        bool holds = false;        ///< an intact bond or a contact that presses
    };
    struct ChunkSums {
        Losses losses;
        double fracture_j = 0.0;
        double local_damping_j = 0.0;
        double rest_j = 0.0;
        double left_j = 0.0;
        std::uint64_t broken_by_tension = 0;
        std::uint64_t broken_by_shear = 0;
        bool strayed = false;
        bool near_strayed = false;
    };

    void search_pairs();
    void store_shapes(std::span<const BlockStart> blocks);
    void store_joints(std::span<const BondStart> bonds);
    void place(std::size_t block);
    void set_step();
    [[nodiscard]] std::vector<double> critical_steps_s() const;
    [[nodiscard]] double critical_step_s(std::size_t block) const;
    [[nodiscard]] double held_step_factor() const {
        return std::min(laws_.step_factor, most_held_step_factor);
    }
    [[nodiscard]] bool stands(std::uint32_t block) const {
        return moved_[block].status != BlockStatus::moving;
    }
    [[nodiscard]] Mover mover(std::uint32_t block) const {
        return {moved_[block].centre_m, moved_[block].velocity_mps, moved_[block].spin_radps};
    }
    [[nodiscard]] BlockPose pose(std::uint32_t block) const {
        return {moved_[block].centre_m, moved_[block].attitude};
    }
    [[nodiscard]] ContactPair contact_pair(std::uint32_t first, std::uint32_t second) const;
    [[nodiscard]] ContactPair ground_pair(std::uint32_t block) const;

    template <class Work>
    void in_chunks(std::size_t count, const Work& work);
    [[nodiscard]] bool is_free(const Watch& watch) const;
    /// How far two blocks may still move against each other before they can meet.
    [[nodiscard]] double free_left_m(const Watch& watch) const;
    void add(const ChunkSums& sums);

    void kick(Block& block, ChunkSums& sums) const;
    void move(std::size_t block, ChunkSums& sums);
    void compute_forces();
    void force_of(Joint& joint, KeptOverlap& held, ChunkSums& sums);
    double force_of(Contact& contact, KeptOverlap& held, ChunkSums& sums) const;
    void force_of_ground(std::uint32_t block, KeptOverlap& held, ChunkSums& sums);
    double touch(std::uint32_t first, std::uint32_t second, ContactState& state, PairForce& force,
                 KeptOverlap& held, ChunkSums& sums) const;
    [[nodiscard]] Overlap clipped(std::uint32_t first, std::uint32_t second, ContactState& state,
                                  KeptOverlap& held) const;
    [[nodiscard]] double slack_of(std::uint32_t first, std::uint32_t second) const;
    [[nodiscard]] bool is_holder(std::uint32_t block, std::uint32_t other) const;
    void break_bond(Joint& joint, const PlacedStrain& placed, const BondStress& stress, ChunkSums& sums);
    void gather(std::size_t block);
    [[nodiscard]] double dashpot_share_of(double rate_ps) const {
        return dashpot_share(std::min(laws_.step_factor, most_step_factor), step_s_, rate_ps);
    }
    void settle(std::size_t block, ChunkSums& sums);
    void meet_stems();
    void note(std::size_t block);
    void note_all();
    void list_near_contacts();
    void fetch_soon(std::size_t near) const;
    void fetch_joint_soon(std::size_t joint) const;
    void list_ends();
    void load_ends(std::size_t pair, std::uint32_t first, std::uint32_t second, const ContactState& state,
                   const PairForce& force, bool holds);
    [[nodiscard]] double dashpot_rate_ps(std::uint32_t block, const ContactState& state) const;
    void load_ends_of_joint(std::size_t joint);
    void load_ends_of_near(std::size_t near);
    void find_stems(std::span<const Box3> boxes);
    [[nodiscard]] double contact_energy_j(std::uint32_t first, std::uint32_t second,
                                          const ContactState& state) const;
    /// Energy that the ground holds under a block, normal to it.
    [[nodiscard]] double ground_energy_j(std::uint32_t block) const;
    [[nodiscard]] bool is_alone(std::size_t block) const;
    double lift_out_of_ground(std::uint32_t block);

    Laws laws_;
    std::optional<Laws> laws_when_let_go_;
    std::vector<Block> blocks_when_let_go_;  ///< for their masses
    bool watches_lone_ = false;
    ParallelFor parallel_;
    Ground ground_;
    double step_s_ = 0.0;
    double step_when_held_s_ = 0.0;
    std::uint64_t steps_ = 0;
    double motion_at_start_j_ = 0.0;
    std::vector<Block> blocks_;
    std::vector<Eigen::Vector3d> spins_;
    std::vector<Moved> moved_;
    std::vector<PairSide> sides_;

    // Shapes, block after block: in principal axes and in space.
    std::vector<std::uint32_t> first_vertex_, first_face_, first_list_, first_corner_;
    std::vector<Eigen::Vector3d> own_vertices_m_, vertices_m_;
    std::vector<Plane3> own_faces_, faces_;
    std::vector<std::uint16_t> corner_lists_, corners_;

    std::vector<Joint> joints_;
    std::vector<Contact> contacts_;
    std::vector<Watch> watches_;  ///< of contacts
    std::vector<Footing> footings_;
    std::vector<KeptOverlap> held_;  ///< of joints, contacts and footings, one after the other
    std::vector<StandingStem> stems_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> near_stems_;  ///< block, stem

    /// Contacts whose blocks may meet before they are listed again.
    std::vector<std::uint32_t> near_;
    std::vector<double> near_ways_m_;  ///< how far each block may go before that
    std::uint32_t steps_to_list_ = 0;
    std::vector<std::uint32_t> first_end_;  ///< of each block
    std::vector<EndLoad> ends_;
    std::vector<std::array<std::uint32_t, 2>> ends_of_;  ///< of joints and near contacts, one after the other
    std::vector<double> margins_m_;          ///< how far each block may go before pairs are searched again
    std::vector<double> ways_m_;             ///< how far it went
    std::vector<Eigen::Vector4d> places_m_;  ///< its centre, and how far its corners turned since `refresh`
    std::uint32_t steps_to_refresh_ = 0;

    std::vector<ChunkSums> chunk_sums_;
    Ledger taken_;  ///< what was taken out so far, and the sum at the start
    std::uint64_t broken_by_tension_ = 0;
    std::uint64_t broken_by_shear_ = 0;
};

template <class Work>
void RockMass::in_chunks(std::size_t count, const Work& work) {
    constexpr std::size_t chunk = 128;
    const std::size_t chunks = (count + chunk - 1) / chunk;
    chunk_sums_.assign(chunks, {});
    parallel_(chunks, [&](std::size_t k) {
        // Not in the list itself: there two threads would write to one line of the cache.
        ChunkSums sums;
        const std::size_t end = std::min(count, (k + 1) * chunk);
        for (std::size_t i = k * chunk; i < end; ++i) {
            work(i, sums);
        }
        chunk_sums_[k] = sums;
    });
    for (const ChunkSums& sums : chunk_sums_) {
        add(sums);
    }
}

}  // namespace rockfall::rock_mass
