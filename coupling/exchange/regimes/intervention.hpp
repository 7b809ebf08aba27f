#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "forest/stand/species.hpp"
#include "forest/treatment/area.hpp"
#include "forest/treatment/felling.hpp"
#include "forest/treatment/groups.hpp"
#include "forest/treatment/selection.hpp"

namespace coupling {

/// What is done. The first eleven cut trees.
enum class Treatment : std::uint8_t {
    thin_below,          ///< the thinnest, to a share of the basal area
    thin_density,        ///< the thinnest, down to a relative density
    thin_crop_trees,     ///< competitors of crop trees
    target_diameter,     ///< all from a diameter on
    selection,           ///< single trees, towards a selection forest
    shelter_cut,         ///< at random to a share of the basal area: opening of a shelterwood
    group_cut,           ///< all trees in holes where most wood stands
    thin_to_basal_area,  ///< the thinnest, down to a basal area
    thin_to_stems,       ///< the thinnest, down to the stems of a table for the age
    clear_cut,           ///< all trees: of strips, slits, stands; clearance of a shelterwood
    fell_list,           ///< the trees of a list, each in its year: a recorded cut
    salvage,
    tend,
    fence,  ///< keeps deer out for some years
    plant,
    plant_clusters,
};
inline constexpr std::size_t treatment_count = 16;

/// Where.
enum class Where : std::uint8_t {
    all,        ///< the whole forest as one area
    stands,     ///< management units, each an area of its own
    strips,     ///< side by side over the whole forest, each an area of its own
    slits,      ///< rungs of ladders, each an area of its own
    polygons,   ///< of a file, each an area of its own
    corridors,  ///< along lines of a file, each line an area of its own
    cuts_of,    ///< where another row cut or salvaged, each time an area of its own
};
inline constexpr std::size_t where_count = 7;

/// How the areas of an intervention lie. Two interventions on the same ground have the same areas.
struct Ground {
    Where where = Where::all;
    std::vector<std::uint32_t> stands{};  ///< management units; all of them where none is named
    std::string polygons{};               ///< name of a file
    std::string lines{};                  ///< name of a file
    std::string cuts_of{};                ///< name of the row that cut or salvaged there
    double from_slope_deg = 0.0;          ///< patches less steep are left out
    double to_slope_deg = 90.0;           ///< steeper ones too
    int entries = 1;                      ///< >= 1: parts of the ground that take turns
    double length_m = 50.0;
    double width_m = 15.0;
    double angle_deg = 45.0;  ///< of the long axis to the fall line
    double gap_m = 25.0;      ///< between two slits along the fall line
    double lines_m = 60.0;    ///< between two ladders

    friend bool operator==(const Ground&, const Ground&) = default;
};

/// A tree of a recorded cut.
struct ListedTree {
    std::uint64_t tree = 0;  ///< its number
    int year = 0;            ///< in which it is felled
    friend bool operator==(const ListedTree&, const ListedTree&) = default;
};

/// Stems of a stand at an age, as a yield table has them.
struct StemsAtAge {
    std::uint32_t stand = 0;  ///< management unit; 0: any
    double age_years = 0.0;
    double stems_pha = 0.0;
    friend bool operator==(const StemsAtAge&, const StemsAtAge&) = default;
};

/// One row of a regime: what, when, where, how much, what stays. Fields that mean nothing for its treatment
/// keep their defaults (coupling/exchange/regimes/columns.hpp has all of them in words).
struct Intervention {
    std::string name{};
    Treatment treatment = Treatment::thin_below;
    config::Place place{};  ///< of the row, for messages

    int first_year = 0;  ///< >= 0, years of the run from 0
    std::optional<int> every_years{};
    std::optional<int> last_year{};
    std::optional<int> order{};  ///< among the rows of a year: lower ones first
    std::string after{};         ///< name of another row
    int after_years = 0;
    std::optional<double> from_age_years{};
    std::optional<double> to_age_years{};
    std::optional<double> from_dominant_height_m{};
    std::optional<double> from_basal_area_m2pha{};
    std::optional<double> from_relative_density{};
    std::optional<double> from_damage_m3pha{};  ///< by wind, snow and beetles, in the year
    std::optional<double> from_gap_m{};         ///< longest along the fall line
    std::optional<double> to_gap_m{};

    Ground ground{};

    double share = 0.0;      ///< [0, 1], of what `treatment` takes from
    bool of_volume = false;  ///< `share` is of the volume instead of the basal area
    double target_density = 0.65;
    double from_dbh_cm = 0.0;
    double to_basal_area_m2pha = 0.0;                ///< that stays after thin_to_basal_area
    std::vector<forest::SpeciesId> only_species{};   ///< that are cut; all where none is named
    std::vector<forest::SpeciesId> spare_species{};  ///< that are not cut
    double retain_pha = 0.0;                         ///< thickest trees that stay
    forest::CropTreeThinning crop{};
    forest::SelectionForest selection{};
    forest::Groups groups{};
    forest::Felling felling{};
    int oldest_years = 2;
    std::string stems{};                 ///< name of a file with the stems of thin_to_stems
    std::vector<StemsAtAge> stems_at{};  ///< what stands in it, by stand and age
    std::string trees{};                 ///< name of a file with the trees of fell_list
    std::vector<ListedTree> listed{};    ///< what stands in it, by year and number

    std::vector<forest::SpeciesId> species{};
    std::vector<double> plants_pha{};
    double plant_height_m = 0.35;
    std::optional<double> where_fewer_pha{};
    double spacing_m = 20.0;
    double from_height_m = 0.5;
    double to_height_m = 5.0;
    int fence_years = 15;
    int guard_years = 0;  ///< of plants

    [[nodiscard]] bool cuts() const { return treatment <= Treatment::fell_list; }
    /// Whether it leaves a ground on which other rows can act (where = cuts_of).
    [[nodiscard]] bool leaves_ground() const { return cuts() || treatment == Treatment::salvage; }
    [[nodiscard]] bool plants() const { return treatment >= Treatment::plant; }
    /// Whether the state of an area decides, beside the calendar.
    [[nodiscard]] bool has_condition() const {
        return from_age_years || to_age_years || from_dominant_height_m || from_basal_area_m2pha ||
               from_relative_density || from_damage_m3pha || from_gap_m || to_gap_m;
    }
};

/// As they stand in tables.
std::string name_of(Treatment treatment);
std::string name_of(Where where);

}  // namespace coupling
