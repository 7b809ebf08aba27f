#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/assessments/hazard/forest_changes.hpp"
#include "coupling/assessments/hazard/hazard_designs.hpp"
#include "coupling/assessments/hazard/hazard_map.hpp"
#include "coupling/assessments/hazard/hazard_matrix.hpp"
#include "coupling/assessments/hazard/hazard_rules.hpp"
#include "coupling/assessments/hazard/risk/risk_results.hpp"
#include "coupling/assessments/hazard/target_hits.hpp"
#include "coupling/inputs/scenario/hazard_settings.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"
#include "coupling/results/figures/departures.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::hazard {

/// A return period whose rocks have fallen.
struct FinishedPeriod {
    double return_period_years = 0.0;
    std::filesystem::path folder;  ///< of its results
    std::uint64_t rocks = 0;
    rockfall::DiameterRange diameters;
    std::array<Departures, rockfall::covers> departures;  ///< by cover; no rocks where there is no forest
    HitsOfTargets hits{};                                 ///< as in the site
    HitsOfTargets hits_without{};  ///< of the same rocks in the run of risk.without; empty: none
};

/// The rocks of a release zone, or of several that share them, with a return period.
struct ZoneRocks {
    std::string zone;  ///< its number; "others": those without rocks of their own
    double return_period_years = 0.0;
    double diameter_m = 0.0;
    double mass_kg = 0.0;
    std::uint64_t rocks = 0;
};

/// So few rocks of a return period hit a target that hazard.energy, or by `cadanav` how often those of a
/// class hit, is not known.
struct FewRocks {
    double return_period_years = 0.0;
    std::uint64_t rocks = 0;
    std::uint64_t even_rocks = 0;  ///< as rocks of one weight
};

/// The hazard of a target on a slope, from the rocks that hit it.
struct TargetHazard {
    RuledLevel ruled;            ///< by hazard.rule
    RuledLevel compared;         ///< by the rule that it is compared with
    EnergyOfRocks highest;       ///< the highest hazard.energy of a return period
    std::uint64_t rocks = 0;     ///< how many hit it, of all return periods
    double hits_per_year = 0.0;  ///< of all return periods

    /// Of return periods whose rocks that hit it are too few for hazard.energy, by which the rule goes; by
    /// `cadanav` of the class that gives the level: it may be too low or too high.
    std::vector<FewRocks> few_rocks{};

    /// hazard.energy gives the level, and it is but the largest of too few rocks; by `cadanav` too few rocks
    /// of the class give it.
    [[nodiscard]] bool rests_on_few_rocks(HazardRule rule) const {
        return rule == HazardRule::cadanav ? !few_rocks.empty() : ruled.energy.is_largest;
    }
};

/// One slope: its map and its targets.
struct SlopeHazard {
    Cover cover = Cover::bare;
    HazardMap map;                          ///< by hazard.rule
    HazardMap compared;                     ///< by the rule that it is compared with
    std::vector<TargetHazard> targets;      ///< as in the site
    std::array<double, levels> zones_ha{};  ///< by level: of the layer hazard_zones; of `none` it has none
    std::vector<Level>
        without{};  ///< of the targets by hazard.rule in the run of risk.without; empty: not known
};

/// How many rocks of a return period arrive at a target; NaN: not known, or no forest.
struct PeriodArrivals {
    std::size_t target = 0;  ///< as in the site
    double return_period_years = 0.0;
    std::uint64_t bare_rocks = 0;  ///< how many arrive over the bare slope
    double bare_percent = std::numeric_limits<double>::quiet_NaN();
    double forest_percent = bare_percent;
    double protection_percent = bare_percent;
    double protection_low_percent = bare_percent;
    double protection_high_percent = bare_percent;
    std::array<TargetHits, rockfall::covers> hits{};  ///< by cover
    /// 95 % interval of the share with all that is not known of ground and trees, by cover; empty where no
    /// parameters were drawn.
    std::array<std::optional<Interval>, rockfall::covers> with_all_percent{};
};

/// From the tables that the runs of the return periods have written, target by target. Throws
/// config::InputError (file, data) for tables that are missing or none.
std::vector<PeriodArrivals> arrivals_of(const std::vector<FinishedPeriod>& periods, const Site& site);

/// Everything that the hazard map is made of, and the map.
struct HazardResults {
    const Scenario& scenario;
    const Site& site;  ///< of the longest return period
    const Matrix& matrix;
    std::vector<FinishedPeriod> periods;  ///< rising
    std::vector<ZoneRocks> rocks;
    std::vector<SlopeHazard> slopes;  ///< with forest where there is one, then bare
    std::vector<PeriodArrivals> arrivals;
    std::vector<PeriodDesign> designs;      ///< with design.rule
    std::vector<PeriodBarrier> barriers;    ///< with nets or works, by rising return period
    std::optional<risk::RiskResults> risk;  ///< with risk.assess
    std::vector<InputFile> inputs;          ///< of all return periods, each once
    const config::Warnings& warnings;
    std::string version;
};

/// The return period whose rocks leave the terrain most on a slope.
const FinishedPeriod& leaves_most(const std::vector<FinishedPeriod>& periods, Cover cover);

/// Levels of all targets of a slope by hazard.rule, or by the rule that it is compared with.
std::vector<Level> levels_of_targets(const SlopeHazard& slope, RuledLevel TargetHazard::*by);

/// What the forest lowers and raises; nothing where there is none.
std::optional<ForestChanges> changes_by_forest(const HazardResults& results);

/// Plan area with a level of a raster of levels; none: all other ground.
double level_area_ha(const config::Raster<float>& map, const Site& site, Level level);

/// The hazard of a slope, from the rasters that the runs of the return periods have written. Throws
/// config::InputError (file, data) for rasters that are missing or none. The periods have their hits.
SlopeHazard slope_hazard(Cover cover, const std::vector<FinishedPeriod>& periods, const Scenario& scenario,
                         const Site& site, const Matrix& matrix);

/// From so many rocks of a class on it is known how often they hit. [choice] The 95 % interval of 20 is 12 to
/// 31.
inline constexpr std::uint64_t least_rocks_of_class = 20;

/// From so many rocks on an energy is known: 20 for the 95th percentile, 1 for mean and largest.
std::uint64_t least_rocks(HazardEnergy energy);

/// Warns of levels at targets that are given by too few rocks for hazard.energy, or by `cadanav` of a class.
void warn_of_few_rocks(const HazardResults& results, config::Warnings& warnings);

/// Stem of the raster that holds an energy: "E_95".
std::string stem_of(HazardEnergy energy);

/// Tables of the hazard map: hazard_….csv.
const std::vector<TableLayout>& hazard_layouts();
/// Writes them, those of targets where there are any.
std::vector<WrittenFile> write_tables(const HazardResults& results, const std::filesystem::path& folder);

/// Writes rasters, tables, summary.json and report.html into a folder that exists.
std::vector<WrittenFile> write_results(const HazardResults& results, const std::filesystem::path& folder,
                                       const WriteWatch& watch = {});

/// Stem of the raster of the levels by the rule that it is compared with: "Hazard_level_release".
std::string compared_stem(const HazardResults& results);

/// Columns of the rasters, for the dictionary.
std::vector<Column> hazard_raster_columns(const HazardResults& results);

/// summary.json.
void write_summary(std::ostream& out, const HazardResults& results, const std::vector<WrittenFile>& files);

/// The page.
void write_page(std::ostream& out, const HazardResults& results, const std::vector<WrittenFile>& files);

}  // namespace coupling::hazard
