#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "forest/stand/cohort.hpp"
#include "forest/stand/dead_wood.hpp"
#include "forest/stand/patch.hpp"
#include "forest/stand/stand_balance.hpp"
#include "forest/stand/tree.hpp"

namespace forest {

/// What a year did to a tree, per stem.
struct TreeGrowth {
    double dbh_cm = 0.0;           ///< >= 0, increment
    double height_m = 0.0;         ///< >= 0, increment
    TreeCrown crown{};             ///< after the year
    double above_ground_kg = 0.0;  ///< after the year
    double stem_kg = 0.0;          ///< of it, after the year
    double gain_kg = 0.0;          ///< above-ground share of its production
};

/// Dry mass that a change takes out of the dead wood.
struct DeadWoodLoss {
    double decayed_kg = 0.0;  ///< by decay
    double soil_kg = 0.0;     ///< of pieces too rotten to be followed, or that rolled off
    double taken_kg = 0.0;    ///< by people
};

/// Stems to take out of a tree record: all of them, or some of a group.
struct Removal {
    TreeId tree{};
    Cause cause = Cause::background;
    std::uint32_t stems = 0;  ///< 0 = all
};

/// A tree that left the stand this year, as it was when it did. `tree.stems` is how many of its group left.
struct DeadTree {
    Tree tree;
    Cause cause = Cause::background;
};

/// What a year did to a cohort.
struct CohortGrowth {
    double height_m = 0.0;           ///< after the year, > 0
    std::uint16_t stress_years = 0;  ///< after the year
    bool browsed = false;            ///< deer found it
};

/// Saplings to take out of a cohort.
struct SaplingRemoval {
    std::size_t cohort = 0;  ///< place in cohorts()
    std::uint32_t stems = 0;
    Cause cause = Cause::background;
};

/// All of a stand that changes with the years: kept, and given back to the same patches, it goes on the same.
struct StandImage {
    int year = 0;             ///< calendar year
    std::vector<Tree> trees;  ///< by id
    std::vector<Wound> wounds;
    std::vector<Cohort> cohorts;
    std::vector<PatchState> patch_states;
    SnagsAndLogs dead_wood;
    std::vector<DeadTree> deaths;
    StandBalance balance;
    StandBalance earlier;  ///< years before the running one
    std::uint64_t next_id = 0;
    std::uint64_t stems_at_start = 0;
    double mass_at_start_kg = 0.0;
    double dead_wood_at_start_kg = 0.0;
};

/// The living and the dead of a forest: the only owner of its trees, cohorts, snags, logs and patches.
///
/// Processes read the stand, compute what changes and report it; no tree is changed from outside. Every stem
/// enters and leaves through the functions below, which keep the balance, so that
///     stems at the start + stems in = stems out + stems standing
/// holds at any time, and the same for saplings, for mass, and for the wood of stems, living and dead.
///
/// Trees stand in the order of their ids, cohorts in the order they came: nothing depends on the order in
/// which they were given, and sums over trees have the same bits on every machine. Lists of trees that one
/// function returns stay valid until the next one that adds or removes.
class Stand {
public:
    /// Trees keep the ids they have; they need not be sorted. `first_year` is the calendar year of this
    /// state. Requires trees on patches with different ids, and species below species_count.
    Stand(PatchGrid grid, std::size_t species_count, std::vector<Tree> trees, int first_year);
    /// A stand as image() gave it. Requires the patches and species of that stand.
    Stand(PatchGrid grid, std::size_t species_count, StandImage image);

    // --- what there is
    // ---------------------------------------------------------------------------------------
    [[nodiscard]] const PatchGrid& grid() const { return grid_; }
    [[nodiscard]] std::size_t species_count() const { return species_count_; }
    /// All that changes with the years.
    [[nodiscard]] const StandImage& image() const { return now_; }
    [[nodiscard]] int year() const { return now_.year; }
    [[nodiscard]] std::span<const Tree> trees() const { return now_.trees; }
    [[nodiscard]] std::span<const Cohort> cohorts() const { return now_.cohorts; }
    [[nodiscard]] std::span<const PatchState> patch_states() const { return now_.patch_states; }
    [[nodiscard]] const SnagsAndLogs& dead_wood() const { return now_.dead_wood; }
    /// Place in trees(), nothing if it does not stand any more.
    [[nodiscard]] std::optional<std::size_t> find(TreeId id) const;
    /// Open and healing scars of a tree, from below to above.
    [[nodiscard]] std::span<const Wound> wounds_of(TreeId id) const;
    /// All scars, by tree and height.
    [[nodiscard]] std::span<const Wound> wounds() const { return now_.wounds; }

    // --- the balance
    // -------------------------------------------------------------------------------------------
    /// Of the running year.
    [[nodiscard]] const StandBalance& balance() const { return now_.balance; }
    /// Since the start, the running year included.
    [[nodiscard]] StandBalance total_balance() const;
    [[nodiscard]] std::uint64_t stems_standing() const;
    [[nodiscard]] double mass_standing_kg() const;
    [[nodiscard]] double stem_mass_standing_kg() const;
    [[nodiscard]] double dead_wood_kg() const;
    [[nodiscard]] std::uint64_t saplings_standing() const;
    [[nodiscard]] std::uint64_t stems_at_start() const { return now_.stems_at_start; }
    [[nodiscard]] double mass_at_start_kg() const { return now_.mass_at_start_kg; }
    [[nodiscard]] double dead_wood_at_start_kg() const { return now_.dead_wood_at_start_kg; }
    /// Trees that died or were felled this year, in the order of leaving. Dead wood is made of them.
    [[nodiscard]] std::span<const DeadTree> deaths() const { return now_.deaths; }

    // --- a year
    // ----------------------------------------------------------------------------------------------
    /// The next calendar year begins: an empty balance, an empty list of deaths.
    void begin_year();

    /// One entry a tree, in their order. Trees become one year older.
    /// Requires what TreeGrowth says, and a height that stays above 1.3 m.
    void grow(std::span<const TreeGrowth> growth);
    /// One value a tree in [0, 1].
    void set_light_ratios(std::span<const double> light_ratios);
    /// One number of bad years in a row for each tree.
    void set_stress_years(std::span<const std::uint16_t> stress_years);
    /// One value a tree in [0, 1].
    void set_vitalities(std::span<const double> vitalities);
    /// One entry a tree.
    void set_rots(std::span<const Rot> rots);
    void set_flags(TreeId tree, TreeFlags flags);
    /// One entry a patch.
    void set_patch_states(std::span<const PatchState> states);

    /// New trees; their ids are given here, in their order. Trees outside every patch are not allowed.
    void add_trees(std::span<const Tree> trees);
    /// Takes trees out and keeps them in deaths(). A tree named twice leaves for the first cause.
    void remove_trees(std::span<const Removal> removals);
    /// Groups that have reached `dbh_cm` become single trees with places of their own on their patch, drawn
    /// by id.
    void split_groups(double dbh_cm, std::uint64_t seed, std::uint32_t replicate);

    /// New scars; those of trees that do not stand are left out.
    void add_wounds(std::span<const Wound> wounds);
    /// All scars after healing; sorted here.
    void set_wounds(std::vector<Wound> wounds);

    void add_cohorts(std::span<const Cohort> cohorts);
    /// One entry a cohort; cohorts become one year older.
    void grow_cohorts(std::span<const CohortGrowth> growth);
    /// Empty cohorts are removed. The places of cohorts change.
    void remove_saplings(std::span<const SaplingRemoval> removals);
    /// Cohorts (places in cohorts(), rising) become the trees given for them, one record each with the
    /// cohort's stems.
    void recruit(std::span<const std::size_t> cohorts, std::span<const Tree> trees);

    /// Dead wood that an inventory found at the start; it is no gain of the balance. Requires a stand without
    /// dead wood.
    void begin_with(SnagsAndLogs dead_wood);
    void add_snags(std::span<const Snag> snags);
    void add_logs(std::span<const Log> logs);
    /// Dead wood after a year of decay and falls, or after people took some: what is gone by what.
    void set_dead_wood(SnagsAndLogs dead_wood, const DeadWoodLoss& loss);

private:
    void enter(Tree tree);
    void drop_wounds_of_the_dead();

    PatchGrid grid_;
    std::size_t species_count_;
    StandImage now_;
};

}  // namespace forest
