#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "config/errors/warnings.hpp"
#include "forest/stand/patch.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/tree.hpp"
#include "forest/start/diameters.hpp"

namespace forest {

/// Trees below this diameter are no trees yet but cohorts.
inline constexpr double smallest_tree_cm = 1.0;

/// A mapped tree.
struct ListedTree {
    std::uint64_t id = 0;  ///< below 2^48, each once
    double x_m = 0.0;
    double y_m = 0.0;
    SpeciesId species{};
    double dbh_cm = 0.0;
    std::optional<double> height_m{};
    std::optional<double> age_years{};
};

/// The trees of a starting stand, in the order of the list.
struct StartingTrees {
    std::vector<Tree> trees;
    std::vector<std::size_t>
        outside;  ///< places in the list of trees on no patch: obstacles that do not grow
};

/// Trees from a list.
///
/// Missing heights are taken from a height curve fitted to the species' measured ones, else to all measured
/// ones, else from the law of growth for the site (`degree_days`, a year). Missing ages are diameter /
/// usual growth of the species, at most 0.6 of its greatest age [choice]. What was done is reported: heights
/// filled in, by which curve and with which error; heights of 1.3 m or less and heights beyond the greatest,
/// which are taken as missing; trees below 1 cm, which are left out; trees on no patch; trees on one spot.
///
/// Requires diameters above 0 and different ids.
StartingTrees trees_from_list(std::span<const ListedTree> list, const PatchGrid& grid,
                              const SpeciesTable& species, double degree_days, config::Warnings& warnings);

/// One species in a stand record. At least one of stems and basal area is given; if both are, mean DBH
/// follows from them and may be missing.
struct SpeciesRecord {
    SpeciesId species{};
    std::optional<double> stems_pha{};         ///< >= 0
    std::optional<double> basal_area_m2pha{};  ///< >= 0
    std::optional<double> mean_dbh_cm{};       ///< quadratic, >= 1
    std::optional<double> mean_height_m{};     ///< of the mean tree, > 1.5
    std::optional<double> age_years{};         ///< >= 0
    /// Ends of a diameter class: stems_pha then lie evenly between them, and mean_dbh_cm is its middle.
    std::optional<double> class_from_cm{};  ///< >= 1
    std::optional<double> class_to_cm{};    ///< > class_from_cm; both or neither
};

/// A stand as an inventory describes it.
struct StandRecord {
    std::vector<PatchId> patches{};  ///< at least one
    std::vector<double> cover{};     ///< crown cover of each patch [0, 1], one above 0; empty: all alike
    std::vector<SpeciesRecord> species{};
    Structure structure = Structure::even_aged;
    double degree_days = 0.0;  ///< a year; where no height is given
};

/// What a species record lacks or contradicts, in a sentence; empty if it is complete.
std::string missing_in(const SpeciesRecord& record);

/// Trees with diameters, heights and places of a stand record. Ids count from `first_id`.
///
/// Stems of diameter classes are rounded one after the other, so that their sum over the stand is right.
///
/// Heights follow a curve through the mean tree. Crowns are those that trees keep in each other's shade
/// (settled_crowns.hpp). Requires complete records (missing_in).
std::vector<Tree> trees_from_record(const StandRecord& record, const PatchGrid& grid,
                                    const SpeciesTable& species, std::uint64_t seed, std::uint32_t replicate,
                                    std::uint64_t first_id);

/// Age of a tree that no record gives: diameter / usual growth of the species, at most 0.6 of its greatest
/// age [choice].
double usual_age_years(const Species& species, double dbh_cm);

/// A tree of usual crown in full health. Requires a diameter above 0 and a height above 1.3 m.
Tree new_tree(const Species& kind, SpeciesId species, double x_m, double y_m, double dbh_cm, double height_m,
              double age_years);

}  // namespace forest
