#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "forest/deadwood/decay_class.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"
#include "forest/stand/stand_balance.hpp"

namespace forest {

/// Diameter classes of stand tables: 4 cm wide, the last one open; the first begins at the smallest tree.
inline constexpr double dbh_class_cm = 4.0;
inline constexpr std::size_t dbh_classes = 30;

/// Class of a diameter: 0 for [0, 4) cm, ...
std::size_t dbh_class_of(double dbh_cm);

/// Trees of a stand from a diameter on, as inventories count them.
struct ThickTrees {
    double stems_pha = 0.0;
    double basal_area_m2pha = 0.0;
    double volume_m3pha = 0.0;  ///< stem wood over bark
};

/// Smallest diameters that inventories count: of wood (7 cm), of trees (12 cm, as in Switzerland).
inline constexpr std::array<double, 2> counted_from_cm{7.0, 12.0};

/// What foresters say of a stand, per hectare. Of trees of at least 1 cm diameter.
struct StandFigures {
    double stems_pha = 0.0;
    double basal_area_m2pha = 0.0;
    double volume_m3pha = 0.0;       ///< stem wood over bark
    double above_ground_tpha = 0.0;  ///< dry mass, stems with their basic density
    double mean_dbh_cm = 0.0;        ///< quadratic; 0 without trees
    double lorey_height_m = 0.0;     ///< mean weighted by basal area; 0 without trees
    double dominant_height_m =
        0.0;  ///< mean of the 100 thickest stems per hectare, of all where there are fewer
    double leaf_area_index = 0.0;  ///< projected, as the light model has it
    std::array<double, dbh_classes> stems_pha_by_class{};
    std::array<ThickTrees, counted_from_cm.size()> from{};  ///< by counted_from_cm
};

/// Figures of some trees on an area. Requires an area above 0.
StandFigures figures_of(std::span<const Tree> trees, const SpeciesTable& species, double area_ha);

/// The same by species, in the order of the table. Dominant height is that of the species' own thickest
/// stems.
std::vector<StandFigures> figures_by_species(std::span<const Tree> trees, const SpeciesTable& species,
                                             double area_ha);

/// Young trees below 1 cm diameter, per hectare. Heights are means of cohorts.
struct YoungFigures {
    double saplings_pha = 0.0;
    double from_20cm_pha = 0.0;
    double on_wood_pha = 0.0;   ///< on rotten logs and stumps
    double in_reach_pha = 0.0;  ///< of deer: 0.1 to 1.3 m
    double browsed_pha = 0.0;   ///< of these, whose leading shoot deer took within the year
};

/// Young trees of the patches that a rule takes: of all species, and behind that by the species table.
std::vector<YoungFigures> young_figures_of(const Stand& stand, const std::function<bool(const Patch&)>& takes,
                                           double area_ha);

/// What left a stand in a year for one cause, per hectare.
struct Loss {
    double stems_pha = 0.0;
    double volume_m3pha = 0.0;
    double above_ground_tpha = 0.0;
};

/// A stand in one year: state, growth, ingrowth and losses.
struct StandYear {
    int year = 0;
    StandFigures all;
    std::vector<StandFigures> by_species;
    double volume_increment_m3pha = 0.0;  ///< by growth of the trees that began the year
    double ingrowth_stems_pha = 0.0;      ///< trees that passed 1 cm or were planted
    std::array<Loss, cause_count> losses{};
    std::vector<std::array<Loss, cause_count>> losses_by_species;  ///< by the species table
    double saplings_pha = 0.0;                                     ///< below 1 cm
    double snags_pha = 0.0;
    double logs_pha = 0.0;
    double snags_m3pha = 0.0;      ///< standing dead wood, stumps of felling included
    double logs_m3pha = 0.0;       ///< lying dead wood
    double dead_stems_tpha = 0.0;  ///< dry mass of both, as far as it has not rotted
    std::array<double, decay_class_count> dead_wood_m3pha{};  ///< both together by decay class, 1 first
};

/// The year of a whole landscape. `volume_increment_m3` is of its whole area.
StandYear year_of(const Stand& stand, const SpeciesTable& species, double volume_increment_m3);

}  // namespace forest
