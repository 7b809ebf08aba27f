#pragma once

#include <numbers>

#include "forest/stand/species.hpp"

namespace forest {

/// Dry masses of one stem [kg].
struct PartMasses {
    double stem_kg = 0.0;
    double branch_kg = 0.0;
    double foliage_kg = 0.0;
    double coarse_root_kg = 0.0;

    [[nodiscard]] double above_ground_kg() const { return stem_kg + branch_kg + foliage_kg; }
};

/// Cross-section of a stem at 1.3 m [m2].
constexpr double basal_area_m2(double dbh_cm) {
    return std::numbers::pi / 40'000.0 * dbh_cm * dbh_cm;
}

/// factor * D^exponent. Requires a diameter above 0.
double at_dbh(const Power& power, double dbh_cm);

/// Volume of the stem over bark [m3]: form factor * cross-section * height. From about 15 cm diameter on
/// nearly all of it is coarse wood of 7 cm and more, which yield tables count.
double stem_volume_m3(const Allometry& allometry, double dbh_cm, double height_m);

/// Masses of a tree with a share `completeness` of the foliage of a tree of its diameter [iLand species
/// database]. Requires a diameter above 0.
PartMasses part_masses(const Allometry& allometry, double dbh_cm, double height_m, double completeness);

/// Dry mass above ground as tables report it [kg]: the stem with the basic density of its species instead of
/// the density that growth uses.
double reported_mass_kg(const Allometry& allometry, double above_ground_kg, double stem_kg);

/// Projected leaf area of one stem [m2].
double leaf_area_m2(const Species& species, double dbh_cm, double completeness);

}  // namespace forest
