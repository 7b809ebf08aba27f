#include <limits>

#include "coupling/assessments/stopping/stopping_table.hpp"
#include "coupling/program/commands.hpp"
#include "coupling/program/line/arguments.hpp"

namespace coupling {
namespace {

constexpr const char* stopping_table_help = R"(bannwald stopping-table [RECIPE.csv] --out DIR [options]

Lays blocks on virtual surfaces as the recipe describes them (default: the shipped ground types), throws
rocks at them and writes stopping.csv: the chance that an impact stops a rock, by surface and diameter, with
standard errors. A recipe with a column `code` makes a table for terrain.stopping of a scenario.
`bannwald info stopping_recipe` prints the shipped recipe, to be changed.
  --out DIR                 folder of stopping.csv and the pictures
  --surface NAME            only this surface of the recipe; again for more
  --diameters 0.5,1,2       diameters of the rocks, m
  --throws N                throws of each diameter at each surface (default: 20000)
  --surfaces N              surfaces of each description, all different (default: 32)
  --seed N                  other random numbers (default: 1)
  --threads N               threads to use; results do not depend on it (default: all of the machine)
  --pictures                draws the first surface of each description (SVG) and its triangles (PLY)
  --overwrite               replaces a table and pictures that the folder holds
)";

int stopping_table(const Arguments& arguments, const Call& call) {
    StoppingTableRequest request{.recipe = arguments.words().empty() ? "" : arguments.only_word(),
                                 .out = arguments.out(),
                                 .names = arguments.texts("surface"),
                                 .plan = {},
                                 .pictures = arguments.has("pictures"),
                                 .overwrite = arguments.overwrite(),
                                 .quiet = arguments.quiet()};
    if (!arguments.has("out")) {
        refuse_usage("`bannwald stopping-table` without a folder for the table", "--out DIR");
    }
    const std::vector<double> diameters_m =
        arguments.rising_metres("diameters", {.low = 0.0, .high = 10.0, .low_excluded = true});
    request.plan.diameters_m = diameters_m.empty() ? usual_diameters_m() : diameters_m;
    request.plan.throws =
        static_cast<std::uint32_t>(arguments.whole("throws", 10, 10'000'000).value_or(request.plan.throws));
    request.plan.surfaces =
        static_cast<std::uint32_t>(arguments.whole("surfaces", 4, 10'000).value_or(request.plan.surfaces));
    constexpr long long largest_seed = 9'007'199'254'740'992;  // whole numbers of a double end here
    request.plan.seed = static_cast<std::uint64_t>(
        arguments.whole("seed", 0, largest_seed).value_or(static_cast<long long>(request.plan.seed)));
    request.plan.threads = arguments.threads();
    return make_stopping_table(request, call.out);
}

}  // namespace

Command stopping_table_command() {
    return {.name = "stopping-table",
            .overview =
                R"(  bannwald stopping-table [RECIPE]     makes stopping probabilities from virtual surfaces
)",
            .help = stopping_table_help,
            .argument = "a recipe",
            .options = {out_folder_option(),
                        {.name = "surface", .may_come_again = true},
                        option_with_value("diameters"),
                        option_with_value("throws"),
                        option_with_value("surfaces"),
                        seed_option(),
                        threads_option(),
                        switch_option("pictures"),
                        overwrite_option()},
            .completion = {Completion::Names::files},
            .run = stopping_table};
}

}  // namespace coupling
