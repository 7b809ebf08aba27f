#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace coupling {

/// What is printed of a return period.
struct PeriodBlock {
    double years = 0.0;
    std::string text;  ///< lines
};

/// Lines that all periods have stand once, above those of each; of a single period all stand below it.
void print_blocks(const std::vector<PeriodBlock>& blocks, std::ostream& out);

}  // namespace coupling
