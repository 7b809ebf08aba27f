#pragma once

#include <cstddef>
#include <vector>

#include "config/table/table.hpp"

namespace coupling::plausible {

/// Rows of a list of trees that were filled in another way than the rest of it: a median over the whole list
/// (units.hpp, odd_trees.hpp) does not show them.
struct UnlikeTrees {
    /// Rows that hold girths among rows with diameters.
    std::vector<std::size_t> girth_lines;
    /// Rows that are too slender as they stand and like the others with `dbh_cm` and `height_m` exchanged.
    /// They say why trees look odd; by themselves they prove nothing.
    std::vector<std::size_t> swapped_lines;
};

/// Holds living trees with `dbh_cm` and `height_m` against trees of the same list.
///
/// - A girth is 3.14 times a diameter. Trees of 10 cm or more are girths where they are 2.2 to 5 times as
///   thick as the lower 40 % of the trees of their height, are less than 40 times as high as thick, are five
///   or more and 3 % of the list, and gather at 3.14 times: more lie within 2.6 to 4.3 times than within 1.8
///   to 2.6 times, where a tail of thick trees would have most of its trees [choice]. Of nine stands and
///   lists in the open (26 000, 4 458, 1 926, 333, 277, 110 and 108 trees, among them thinned spruce, mixed
///   mountain forest and mixed-age fir and beech) 0 to 0.5 % are so thick, and none gather.
/// - A tree looks swapped where it is at least as high as thick 100 times, 1.57 times as high as the trees of
///   its diameter, and within 1.35 times of the trees of the other one when exchanged [choice]. Of up to a
///   tenth of swapped rows in random mixed-age lists it finds those with 1.5 times as many cm of diameter as
///   m of height: 43 % in lists of 20 trees, 71 % of 30, 87 % of 40, 93 % of 60, 95 % from 100 on; others
///   look like another tree of the list with their fields swapped. Right rows are named in one of 1000 lists
///   of 20 trees, and in none of 6000 from 60 on.
///
/// Nothing is said of fewer than 20 trees.
UnlikeTrees unlike_trees(const config::Table& table);

}  // namespace coupling::plausible
