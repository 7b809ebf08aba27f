#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <vector>

#include "coupling/assessments/hazard/hazard_rules.hpp"
#include "coupling/assessments/hazard/hits/block_rows.hpp"
#include "coupling/inputs/scenario/hazard_settings.hpp"
#include "coupling/inputs/site.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling::hazard {

/// The rocks of a return period that hit a target on a slope: their paths meet its line or its walls.
struct TargetHits {
    std::uint64_t rocks = 0;                 ///< how many hit it
    std::vector<std::uint64_t> rocks_above;  ///< by class of energy: with its lower end and above
    /// The same as rocks of one weight, of whose number a frequency is as well known: rocks of rows with few
    /// of them weigh more. (Sum of the weights)² divided by the sum of their squares, rounded down.
    std::vector<std::uint64_t> even_rocks_above;
    RocksAtPlace at_place;  ///< the same for each release of each zone
    double largest_kj = 0.0;
};

/// Of how many rocks of one weight a sum of weights, with the sum of their squares, would be as well known.
std::uint64_t even_rocks(double weights, double squares);

/// By target, then by cover.
using HitsOfTargets = std::vector<std::array<TargetHits, rockfall::covers>>;

/// From targets.csv and arrivals.csv of a finished return period, whose `site` has its sources.
///
/// Each row of hazard.blocks releases one rock in its return period: hits are divided by the rocks of their
/// row and added up over the rows. Without arrivals.csv (output.arrivals = no) neither rows nor all classes
/// are known: then all hits count for the row with the fewest rocks, and a class begins at the next energy
/// below it that targets.csv counts, so that hits are rather too frequent. Throws config::InputError (file,
/// data) for tables that are missing or that the run did not write.
HitsOfTargets hits_of(const std::filesystem::path& folder, const Site& site, const hits::BlockRows& blocks,
                      const Matrix& matrix, HazardEnergy energy);

}  // namespace coupling::hazard
