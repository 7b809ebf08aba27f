#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tests/runs/years.hpp"

namespace coupling {

/// Blocks of four return periods from the one zone of the project.
inline void add_blocks(const SampleProject& project) {
    project.write("blocks.csv",
                  "return_period_years,zone,diameter_m\n10,1,0.3\n30,1,0.5\n100,1,0.8\n300,1,1.2\n");
    project.replace("scenario.ini", "diameter_m = 0.5\n", "");
    project.replace("scenario.ini", "[targets]", "[hazard]\nblocks = blocks.csv\n[targets]");
}

inline constexpr const char* quick_hazard = "run scenario.ini --quiet --set release.rocks=400 ";

/// The row of a target on a slope.
inline std::size_t row_of(const config::Table& targets, const std::string& target, const std::string& cover) {
    for (std::size_t row = 0; row < targets.rows(); ++row) {
        if (targets.text(row, "target_id") == target && targets.text(row, "cover") == cover) {
            return row;
        }
    }
    ADD_FAILURE() << target << ' ' << cover;
    return 0;
}

}  // namespace coupling
