#pragma once

namespace forest {

/// Mean light among leaves of an optical depth, relative to that above them [0, 1]: (1 - e^-t) / t.
/// `depth` >= 0.
double mean_light_within(double depth);

/// Optical depth of a crown along its shadow [-]: extinction * leaf area / (1.5 * the area it covers on the
/// map). Light comes from the side too, so a crown shades more ground than it covers; the factor is fitted to
/// the growth of trees in the open against that in dense stands (validation/forest_demography).
/// `radius_m` > 0.
double crown_depth(double extinction, double leaf_area_m2, double radius_m);

/// What leaves absorb where they hang, relative to leaves that are spread over the whole column [0, 1].
///
/// The light model spreads the leaves of a cell evenly. Where crowns fill it, that is right; a crown that
/// stands in the open has its leaves on little ground, and they shade each other more than the column says.
/// Both depths are for vertical rays; the mean ray through a canopy is half as long again.
double absorption_when_clumped(double crown_depth, double column_depth);

}  // namespace forest
