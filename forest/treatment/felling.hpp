#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "config/units/angle.hpp"
#include "forest/deadwood/deadwood.hpp"
#include "forest/inventory/tables.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"
#include "forest/treatment/area.hpp"
#include "forest/treatment/selection.hpp"

namespace forest {

/// What an intervention did with stems of one species and diameter class.
struct TimberClass {
    double stems = 0.0;
    double taken_m3 = 0.0;  ///< stem wood over bark that left the forest
    double left_m3 = 0.0;   ///< that stayed as logs and stumps
};

/// Timber by species (in the order of the table) and diameter class (forest/inventory/tables.hpp).
struct Timber {
    std::vector<std::array<TimberClass, dbh_classes>> by_species;

    [[nodiscard]] TimberClass total() const;
    Timber& operator+=(const Timber& other);
};

/// How trees are felled and what stays.
struct Felling {
    double stump_height_m = forest::stump_height_m;  ///< >= 0; 1.0-1.3 for high stumps
    double left_share = 0.0;    ///< [0, 1], of the felled stems from 15 cm on; usually 0.2-0.5
    double log_length_m = 0.0;  ///< of what is left; 0 = whole stems, else the thickest piece of it
    config::Angle to_fall_line = config::Angle::from_degrees(70.0);  ///< of the logs that are left
    bool anchored = true;       ///< behind stumps: loose logs roll once they are weak
    bool girdled = false;       ///< killed by a ring and left standing: no stump, no timber, no log
    double damage_share = 0.0;  ///< [0, 1], of standing trees within 5 m of a felled one that get a wound
};

/// Fells trees (places in trees(), each once): they leave the stand, stumps stay, and a share of the stems is
/// left lying obliquely across the slope, chosen by a number of each tree. Logs lie with half the clearance
/// of windthrow, for their branches are cut [choice]. Felling damage is a wound of 200 cm2 [choice].
///
/// Groups of young trees leave as a whole and leave no stumps.
Timber fell(Stand& stand, const SpeciesTable& species, std::span<const std::size_t> picks, const Felling& how,
            std::uint64_t seed, std::uint32_t replicate);

/// What a salvage did, and where.
struct Salvaged {
    Timber timber;
    std::vector<PatchId>
        patches{};  ///< on which stems were taken or laid across the slope, rising, each once
};

/// Takes dead wood of at most `oldest_years` out of an area: each snag and log with the chance `share`
/// (0-0.9, what access allows). Stumps and logs of felling stay. Felled snags leave a stump; a share of the
/// stems from 15 cm on is left lying obliquely across the slope as fell() leaves it: snags and thrown stems
/// alike.
Salvaged salvage(Stand& stand, const SpeciesTable& species, const TreatmentArea& area, double share,
                 int oldest_years, const Felling& how, std::uint64_t seed, std::uint32_t replicate);

}  // namespace forest
