#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "coupling/assessments/models/figures/comparison.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::models {

/// A page beside this one.
struct LinkedPage {
    std::string file;                  ///< below the folder of the page
    double return_period_years = 0.0;  ///< 0: none
};

/// What the page says beside the figures.
struct PageContext {
    const Scenario& scenario;
    std::vector<std::string> warnings;  ///< of the runs, each behind the names of its models
    std::vector<LinkedPage> runs;       ///< pages of the models, in their order
    std::vector<LinkedPage> details;    ///< distributions and maps side by side
};

/// The models side by side as one self-contained HTML page: the range of the main figures over the models,
/// whether they disagree and which is judged best on each; which model for what; all figures, a column a
/// model.
void write_page(std::ostream& out, const Comparison& comparison, const PageContext& context);

}  // namespace coupling::models
