#pragma once

namespace forest {

// How species with different demands grow on soils with more or less nitrogen.

/// Growth by nitrogen [kg/ha/yr]: 1 - exp(k (N - least)), k and least by the species' demand, straight
/// between its classes 1 (frugal) to 3 (ForClim; classes of species: iLand).
double nitrogen_response(double nitrogen_class, double nitrogen_kg_per_ha_year);

/// That growth over the growth of a species of class 2, > 0: 1 where there is plenty, above 1 for frugal
/// species on poor soils, below 1 for demanding ones.
///
/// Fertility lowers the production of all species alike; this says what it is to each of them. Less than 30
/// kg/ha count as 30: class 2 ends at 25, and the ratio has no meaning near it.
double nitrogen_advantage(double nitrogen_class, double nitrogen_kg_per_ha_year);

}  // namespace forest
