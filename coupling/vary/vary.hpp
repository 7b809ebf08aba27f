#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "coupling/results/figures.hpp"
#include "coupling/vary/plan.hpp"

namespace coupling::vary {

/// What `bannwald vary` is asked for.
struct VaryRequest {
    std::filesystem::path scenario;
    std::filesystem::path factors;       ///< CSV: setting, values, how
    std::vector<std::string> overrides;  ///< of all runs
    std::filesystem::path out;
    int threads = 0;  ///< 0: as many as the machine has
    bool overwrite = false;
    bool quiet = false;
};

/// A target under one combination.
struct TargetOutcome {
    std::string id;
    std::string name;
    ArrivalFigures bare;
    ArrivalFigures forest;                       ///< empty without forest
    std::optional<ProtectionEffect> protection;  ///< nothing without forest or without arrivals
    bool too_few = false;                        ///< rocks that arrive, to speak of protection

    /// What the study is about: what the forest stops, else the share of rocks that arrive. NaN if unknown.
    [[nodiscard]] double answer(bool with_forest) const;
};

/// All of the run of one combination.
struct Outcome {
    Combination combination;
    bool with_forest = false;
    std::uint64_t rocks = 0;
    double run_out_mean_m = 0.0;  ///< of the rocks that stop, through the forest where there is one
    Share left_terrain;           ///< on the same slope
    std::vector<TargetOutcome> targets;
};

/// A scenario over years is a study of its regimes (regime_study.hpp).
///
/// Lets the rocks of a scenario of today fall with each combination of settings: the same rocks, as far as
/// the settings leave them the same. Writes vary.csv and report.html (tornado chart), prints an overview.
///
/// Returns the exit code: done, or interrupted, which leaves nothing behind. Throws config::InputError for
/// what is wrong in the table or in any combination, before any rock falls.
int vary_scenario(const VaryRequest& request, std::ostream& screen);

}  // namespace coupling::vary
