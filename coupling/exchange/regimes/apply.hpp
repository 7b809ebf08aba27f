#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "coupling/exchange/regimes/regime.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"
#include "forest/treatment/felling.hpp"
#include "forest/year.hpp"

namespace coupling {

/// What a regime remembers of earlier years. A value: kept and restored with the stand, it goes on the same.
struct RegimeState {
    /// The last time an intervention came to an area.
    struct Visit {
        std::uint32_t intervention = 0;  ///< place in Regime::interventions()
        std::uint32_t area = 0;          ///< Area::number
        std::int32_t year = 0;
        friend bool operator==(const Visit&, const Visit&) = default;
    };
    /// The last clear cut of an area: from here its age counts.
    struct Clearing {
        std::uint32_t ground = 0;  ///< Regime::ground_of
        std::uint32_t area = 0;
        std::int32_t year = 0;
        friend bool operator==(const Clearing&, const Clearing&) = default;
    };
    /// An area where a row cut or salvaged, and on which another row acts. Its number is that of the cut,
    /// from 0. Of a salvage and of a fell_list it is the patches that lost stems.
    struct Cut {
        std::uint32_t intervention = 0;
        std::int32_t year = 0;
        Area area;
        friend bool operator==(const Cut&, const Cut&) = default;
    };
    std::vector<Cut> cuts;            ///< in the order in which they were made
    std::vector<Visit> visits;        ///< by intervention and area, each once
    std::vector<Clearing> clearings;  ///< by ground and area, each once

    friend bool operator==(const RegimeState&, const RegimeState&) = default;
};

/// An intervention in a year: done, or due without finding anything to do.
struct Entry {
    int year = 0;
    std::string intervention;
    Treatment treatment = Treatment::thin_below;
    std::size_t areas = 0;                       ///< that it came to
    double area_ha = 0.0;                        ///< of them; of a group cut the holes
    double stems = 0.0;                          ///< felled; of salvage taken
    double taken_m3 = 0.0;                       ///< stem wood over bark that left the forest
    double left_m3 = 0.0;                        ///< stem wood that stayed as logs and stumps
    std::uint64_t plants = 0;                    ///< planted
    std::uint64_t guarded = 0;                   ///< of these, each with a guard
    std::uint64_t tended = 0;                    ///< young stems cut by tending
    double tended_ha = 0.0;                      ///< of the patches where it cut any
    double fenced_ha = 0.0;                      ///< of the patches that are fenced longer than before
    std::vector<forest::PatchId> cut_patches{};  ///< that lost a tree by a cut, rising, each once
    [[nodiscard]] bool found_nothing() const {
        return stems == 0.0 && plants == 0 && tended == 0 && fenced_ha == 0.0;
    }
};

/// What a regime did in a year.
struct RegimeReport {
    std::vector<Entry> entries;  ///< in the order of the work: by Intervention::order, then by row
    forest::Timber timber;       ///< of all of them
};

/// Does what is due in a year of the run (from 0) and remembers it.
///
/// First all rows are judged by the stand as it is: which areas are due. Then they mark their trees one after
/// the other, by Intervention::order and then by row, each among those that the ones before have left. Rows
/// that act on the cuts of another row see those of the same year, unless they cut themselves. Then the
/// marked trees are felled, logs left, dead wood salvaged, young growth tended, fences set up, and last
/// planted, each step in that order. Where a salvage took stems is known after it: rows that act on that
/// ground in the same year are judged then, by the stand after felling and salvage. An area that was due
/// counts as visited even where nothing was found.
///
/// Requires a stand on the grid that the regime was read for.
RegimeReport apply(const Regime& regime, int year, forest::Stand& stand, const forest::SpeciesTable& species,
                   RegimeState& state, const forest::YearKey& key);

}  // namespace coupling
