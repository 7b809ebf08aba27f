#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "coupling/inputs/places/records.hpp"
#include "rockfall/obstacles/stem.hpp"

namespace coupling {

/// The thinnest and the thickest forest that the trees of today may be, as far as they are derived.
struct BoundTrees {
    std::vector<rockfall::Stem> thin;
    std::vector<rockfall::Stem> thick;
};

/// Of tree tops: diameters that follow from heights 1.645 standard deviations of a whole stand below and
/// above the law (forest/start/diameter_of_height.hpp), other diameters as they are. In the thick forest
/// stand also the trees that a scan misses, as many for each tree as it misses of trees so high among those
/// around it
/// (`share_found`), of the tree's own size and within 10 m of it.
///
/// `seed` and the place of a tree in the list key what is drawn.
BoundTrees bounds_of_tops(std::span<const TreeRecord> trees, std::uint64_t seed);

/// Of stands: a quarter of the trees is missing, or as many more stand within 10 m of one as thick: 1.645
/// standard errors of 15 % [choice].
BoundTrees bounds_of_records(std::span<const TreeRecord> trees, std::uint64_t seed);

/// The share of trees of which a laser scan shows the top, by their height divided by that of the highest
/// tree around. From the scan of Chablais 3, of which the highest tree has 31 m: 4 of 18 from 5 to 10 m, 9 of
/// 31 to 15 m, 17 of 28 to 20 m, 21 of 26 above (README.md of coupling/inputs).
double share_found(double height_share);

}  // namespace coupling
