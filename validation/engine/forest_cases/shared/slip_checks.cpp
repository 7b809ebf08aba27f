#include "validation/engine/forest_cases/shared/slip_checks.hpp"

#include <cmath>
#include <numbers>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/climate_at.hpp"
#include "coupling/inputs/plausible/odd_trees.hpp"
#include "coupling/results/text/markup.hpp"
#include "forest/stand/allometry.hpp"

namespace coupling::validation::forest_cases {
namespace {

using config::joined;
using report::fixed;

constexpr double most_basal_area_m2pha = 100.0;
constexpr double most_crown_cover = 2.5;

/// Sum over the numbers of a column; 0 without it.
template <class Of>
double sum_over(const config::Table& table, const char* column, Of of) {
    double sum = 0.0;
    for (std::size_t row = 0; row < table.rows() && table.has(column); ++row) {
        sum += of(config::parse_number(table.text(row, column)).value_or(0.0));
    }
    return sum;
}

}  // namespace

void warn_of_trees(const config::Table& trees, double area_ha, config::Warnings& warnings) {
    const plausible::OddTrees odd = plausible::odd_trees(trees);
    if (!odd.lines.empty()) {
        warnings.add(joined(trees.file(), ", line ", std::to_string(odd.lines.front()), ": ",
                            std::to_string(odd.lines.size()), odd.lines.size() == 1 ? " tree" : " trees",
                            " thicker than 200 cm, or less than 15 times as high as thick; check dbh_cm (cm) "
                            "and height_m (m)"));
    }
    if (odd.columns_look_swapped) {
        warnings.add(joined(trees.file(),
                            ": most trees of 20 cm or more are more than 110 times as high as thick; check "
                            "whether the columns dbh_cm and height_m are swapped"));
    }
    const double basal_area_m2pha =
        sum_over(trees, "dbh_cm", [](double dbh_cm) { return forest::basal_area_m2(dbh_cm); }) / area_ha;
    if (basal_area_m2pha > most_basal_area_m2pha) {
        warnings.add(joined(trees.file(), ": trees that make ", fixed(basal_area_m2pha, 0),
                            " m2/ha of basal area, more than stands have; check dbh_cm (diameters and no "
                            "girths, in cm) and the size of the plot"));
    }
    const double cover = sum_over(trees, "crown_radius_m",
                                  [](double radius_m) { return std::numbers::pi * radius_m * radius_m; }) /
                         (10'000.0 * area_ha);
    if (cover > most_crown_cover) {
        warnings.add(joined(trees.file(), ": crowns that cover the plot ", fixed(cover, 1),
                            " times; check crown_radius_m: a radius and no diameter, and not swapped with "
                            "crown_base_m"));
    }
}

void warn_of_latitude(double latitude_deg, const config::Place& place, config::Warnings& warnings) {
    if (plausible::is_far_from_species(std::abs(latitude_deg))) {
        warnings.add(joined(place.file, place.line > 0 ? joined(", line ", std::to_string(place.line)) : "",
                            ": latitude ", config::to_text(latitude_deg),
                            "; the species are trees of Europe, from 30 to 70 degrees; write degrees with "
                            "decimals, such as 46.8"));
    }
}

void warn_of_radiation(double yearly_mjpm2, const std::string& radiation_file, config::Warnings& warnings) {
    if (yearly_mjpm2 < 1500.0 || yearly_mjpm2 > 9000.0) {
        warnings.add(joined(radiation_file, ": ", fixed(yearly_mjpm2, 0),
                            " MJ/m2 in a year, where 3000 to 7000 are usual; check global_mjpm2: sums of "
                            "months in MJ/m2"));
    }
}

}  // namespace coupling::validation::forest_cases
