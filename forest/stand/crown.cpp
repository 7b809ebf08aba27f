#include "forest/stand/crown.hpp"

#include <algorithm>

#include "config/math/elementary.hpp"
#include "forest/stand/allometry.hpp"

namespace forest {

namespace {

constexpr double least_crown_ratio = 0.12;
/// Trees more slender than any that the law was fitted to count as this one: 100 m/m.
constexpr double most_slender_m_pcm = 1.0;
constexpr double base_rise_by_shade =
    0.25;  // share of the usual base, per unit of light ratio below one half
constexpr double longest_branch_loss_m_pyear = 0.3;
constexpr double least_completeness = 0.7;
constexpr double most_completeness = 1.1;

double highest_base_m(double height_m) {
    return (1.0 - least_crown_ratio) * height_m;
}

}  // namespace

double crown_diameter_m(const Crown& shape, double dbh_cm, double height_m) {
    const auto& a = shape.diameter;
    const double ln_dbh = config::ln_of(dbh_cm);
    const double ln_height = config::ln_of(height_m);
    return config::exp_of(a[0] + a[1] * ln_dbh + a[2] * height_m + a[3] * (ln_height - ln_dbh));
}

double usual_crown_base_m(const Crown& shape, double dbh_cm, double height_m) {
    const auto& a = shape.base;
    const double slenderness = std::min(height_m / dbh_cm, most_slender_m_pcm);
    const double crown_ratio = config::exp_of(a[0] + a[1] * slenderness + a[2] * dbh_cm);
    return std::clamp(height_m * (1.0 - crown_ratio), 0.0, highest_base_m(height_m));
}

TreeCrown starting_crown(const Species& species, double dbh_cm, double height_m) {
    return {.base_m = usual_crown_base_m(species.crown, dbh_cm, height_m),
            .radius_m = 0.5 * crown_diameter_m(species.crown, dbh_cm, height_m),
            .completeness = 1.0,
            .leaf_area_m2 = leaf_area_m2(species, dbh_cm, 1.0)};
}

TreeCrown next_crown(const Species& species, const TreeCrown& crown, const CrownYear& year) {
    const double usual_base_m = usual_crown_base_m(species.crown, year.dbh_cm, year.height_m);
    const double by_competition_m = usual_base_m * (1.0 - base_rise_by_shade * (year.light_ratio - 0.5));
    const double aim_m =
        std::min(std::max(by_competition_m, year.shaded_below_m), highest_base_m(year.height_m));
    const double reachable_m = crown.base_m + year.height_growth_m + longest_branch_loss_m_pyear;

    TreeCrown next;
    next.base_m = std::max(crown.base_m, std::min(aim_m, reachable_m));
    next.radius_m = 0.5 * crown_diameter_m(species.crown, year.dbh_cm, year.height_m);
    next.completeness = std::clamp((year.height_m - next.base_m) / (year.height_m - usual_base_m),
                                   least_completeness, most_completeness);
    next.leaf_area_m2 = leaf_area_m2(species, year.dbh_cm, next.completeness);
    return next;
}

}  // namespace forest
