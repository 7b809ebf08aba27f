#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "coupling/assessments/stopping/stopping_figures.hpp"

namespace coupling {

/// What `bannwald stopping-table` is asked for.
struct StoppingTableRequest {
    std::filesystem::path recipe;    ///< "": the shipped one
    std::filesystem::path out;       ///< folder of the table and the pictures
    std::vector<std::string> names;  ///< surfaces of the recipe; none: all
    ThrowPlan plan;
    bool pictures = false;
    bool overwrite = false;
    bool quiet = false;
};

/// Makes the stopping table of a recipe, and pictures of its first surfaces, and prints an overview.
///
///     out/stopping.csv            the table
///     out/pictures/NAME.svg       with `pictures`: the surface from above, a cut, a scale
///     out/pictures/NAME.ply       the same as triangles
///
/// Returns the exit code: done, or interrupted, which leaves nothing behind. Throws config::InputError for a
/// recipe that is wrong (data), names that it lacks or files that are there already (settings), and where
/// it cannot write (file).
int make_stopping_table(const StoppingTableRequest& request, std::ostream& out);

}  // namespace coupling
