#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/table/declared.hpp"
#include "coupling/inputs/forest/climate_input.hpp"
#include "coupling/inputs/forest/forest_species.hpp"
#include "coupling/inputs/places/records.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "forest/start/starting_dead_wood.hpp"
#include "forest/start/starting_stand.hpp"
#include "forest/year.hpp"

namespace coupling {

struct TreeAreaRow;
const config::Schema<TreeAreaRow>& tree_area_columns();

/// One of the climates that a forest may live in.
struct SiteClimate {
    std::string name;  ///< of the table of climates; `only_climate` without one
    ClimateSource source;
    std::vector<double> usual_summer_mm;  ///< precipitation of June to August in a mean year, by site unit
};

/// A forest with all that its years need, read, checked and valid. Shared by all replicates; never changes.
///
/// All coordinates are absolute, as in the files. The terrain of the rocks has an origin of its own
/// (Site::origin_m).
struct ForestSite {
    ForestSpecies species;
    forest::Parameters parameters;
    forest::PatchGrid grid;  ///< cells of 10 m at multiples of 10 m; management_unit is the stand number
    forest::Site place;
    /// One or more. The first is that in which the forest of the start grew up: its warmth gives missing
    /// heights, its radiation the share of diffuse light in all of them.
    std::vector<SiteClimate> climates;
    std::vector<forest::Tree> listed;            ///< trees of the list that grow, and
    std::vector<forest::StandRecord> inventory;  ///< by rising stand number; both empty: bare ground
    std::vector<forest::OnPatches<forest::DeadWoodRecord>> dead_wood;  ///< at the start
    std::vector<forest::OnPatches<forest::SaplingRecord>> saplings;    ///< at the start
    std::vector<TreeRecord>
        obstacles;  ///< trees of the list on no patch, which stand as they are; with rocks on the terrain
    int spin_up_years = 0;  ///< that make the dead wood and saplings which no file gives (spin_up.hpp)
    int run_years = 0;      ///< of the run: their weather serves the spin-up

    /// Calendar year of the first simulated year, in all climates.
    [[nodiscard]] int first_year() const { return climates.front().source.first_year; }
    /// The forest at the beginning with its dead wood and saplings, in the calendar year before the first
    /// simulated one. A list gives the same trees to all replicates, an inventory other places in each.
    [[nodiscard]] forest::Stand start(std::uint64_t seed, std::uint32_t replicate) const;
    /// The weather of a calendar year in one of the climates, for Stand::year() + 1. The change of climate is
    /// in it. Chance is that of the replicate alone: climates with the same years of a series draw the same
    /// ones. Refers to the site.
    [[nodiscard]] YearWeather weather(std::size_t climate, int calendar_year, std::uint32_t replicate) const;
};

/// Opens, reads and checks everything about the forest on heights in absolute coordinates (NaN: no ground;
/// `heights_file` names them in messages). Nothing where something is wrong: what, is in reading.problems().
/// Requires scenario.run.years > 0.
std::shared_ptr<ForestSite> open_forest(const config::Raster<double>& heights_m,
                                        const std::string& heights_file, Reading& reading);

}  // namespace coupling
