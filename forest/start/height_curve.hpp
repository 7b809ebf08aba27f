#pragma once

#include <span>

#include "forest/stand/species.hpp"

namespace forest {

/// Height by diameter in a stand: H = 1.3 + (D / (a + b D))^3 (Petterson 1955), D in cm, H in m.
struct HeightCurve {
    double a = 1.0;  ///< > 0
    double b = 0.3;  ///< > 0

    /// Requires a diameter above 0. Above 1.3 m.
    [[nodiscard]] double height_m(double dbh_cm) const;
};

/// The curve through the mean tree on which a tree twice as thick is a quarter taller [choice].
/// Requires a diameter above 0 and a height above 1.5 m.
HeightCurve curve_through(double mean_dbh_cm, double mean_height_m);

/// Through the 108 trees of the plot Chablais 3 (French Prealps, mixed species, 5.5 to 62 cm), standard error
/// of one height 2.4 m: where a list has no heights to draw a curve through.
inline constexpr HeightCurve curve_of_prealps{.a = 2.449, .b = 0.2982};

/// A tree whose height was measured.
struct MeasuredHeight {
    double dbh_cm = 0.0;    ///< > 0
    double height_m = 0.0;  ///< > 1.3
};

/// A fitted curve and how well it fits.
struct HeightFit {
    HeightCurve curve;
    std::size_t trees = 0;          ///< it rests on; 0 = no fit possible
    double standard_error_m = 0.0;  ///< of a single height
};

/// Trees that a fit needs [choice].
inline constexpr std::size_t fewest_fitted_trees = 5;

/// Least squares on the straight form of the law, D / (H - 1.3)^(1/3) = a + b D. No fit (trees = 0) from
/// fewer than five trees, or where the best straight line does not rise from above 0.
HeightFit fit_heights(std::span<const MeasuredHeight> measured);

/// Height of a tree that has grown from a recruit of 1 cm and 2 m to its diameter in three quarters of the
/// light [choice; the heights of yield tables at a diameter lie near it] at a place with these degree-days
/// above 5.5 degC: where no height was measured. Height growth by diameter, less what the place's greatest
/// height leaves (forest/stand/height_growth.hpp, forest/stand/site_height.hpp), summed in steps of 0.5 cm.
double height_by_growth(const Species& species, double dbh_cm, double degree_days);

/// Greatest height that a record of a tree may have [m]: 1.3 times the greatest height of the species (in
/// whole metres), which is that of closed stands on the warmest sites [choice; tallest firs of Europe are
/// near 60 m].
double greatest_recorded_height_m(const HeightGrowth& law);

}  // namespace forest
