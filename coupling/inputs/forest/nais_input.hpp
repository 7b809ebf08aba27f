#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/table/declared.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "forest/protection/nais.hpp"
#include "forest/stand/patch.hpp"

namespace coupling {

/// What a profile asks of a stand in one respect.
struct NaisRow {
    std::uint32_t stand = 0;  ///< 0: all stands
    std::string site_type;
    std::string hazard;
    forest::NaisCriterion criterion;
    forest::NaisLimit minimal;
    std::optional<forest::NaisLimit> ideal;
    std::string minimal_text;
    std::string ideal_text;
    std::string source;  ///< the file, or where a shipped profile comes from
};

struct NaisTableRow;
const config::Schema<NaisTableRow>& target_profile_columns();

/// The rows of stands.target_profile, in the order of the file. A row of a stand replaces that of `all` with
/// the same hazard and criterion. Refuses unknown criteria and stands, limits that are none, ideals outside
/// of the minimum, rows that come twice. `effective_cm`: diameter from which on stems count against the
/// rocks, 0: not known.
std::optional<std::vector<NaisRow>> read_nais_profile(const forest::SpeciesTable& species,
                                                      const forest::PatchGrid& grid, double effective_cm,
                                                      Reading& reading);

/// The shipped profile against rockfall for a diameter of the rocks, marked as it is; empty above the largest
/// class of the guideline.
std::vector<NaisRow> shipped_nais_profile(double block_diameter_m);

}  // namespace coupling
