#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/inputs/observed/events.hpp"
#include "coupling/inputs/observed/stops.hpp"
#include "coupling/inputs/parameters/parameter_draws.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/figures/breakdown.hpp"
#include "coupling/results/figures/forest_bounds.hpp"
#include "rockfall/ensemble.hpp"
#include "rockfall/tally/impact_log.hpp"

namespace coupling {

struct Scenario;

/// A finished static assessment, ready to be written: everything counted, and what it was counted on.
struct RunResults {
    const Scenario& scenario;
    const Site& site;
    const rockfall::EnsembleTally& tally;
    /// Per-cell distributions by cover; null where no percentiles are wanted (or no forest is given).
    std::array<const rockfall::CellHistograms*, rockfall::covers> histograms;
    const std::vector<rockfall::PathRecord>& paths;  ///< sampled, in rock order
    const std::vector<NetRow>& net_rows;             ///< crossings of nets, in the order of rocks
    const config::Warnings& warnings;
    std::uint64_t rocks = 0;
    bool with_forest = false;  ///< false: neither trees nor logs, only the bare slope was assessed
    std::string version;
    std::vector<observed::StopComparison> observed_stops{};    ///< empty where none were observed
    std::vector<observed::EventComparison> observed_events{};  ///< empty where none were observed
    std::vector<rockfall::RockImpacts> impacts{};              ///< where wanted, of the rocks of `paths`
    Breakdown breakdown{};                                     ///< arrivals by place, zone and size
    const ParameterDraws* draws = nullptr;  ///< of what is not known; null: nothing was drawn
    std::optional<ForestBounds> bounds{};   ///< of trees that are derived
    std::vector<NetRow> work_rows{};        ///< rocks at works; `net` is the number of the work
    std::filesystem::path net_paths{};      ///< stored paths of all rocks without nets; empty: not kept
};

}  // namespace coupling
