#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "coupling/results/figures/run_results.hpp"
#include "forest/inventory/tables.hpp"
#include "forest/protection/gaps.hpp"
#include "forest/protection/target_profile.hpp"

namespace coupling {

/// What the trees of a list are as a forest, where rocks cross it.
///
/// Its area is that of the cells of 10 m that rocks cross without forest and that have a living stem of 12 cm
/// within 30 m [choice]: gaps up to 60 m wide are part of the forest, scree and meadows beyond are not. Only
/// living stems count.
struct ForestToday {
    double area_ha = 0.0;
    std::uint64_t stems = 0;  ///< of the list, on this area
    double stems_pha = 0.0;
    double stems_from_12_cm_pha = 0.0;
    double basal_area_m2pha = 0.0;
    double mean_dbh_cm = 0.0;  ///< quadratic: of the stem of mean basal area

    struct Species {
        std::string code;
        double stems_pha = 0.0;
        double basal_area_m2pha = 0.0;
    };
    std::vector<Species> species;            ///< by falling basal area
    std::vector<double> stems_pha_by_class;  ///< in classes of forest::dbh_class_cm from 0 on
    forest::GapFigures gaps;
    double mean_block_m = 0.0;  ///< mean diameter of the rocks, for which the profile holds
    std::optional<forest::TargetProfile> profile;  ///< nothing for blocks larger than NaiS speaks of
    forest::ProfileCheck check;
};

/// Nothing without trees where rocks cross.
std::optional<ForestToday> forest_today(const RunResults& results);

}  // namespace coupling
