#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "forest/deadwood/decay_class.hpp"
#include "forest/stand/cohort.hpp"
#include "forest/stand/dead_wood.hpp"
#include "forest/stand/patch.hpp"
#include "forest/stand/species.hpp"

namespace forest {

enum class DeadWoodKind : std::uint8_t { snag, stump, log };

/// Dead wood of one species and kind as an inventory describes it.
struct DeadWoodRecord {
    SpeciesId species{};
    DeadWoodKind kind = DeadWoodKind::log;
    double volume_m3pha = 0.0;         ///< > 0, stem wood over bark
    double dbh_cm = 30.0;              ///< >= 7, of the trees that these pieces were
    std::optional<double> length_m{};  ///< > 0, of the log, or height of what stands; else the whole tree
    int decay_class = 1;               ///< 1-5
    std::optional<double> to_fall_line_deg{};  ///< of logs, either way; else as stems fall: down with scatter
    bool anchored = false;                     ///< logs behind stumps
};

/// Young trees below 1 cm of one species.
struct SaplingRecord {
    SpeciesId species{};
    double stems_pha = 0.0;                   ///< > 0
    double height_m = 0.3;                    ///< (0, 1.9], mean
    int age_years = 3;                        ///< >= 0
    std::optional<double> browsed_percent{};  ///< [0, 100], leading shoots browsed in a year; changes no stem
};

/// Where records of dead wood or saplings hold.
template <class Record>
struct OnPatches {
    std::vector<PatchId> patches{};  ///< at least one
    std::vector<Record> records{};
    double degree_days = 0.0;  ///< a year; heights of the dead trees follow from it
};

/// Pieces of dead wood with the volumes of the records, at random places of their patches: as many as the
/// volume of one goes into that of the record, the last one by chance, so that the mean over replicates is
/// the record's. They died in `year` or so long before as their density says at 10 degC.
///
/// Numbers of these trees count from 2^47, above those of living ones.
SnagsAndLogs dead_wood_from_records(std::span<const OnPatches<DeadWoodRecord>> stands, const PatchGrid& grid,
                                    const SpeciesTable& species, int year, std::uint64_t seed,
                                    std::uint32_t replicate);

/// A cohort for each patch and record; stems are rounded by chance.
std::vector<Cohort> cohorts_from_records(std::span<const OnPatches<SaplingRecord>> stands, std::uint64_t seed,
                                         std::uint32_t replicate);

}  // namespace forest
