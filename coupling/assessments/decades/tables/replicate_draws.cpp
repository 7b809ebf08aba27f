#include "coupling/assessments/decades/tables/replicate_draws.hpp"

#include <string>

#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site_draws.hpp"
#include "coupling/results/tables/table_of.hpp"

namespace coupling::decades {
namespace {

/// A factor on the laws of the fall or of the forest of a replicate.
struct ReplicateDraw {
    std::uint32_t replicate = 0;  ///< from 0
    std::string parameter;
    double width = 0.0;
    double factor = 1.0;
};

std::vector<ReplicateDraw> draws_of(const Scenario& scenario, const Site& site) {
    std::vector<ReplicateDraw> rows;
    for (std::uint32_t replicate = 0; replicate < scenario.forest.replicates; ++replicate) {
        const ParameterDraws draws = draw_of_replicate_on(scenario, site, replicate);
        for (std::size_t i = 0; i < draws.components.size(); ++i) {
            rows.push_back({replicate, draws.components[i].parameter, draws.components[i].width,
                            draws.factors.front()[i]});
        }
    }
    return rows;
}

TableOf<ReplicateDraw> draws() {
    return {
        "replicate_draws.csv",
        "What is not known of ground, trees and the growth of the forest, as drawn for each replicate but "
        "the first, which goes by the central values.",
        "a parameter of a replicate, the same in all regimes, climates and years",
        {{"replicate", "number of the replicate, from 1", "run.replicates",
          [](const auto& row) { return row.replicate + 1; }},
         {"parameter", "what is not known, as in parameter_widths", "definition", &ReplicateDraw::parameter},
         {"width", "-", 4, "standard deviation of ln(factor)", "run.parameters, else the shipped widths",
          &ReplicateDraw::width},
         {"factor", "-", 6, "the factor of the replicate", "drawn by seed and replicate",
          &ReplicateDraw::factor}}};
}

}  // namespace

TableLayout replicate_draws_layout() {
    return draws();
}

std::vector<WrittenFile> write_replicate_draws(const std::filesystem::path& folder, const Scenario& scenario,
                                               const Site& site) {
    const std::vector<ReplicateDraw> drawn = draws_of(scenario, site);
    if (drawn.empty()) {
        return {};
    }
    return {draws().write(folder, [&](auto& rows) {
        for (const ReplicateDraw& row : drawn) {
            rows.add(row);
        }
    })};
}

}  // namespace coupling::decades
