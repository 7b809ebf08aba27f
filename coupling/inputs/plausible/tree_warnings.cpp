#include "coupling/inputs/plausible/tree_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/inputs/plausible/odd_trees.hpp"
#include "coupling/inputs/plausible/unlike_trees.hpp"

namespace coupling::plausible {
namespace {

using config::joined;
using Lines = std::vector<std::size_t>;

/// Those of the lines that are among others, which are in ascending order.
Lines among(const Lines& lines, const Lines& others) {
    Lines both;
    std::copy_if(lines.begin(), lines.end(), std::back_inserter(both),
                 [&](std::size_t line) { return std::binary_search(others.begin(), others.end(), line); });
    return both;
}

/// What was found and what to do where trees are too slender, with the cause if the list shows it.
struct Slender {
    std::string found;
    std::string advice;
};

Slender slender(bool look_swapped, const Lines& swapped, const std::string& found, const char* otherwise) {
    if (!look_swapped || swapped.empty()) {
        return {found, otherwise};
    }
    return {joined(found, "; ", std::to_string(swapped.size()), " of them, the first in line ",
                   std::to_string(swapped.front()), ", fit the other trees with dbh_cm and height_m swapped"),
            "exchange dbh_cm and height_m where they are swapped"};
}

void judge_slender(const OddTrees& odd, const Lines& swapped, const std::string& file, Reading& reading) {
    constexpr const char* expected = "trees 60 to 130 times as high as thick";
    // One cause for both: a squat tree whose fields are swapped fits no other one when exchanged.
    Lines all = odd.slender_lines;
    all.insert(all.end(), odd.impossible_lines.begin(), odd.impossible_lines.end());
    const bool look_swapped = 2 * among(all, swapped).size() > all.size();
    if (!odd.slender_lines.empty() && !odd.columns_look_swapped) {
        const Slender words =
            slender(look_swapped, among(odd.slender_lines, swapped),
                    counted(odd.slender_lines.size(), "tree") + " more than 150 times as high as thick",
                    "check whether dbh_cm (cm) and height_m (m) are swapped there");
        reading.warn({file, odd.slender_lines.front()}, words.found, expected, words.advice,
                     config::Effect::answer);
    }
    if (odd.impossible_lines.empty()) {
        return;
    }
    const config::Place place{file, odd.impossible_lines.front()};
    const Slender words = slender(look_swapped, among(odd.impossible_lines, swapped),
                                  counted(odd.impossible_lines.size(), "tree") +
                                      " of 5 m or more and more than 300 times as high as thick",
                                  "write dbh_cm in centimetres and height_m in metres there");
    if (odd.are_impossible) {
        reading.refuse(place, words.found, expected, words.advice);
    } else {
        reading.warn(place, words.found, expected, words.advice, config::Effect::answer);
    }
}

void judge_girths(const OddTrees& odd, const Lines& girths, const std::string& file, Reading& reading) {
    constexpr const char* expected = "diameters in cm: a girth is 3.14 times as much";
    const bool has_slenderness = odd.girth_slenderness > 0.0;
    if (has_slenderness || odd.girth_median_cm > 0.0) {
        const auto whole = [](double value) { return std::to_string(std::lround(value)); };
        reading.warn({file},
                     has_slenderness ? joined("half of the trees less than ", whole(odd.girth_slenderness),
                                              " times as high as thick: dbh_cm looks like girths")
                                     : joined("half of the trees thicker than ", whole(odd.girth_median_cm),
                                              " cm: dbh_cm looks like girths"),
                     expected, "divide the column dbh_cm by 3.14159 if it holds girths",
                     config::Effect::answer);
    } else if (!girths.empty()) {
        reading.warn(
            {file, girths.front()},
            joined(counted(girths.size(), "tree"),
                   " about 3 times as thick as other trees of their height, the last in line ",
                   std::to_string(girths.back()), ": dbh_cm looks like girths in these rows"),
            expected,
            "divide dbh_cm by 3.14159 where it is a girth; broken and open-grown trees may be as thick",
            config::Effect::answer);
    }
}

}  // namespace

void judge_odd_trees(const config::Table& table, Reading& reading) {
    const OddTrees odd = odd_trees(table);
    const UnlikeTrees unlike = unlike_trees(table);
    if (!odd.lines.empty()) {
        reading.warn({table.file(), odd.lines.front()},
                     counted(odd.lines.size(), "tree") +
                         " thicker than 200 cm, or less than 15 times as high as thick",
                     "trees 60 to 130 times as high as thick", "check dbh_cm (cm) and height_m (m)");
    }
    judge_slender(odd, unlike.swapped_lines, table.file(), reading);
    judge_girths(odd, unlike.girth_lines, table.file(), reading);
    if (odd.columns_look_swapped) {
        reading.warn({table.file()},
                     "most trees of 20 cm or more that are more than 110 times as high as thick",
                     "thick trees 40 to 100 times as high as thick",
                     "check whether the columns dbh_cm and height_m are swapped, or dbh_cm in inches",
                     config::Effect::answer);
    }
}

}  // namespace coupling::plausible
