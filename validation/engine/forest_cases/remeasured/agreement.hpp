#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "validation/engine/forest_cases/remeasured/trial.hpp"
#include "validation/engine/forest_cases/shared/comparison.hpp"

namespace coupling::validation::forest_cases::remeasured {

/// Trees of a species, or all, and of a class of diameter at the start, or all.
struct TreeGroup {
    std::optional<forest::SpeciesId> species{};
    std::optional<std::size_t> size{};  ///< place in the classes

    friend bool operator==(const TreeGroup&, const TreeGroup&) = default;
};

/// A case as it was read.
struct RemeasuredData {
    forest::SpeciesTable species;
    MeasuredStand stand;
    forest::Parameters parameters;
    RemeasuredSettings settings;
    std::vector<forest::SpeciesId> kinds;  ///< of the plot, by the species table
};

/// Groups that have trees: all and each species, by class.
std::vector<TreeGroup> groups_of(const RemeasuredData& data);

/// What the two measurements say of a group.
struct Observed {
    std::size_t trees = 0;      ///< at the start, without those felled
    std::size_t survivors = 0;  ///< of these
    double increment_cm = 0.0;  ///< mean of the survivors, a year

    [[nodiscard]] double survival() const {
        return static_cast<double>(survivors) / static_cast<double>(trees);
    }
};

Observed observed_of(const RemeasuredData& data, const TreeGroup& group);

/// Mean diameter of each tree of the first measurement at the end, over the replicates in which it stands,
/// and the share of these.
struct TreeMeans {
    std::vector<double> end_dbh_cm;  ///< 0 where it never stands
    std::vector<double> survival;
};

TreeMeans means_of(const RemeasuredData& data, const std::vector<Regrown>& runs);

/// Simulated figures of a group, of the trees that the observed ones are.
struct Simulated {
    double survival = 0.0;
    std::optional<double> increment_cm{};  ///< of the trees that survived in the plot
    std::optional<double> bias_cm{};       ///< of their diameters at the end
    std::optional<double> rmse_cm{};
};

Simulated simulated_of(const RemeasuredData& data, const TreeGroup& group, const TreeMeans& means);

/// Living trees from the least diameter on at the end, per hectare.
struct EndStand {
    double stems_pha = 0.0;
    double basal_area_m2pha = 0.0;
    double ingrown_pha = 0.0;
};

/// Of a species, or of all.
EndStand observed_end(const RemeasuredData& data, const std::optional<forest::SpeciesId>& species);
/// The same, mean of the replicates.
EndStand simulated_end(const RemeasuredData& data, const std::optional<forest::SpeciesId>& species,
                       const std::vector<Regrown>& runs);

}  // namespace coupling::validation::forest_cases::remeasured
