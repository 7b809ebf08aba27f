#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace forest {

/// How the trees of a stand differ in size and lie about.
enum class Structure : std::uint8_t {
    even_aged,    ///< one layer; trees keep their distance
    two_layered,  ///< half of the stems half as thick as the others; trees keep their distance
    plenter,      ///< many thin, few thick trees (single-tree selection), at random
    groups,       ///< one layer in clusters of 6 m radius
};

/// Diameters of a number of trees with a quadratic mean, in falling order.
///
/// Even-aged and groups: Weibull, shape 3.3. Two-layered: two of them. Plenter: exponential from 1 cm on,
/// which at a mean of 25 cm is the exp(-0.06 D) of selection forests. They are the quantiles of the law, not
/// draws from it, scaled to the mean asked for: the same record always gives the same stand. None above
/// `largest_cm`, so the mean may be missed there.
///
/// Requires a mean of at least 1 cm and below largest_cm.
std::vector<double> stand_diameters_cm(Structure structure, std::size_t trees, double mean_dbh_cm,
                                       double largest_cm);

}  // namespace forest
