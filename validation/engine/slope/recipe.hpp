#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "config/options/options.hpp"
#include "rockfall/parameters.hpp"
#include "validation/engine/case/case_files.hpp"
#include "validation/engine/slope/relief.hpp"

namespace coupling::validation {

enum class CaseKind : std::uint8_t {
    slope,              ///< a profile with a cross-section: rocks move in three dimensions, trees may stand
    profile,            ///< the two-dimensional mode: no deviation, no trees
    factors,            ///< forest against bare slope over several settings (factors.hpp)
    field,              ///< rocks of a scenario against stops observed on real ground (field_case.hpp)
    collapse,           ///< a rock mass that breaks up (collapse_case.hpp)
    forest_production,  ///< the production core against other programs (forest_cases)
    forest_light,       ///< light in a mapped stand against another program
    forest_years,       ///< a scenario over years against what is known of such forests (years/)
};

/// Whether no rock falls in it.
constexpr bool is_forest(CaseKind kind) {
    return kind >= CaseKind::forest_production;
}

/// Section [case], which every kind has.
struct CaseHead {
    std::string title;
    std::string citation;
    CaseKind kind = CaseKind::slope;
    std::string rebuilt;
};

/// A line across the slope at which arrivals are looked at.
struct Station {
    std::string name;
    double distance_m = 0.0;  ///< in plan from the upper end
};

/// How much of a stand's basal area one species has.
struct SpeciesShare {
    std::string code;
    double share = 0.0;            ///< of the basal area [0, 1]
    double fracture_energy = 1.0;  ///< relative to Abies alba [-]
};

/// The settings of one variant of a case: its case.ini with overrides, all checked.
struct Recipe {
    CaseHead head;

    // [rock]
    double diameter_m = 1.0;
    double density_kgpm3 = 2700.0;
    double start_height_m = 1.5;  ///< of the underside; 0 starts rolling
    double start_speed_mps = 3.0;
    double start_dip_deg = 30.0;

    // [series]
    std::uint64_t seed = 1;
    std::uint64_t rocks = 10'000;
    std::uint64_t series = 100;
    std::uint64_t rocks_per_series = 100;
    std::uint64_t choice_rocks = 2'000;

    // [terrain]
    std::string profile = "profile.csv";
    double width_m = 120.0;
    double channel_depth_m = 0.0;
    double channel_half_width_m = 10.0;
    double cell_m = 2.5;
    double relief_m = 0.0;
    std::uint64_t relief_seed = 1;
    std::string relief_file;
    double relief_shift_m = 0.0;
    double relief_across_m = 0.0;
    double slope_change_deg = 0.0;

    // [stand]
    double stems_per_ha = 0.0;
    double dbh_mean_cm = 30.0;
    double dbh_deviation_cm = 10.0;
    std::string species_text;
    double stand_from_m = 0.0;
    double stand_to_m = 0.0;
    double spacing_m = 0.5;
    std::uint64_t stands = 1;

    // [stations], [surfaces]
    std::string station_names;
    std::vector<double> station_distances_m;
    double p_stop_factor = 1.0;
    double rt_change = 0.0;
    double rn_change = 0.0;

    // [rockfall], [tree_impact]
    std::string preset = "default";
    rockfall::Parameters rockfall;

    // Worked out of the above.
    std::vector<Station> stations;
    std::vector<SpeciesShare> species;
    Relief relief;                             ///< of terrain.relief_file
    std::unique_ptr<config::Options> options;  ///< as declared, for listings and places

    [[nodiscard]] bool has_stand() const { return stems_per_ha > 0.0; }
};

/// Declares [case].
void declare(config::Options& options, CaseHead& head);
/// Declares every setting of a case with rocks. The options keep references into the recipe: it must not move
/// after.
void declare(config::Options& options, Recipe& recipe);

/// The recipe of a case with `section.key=value` overrides, later ones winning; the named set of settings is
/// the override rockfall.preset=strict. The section [factors] is left to factors.hpp. Throws InputError with
/// every problem found.
std::unique_ptr<Recipe> read_recipe(const CaseFiles& files, const std::vector<std::string>& overrides);

/// A case without a kind is one of rocks on a slope if its files describe a slope. Throws InputError
/// (settings) for a kind that there is not, and for no kind without a slope.
void require_kind(const CaseFiles& files);

/// Title and kind of a case, read without checking the rest; a kind that there is not stays `slope`.
CaseHead head_of(const CaseFiles& files);

}  // namespace coupling::validation
