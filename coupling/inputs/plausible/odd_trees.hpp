#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "config/table/table.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling::plausible {

/// Rows of a list that look like slips of single trees, which the medians of check_tree_units() do not show.
struct OddTrees {
    std::vector<std::size_t> lines;  ///< of living trees that are too thick, or too thick for their height
    std::vector<std::size_t> slender_lines;  ///< of living trees that are too high for their DBH
    std::vector<std::size_t>
        impossible_lines;  ///< of living trees of 5 m or more, over 300 times as high as thick [choice]
    bool are_impossible = false;  ///< five of these or more, or a tenth of the list [choice]: no slips
    bool columns_look_swapped = false;
    /// How many times half of the trees are as high as thick at most, where they look like girths; else 0.
    double girth_slenderness = 0.0;
    /// Median DBH of a list without heights that looks like one of girths; else 0 [cm].
    double girth_median_cm = 0.0;
};

/// - A living tree above 200 cm, or of 10 cm or more and less than 15 times as high as thick: stands have 60
///   to 130, old trees in the open 20.
/// - A living tree of 10 cm or more and more than 150 times as high as thick: the most slender of 27 000
///   trees in real lists are 148. So does every other tree look whose DBH and height are swapped.
/// - A living tree of 5 m or more and more than 300 times as high as thick: some diameters may be in metres.
///   Below 5 m real ones may be, as diameters are measured at 1.3 m.
/// - `dbh_cm` and `height_m` look swapped where most trees of 20 cm or more are more than 110 times as
///   high as thick: such trees break.
/// - Girths are pi times a diameter. They look so where half of ten trees or more of 10 cm are less than 32
///   times as high as thick; without heights where half of the trees are thicker than 90 cm.
///
/// All are choices with a wide margin around real inventories. Reads `dbh_cm`, and `height_m` and `state`
/// where the table has them; what is no number counts as unknown.
OddTrees odd_trees(const config::Table& table);

/// Lines of stand records whose mean tree is less than 15 times as high as thick, or more than 120 times,
/// from 20 cm on more than 100 times [choice]: dense pole stands reach 110. Below 10 cm nothing is odd. Reads
/// `mean_dbh_cm` and `mean_height_m`; rows without both are passed over.
std::vector<std::size_t> odd_mean_trees(const config::Table& table);

/// Warns where half of ten trees or more are higher than 45 m [choice]: few stands of Europe are. Heights of
/// trees without a DBH [m]: diameters follow from them, so that feet would make giants that stop every rock.
void judge_heights_without_dbh(std::vector<double> heights_m, const std::string& file, Reading& reading);

}  // namespace coupling::plausible
