#pragma once

#include <cstdint>
#include <optional>

#include "forest/disturbance/disturbance.hpp"
#include "forest/stand/self_thinning.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// A year's storm over the whole area.
struct Storm {
    double intensity = 0.0;    ///< [0, 1]
    double towards_rad = 0.0;  ///< where it blows to, counter-clockwise from east
};

/// Coefficients of a species: a + a_size r + b I s^c is the logit of its chance to be thrown.
struct StormResponse {
    double intercept = 0.0;
    double relative_size = 0.0;  ///< of the diameter relative to the stand's
    double intensity = 0.0;
    double size_power = 0.0;
};

/// Trees thinner than this are not thrown: the law was fitted to inventories from 10 cm on.
inline constexpr double least_thrown_cm = 10.0;

/// Intensity that a share `u` of storms stays below: quantile of Beta(1.2, 4) [choice]. `u` in [0, 1).
double storm_intensity(double u);

/// The storm of a year, if there is one: by chance one in storm_interval_years, any direction alike [choice].
/// One that is asked for goes before it, with its own intensity and the direction that chance has for the
/// year.
std::optional<Storm> storm_of_year(const DisturbanceLaw& law, std::uint64_t seed, std::uint32_t replicate,
                                   int year);

/// The published response of spruce, fir, Scots pine or beech: by genus, other conifers as pine, other
/// broadleaves as beech [choice].
StormResponse storm_response_of(const Species& species);

/// Chance of a tree to die in a storm year: logistic(a0 + a1 r + b I s^c), s = max(-0.722 + 0.007283 D, 0.01)
/// with D in mm and r = -0.0949 + 2.8315 ln(D / Dg) (Barrere et al. 2023). `mean_dbh_cm` is the quadratic
/// mean diameter around it.
double storm_death(const StormResponse& response, double dbh_cm, double mean_dbh_cm, double intensity);

/// Share of thrown stems that are uprooted [0, 1]: the moment that the stem takes, MOR pi D^3 / 32,
/// against that of the roots, 1.85 Creg times the dry stem mass (iLand wind); both scatter, so that the share
/// is 1 / (1 + (roots / stem)^5) [choice]. Rot weakens the stem.
double uprooted_share(const Species& species, const Tree& tree);

/// Applies a storm: thrown trees leave for Cause::wind and lie in its direction, 30 degrees either way
/// [choice], whole or broken off at 1 to 5 m [choice]. Chance is drawn by tree and year.
void throw_by_wind(Stand& stand, const SpeciesTable& species, const ThinningWindows& windows,
                   const Storm& storm, std::uint64_t seed, std::uint32_t replicate);

}  // namespace forest
