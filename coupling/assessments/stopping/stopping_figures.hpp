#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/stopping/stopping_recipe.hpp"
#include "rockfall/virtual_surface/estimate.hpp"

namespace coupling {

/// How much is thrown at the surfaces of a recipe.
struct ThrowPlan {
    std::vector<double> diameters_m;  ///< of the rocks, rising
    std::uint32_t surfaces = 32;      ///< of each description, at least 2
    std::uint32_t throws = 20'000;    ///< of each diameter at each surface; a tenth as many rocks are rolled
    std::uint64_t seed = 1;
    int threads = 0;  ///< 0: as many as the machine has
};

/// Rocks of the shipped table: from 0.1 to 3 m in steps of about 1.4, those of the published experiments
/// (0.95 m at Vaujany, 1.84 m at Steg) among them.
std::vector<double> usual_diameters_m();

/// What one ground type does to rocks of one size.
struct StoppingFigures {
    double diameter_m = 0.0;
    rockfall::SurfaceEstimate stop;     ///< probability that an impact stops the rock [-]
    rockfall::SurfaceEstimate rolling;  ///< rate at which it is caught while it rolls [1/m]
};

/// What came of the virtual surfaces of one ground type.
struct SurfaceFigures {
    SurfaceRecipe recipe;
    std::vector<StoppingFigures> sizes;
    double mean_cover = 0.0;         ///< of the surfaces as laid [-]
    double mean_projection_m = 0.0;  ///< height of the blocks over the ground, weighted by plan area
    std::uint64_t throws = 0;        ///< of each diameter, over all surfaces
    std::uint32_t surfaces = 0;
};

/// Lays the surfaces and throws and rolls the rocks. `done` is called, one thread at a time, after each
/// surface; where it returns false the work ends early, and the result is empty.
///
/// Each surface has random numbers of its own, keyed by the seed and its number: the result is the same for
/// any number of threads, and for a recipe with or without other rows.
std::vector<SurfaceFigures> throw_at_surfaces(std::span<const SurfaceRecipe> recipes, const ThrowPlan& plan,
                                              const std::function<bool()>& done);

/// The table as the program reads it: a row for each surface and diameter, probabilities and rates with
/// standard errors. `made_by` stands above it as comment lines.
void write_stopping_table(std::span<const SurfaceFigures> surfaces, const std::string& made_by,
                          std::ostream& out);

/// A few diameters of each surface for the screen, in per cent.
void write_overview(std::span<const SurfaceFigures> surfaces, std::ostream& out);

}  // namespace coupling
