#pragma once

#include "forest/stand/species.hpp"

namespace forest {

/// Share of its prime production that a tree keeps as it grows tall and old (0, 1].
///
/// 1 / (1 + (x / c)^n) with x = 1 - 2 / (1 / (1 - h) + 1 / (1 - a)), the complement of the harmonic mean of
/// what is left of height and life: h the height relative to the greatest one of the place, a the age
/// relative to the greatest age (form of iLand, Seidl et al. 2012). A tall tree loses vigour at any age, an
/// old one at any height, a tree that is both by less than the sum. Values beyond 1 count as 1.
double vigour(const Vigour& law, double relative_height, double relative_age);

}  // namespace forest
