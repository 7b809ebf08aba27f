#pragma once

namespace forest {

/// Diameter at breast height of a tree of which a laser scan knows the height alone: D = a H^b, times
/// exp(s z), D in cm, H in m.
///
/// Fitted to the plot Chablais 3 (French Prealps, 1350 m; 50 conifers and 56 broadleaves, 3 to 31 m). Judged
/// on stands that the fit has not seen, measured against the law: fir and spruce at Prenovel (Jura) -5 and
/// -12 %, old spruce in Fennoscandia -2 %, beech at Prenovel +26 %, birch in Fennoscandia +27 %; a planted
/// even-aged spruce stand is a third thinner (Hauersteig).
struct DiameterOfHeight {
    double a_cm;    ///< of a tree of 1 m
    double b;       ///< [-]
    double spread;  ///< s: standard deviation of the logarithm of a single tree [-]

    /// Requires a height above 0. `normal`: z, a standard normal number.
    [[nodiscard]] double dbh_cm(double height_m, double normal) const;
};

inline constexpr DiameterOfHeight diameter_of_conifer{.a_cm = 1.28, .b = 1.085, .spread = 0.24};
inline constexpr DiameterOfHeight diameter_of_broadleaf{.a_cm = 1.11, .b = 1.032, .spread = 0.21};

/// How far the diameters of a whole stand may be off: standard deviation of their logarithm [-], by the
/// judged stands above.
inline constexpr double diameter_of_height_width = 0.22;

}  // namespace forest
