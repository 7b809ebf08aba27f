#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "coupling/exchange/bare_year.hpp"
#include "coupling/exchange/regimes/timber_value.hpp"
#include "coupling/exchange/stopping_places.hpp"
#include "coupling/results/figures/figures.hpp"
#include "forest/inventory/tables.hpp"
#include "forest/protection/gaps.hpp"
#include "forest/protection/stand_indicators.hpp"
#include "forest/stand/tree.hpp"
#include "forest/treatment/felling.hpp"

namespace coupling::decades {

// What a member of a run keeps of its years: plain rows, so that they go into part files as they are.

/// A run of one regime and one replicate in one climate.
struct Member {
    std::uint32_t regime = 0;     ///< place in the scenario's list
    std::uint32_t replicate = 0;  ///< counted from 0
    std::uint32_t climate = 0;    ///< place among the climates of the site
    friend bool operator==(const Member&, const Member&) = default;
};

/// For rows that speak of all species, or of the whole forest.
inline constexpr std::uint32_t all = std::numeric_limits<std::uint32_t>::max();

/// What stands at the end of a year: in one management unit or in the whole forest, of one species or of all.
struct StandRow {
    std::int32_t year = 0;  ///< simulated years since the start; 0 is the start
    std::uint32_t unit = all;
    std::uint32_t species = all;
    forest::StandFigures figures;
    double drought_index = 0.0;  ///< of the year, mean over the patches of the unit; NaN at the start
    forest::YoungFigures young{};
};

/// Gaps along the fall line at the end of a year: in one management unit or in the whole forest.
struct GapRow {
    std::int32_t year = 0;
    std::uint32_t unit = all;
    forest::GapFigures figures;
};

/// Cover, stability, regeneration and lying wood at the end of a year: of a management unit or the whole
/// forest.
struct IndicatorRow {
    std::int32_t year = 0;
    std::uint32_t unit = all;
    forest::StandIndicators figures;
};

/// What happened in a year, in the whole forest and per hectare.
struct YearRow {
    std::int32_t year = 0;
    std::int32_t calendar_year = 0;
    double volume_increment_m3pha = 0.0;
    double production_tpha = 0.0;  ///< net primary production, dry mass
    double ingrowth_stems_pha = 0.0;
    double saplings_pha = 0.0;
    double snags_pha = 0.0;
    double snags_m3pha = 0.0;
    double logs_pha = 0.0;
    double logs_m3pha = 0.0;
    double dead_stems_tpha = 0.0;
    std::array<double, forest::decay_class_count> dead_wood_m3pha{};  ///< by decay class
    // Dry wood of stems. The flows of the start are those of its work and rocks, which come after what stood.
    double stem_wood_tpha = 0.0;      ///< living
    double standing_value_eur = 0.0;  ///< of the whole forest (exchange/regimes/timber_value.hpp)
    double stem_growth_tpha = 0.0;    ///< of trees that stand and of those that die later in the year
    double stem_ingrowth_tpha = 0.0;
    double stem_losses_tpha = 0.0;   ///< of all trees that left
    double stem_hauled_tpha = 0.0;   ///< of these, felled and taken out of the forest
    double stem_litter_tpha = 0.0;   ///< of these, too thin to be followed
    double dead_wood_in_tpha = 0.0;  ///< of these, now snag, stump or log
    double dead_wood_decayed_tpha = 0.0;
    double dead_wood_to_soil_tpha = 0.0;  ///< pieces too rotten to be followed, or that rolled off
    double dead_wood_taken_tpha = 0.0;    ///< salvaged
    double precipitation_mm = 0.0;
    double evapotranspiration_mm = 0.0;
    double runoff_mm = 0.0;
    double storage_gain_mm = 0.0;
    double mean_temperature_degc = 0.0;  ///< over the patches
};

/// Trees of a species that left the stand in a year for one cause, per hectare of the whole forest.
struct LossRow {
    std::int32_t year = 0;
    std::uint32_t species = 0;
    forest::Cause cause = forest::Cause::background;
    forest::Loss loss;
};

/// A tree of a chosen year. Groups of young trees are one row.
struct TreeRow {
    std::int32_t year = 0;
    std::uint32_t species = 0;
    std::uint64_t tree = 0;
    double x_m = 0.0;
    double y_m = 0.0;
    float dbh_cm = 0.0F;
    float height_m = 0.0F;
    float crown_base_m = 0.0F;
    float crown_radius_m = 0.0F;
    float age_years = 0.0F;
    float light_ratio = 0.0F;  ///< NaN at the start
    float vitality = 0.0F;
    std::uint32_t stems = 1;
    std::uint32_t rock_hits = 0;  ///< in that year
    float rock_energy_kj = 0.0F;  ///< taken from rocks in that year
};

/// A piece of dead wood in a chosen year, of the first replicate: what stands of a dead tree, or a log.
struct DeadWoodRow {
    std::int32_t year = 0;
    std::uint32_t species = 0;
    double x_m = 0.0;  ///< of a log: its thick end
    double y_m = 0.0;
    float thick_cm = 0.0F;       ///< DBH of what stands while it lived; thick end of a log
    float height_m = 0.0F;       ///< of what stands; 0: a log
    float plan_m = 0.0F;         ///< length of a log on the map
    float direction_rad = 0.0F;  ///< of a log, from its thick end, counter-clockwise from east
    std::uint32_t broken = 0;    ///< stands shorter than the tree was
    std::uint32_t reserved = 0;
};

/// A corner of the path of a rock in a chosen year, of the first replicate; corners of a path follow each
/// other. In coordinates of the terrain.
struct PathCornerRow {
    std::int32_t year = 0;
    float energy_kj = 0.0F;
    std::uint64_t rock = 0;
    double x_m = 0.0;
    double y_m = 0.0;
    double z_m = 0.0;
};

/// A tree of at least 7 cm that left the stand: for a rock or its wounds, or for any cause where all are
/// asked for.
struct RemovedRow {
    std::int32_t year = 0;
    std::uint32_t species = 0;
    std::uint64_t tree = 0;
    double x_m = 0.0;
    double y_m = 0.0;
    float dbh_cm = 0.0F;
    float height_m = 0.0F;
    forest::Cause cause = forest::Cause::background;
};

/// An intervention that was due.
struct HarvestRow {
    std::int32_t year = 0;
    std::uint32_t intervention = 0;  ///< row of the regime
    std::uint32_t areas = 0;
    bool found_nothing = false;
    double area_ha = 0.0;
    double stems = 0.0;
    double taken_m3 = 0.0;
    double left_m3 = 0.0;
    std::uint64_t plants = 0;
    std::uint64_t guarded = 0;
    std::uint64_t tended = 0;
    double fenced_ha = 0.0;
};

/// A patch on which an intervention has felled or girdled trees, of the first replicate.
struct CutPatchRow {
    std::int32_t year = 0;
    std::uint32_t intervention = 0;  ///< row of the regime
    std::uint32_t patch = 0;
};

/// Wood of a species and diameter class that was felled in a year.
struct TimberRow {
    std::int32_t year = 0;
    std::uint32_t species = 0;
    std::uint32_t dbh_class = 0;
    forest::TimberClass timber;
};

/// What the work of a year brought.
struct MarginRow {
    std::int32_t year = 0;
    Margin margin;
    double machine_hours = 0.0;  ///< to bring the wood out
    double cable_setups = 0.0;   ///< corridors from which timber was taken
};

/// The rocks of a year on one slope.
struct SlopeRow {
    std::int32_t year = 0;
    Cover cover = Cover::forest;
    SlopeFigures figures;
};

/// The rocks of a year that left the terrain over one part of its rim, on one slope.
struct DepartureRow {
    std::int32_t year = 0;
    Cover cover = Cover::forest;
    rockfall::RimPart part = rockfall::RimPart::north;
    std::uint64_t rocks = 0;
};

/// The rocks of a year at one target, over the same rocks with forest and without.
struct TargetRow {
    std::int32_t year = 0;
    std::uint32_t target = 0;
    PairedCounts paired;
    ArrivalFigures forest;
    ArrivalFigures bare;
};

/// The same rocks through the living trees alone, without snags, stumps and logs.
struct LivingRow {
    std::int32_t year = 0;
    std::uint32_t target = 0;
    PairedCounts paired;
};

/// Where the forest stops the rocks of a year: a band of distance from a target.
struct BandRow {
    std::int32_t year = 0;
    std::uint32_t target = 0;
    std::uint32_t band = 0;  ///< from the target on; all: spared rocks that met no tree
    exchange::PlaceCounts counts;
};

/// Arrivals of a year at a target in a bin of energy (rockfall::energy_bins): pooled over replicates they
/// give percentiles that one replicate has too few rocks for.
struct EnergyRow {
    std::int32_t year = 0;
    std::uint16_t target = 0;
    std::uint16_t bin = 0;
    std::uint32_t cover = 0;  ///< index of Cover
    std::uint32_t rocks = 0;
};

/// What the rocks of a chosen year left in the cells of the map on one slope.
struct CellMap {
    std::int32_t year = 0;
    Cover cover = Cover::forest;
    std::vector<rockfall::CellSums> cells;
};

/// A patch in a chosen year.
struct PatchRow {
    std::int32_t year = 0;
    std::uint32_t patch = 0;
    float stems_pha = 0.0F;
    float basal_area_m2pha = 0.0F;
    float volume_m3pha = 0.0F;
    float top_height_m = 0.0F;  ///< of the tallest tree
    float leaf_area_index = 0.0F;
    float ground_light = 0.0F;  ///< NaN at the start
};

/// All that one member leaves.
struct MemberYears {
    Member member;
    std::vector<YearRow> years;  ///< the first is the start
    std::vector<StandRow> stands;
    std::vector<GapRow> gaps;
    std::vector<IndicatorRow> indicators;
    std::vector<LossRow> losses;
    std::vector<TreeRow> trees;
    std::vector<DeadWoodRow> dead_wood;
    std::vector<PathCornerRow> paths;
    std::vector<PatchRow> patches;
    std::vector<RemovedRow> removed;
    std::vector<HarvestRow> harvest;
    std::vector<CutPatchRow> cut_patches;
    std::vector<TimberRow> timber;
    std::vector<MarginRow> margins;
    std::vector<SlopeRow> slopes;  ///< of years with rockfall
    std::vector<DepartureRow> departures;
    std::vector<TargetRow> targets;
    std::vector<LivingRow> living;  ///< of years with rockfall, with run.living_trees_alone
    std::vector<EnergyRow> energies;
    /// What risk is counted of (decades/risk), exact for any curves, in 8 bytes each. For each of `targets`
    /// those through the forest, then those over the bare slope: as many as `paired` says.
    std::vector<exchange::RockAtTarget> rocks_at_targets;
    std::vector<BandRow> bands;  ///< of years with rockfall; bands to which no rock came are left out
    /// By patch, sums over all years and targets; the last one is ground without a patch, and rocks without a
    /// tree. Empty without rockfall.
    std::vector<exchange::PlaceCounts> stopping_patches;
    std::vector<CellMap> maps;
};

}  // namespace coupling::decades
