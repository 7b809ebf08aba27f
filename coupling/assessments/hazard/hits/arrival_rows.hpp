#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>

#include "coupling/assessments/hazard/hits/block_rows.hpp"
#include "coupling/inputs/site.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling::hazard::hits {

/// A row of arrivals.csv of a finished return period.
struct ArrivalRow {
    std::uint64_t rock = 0;
    std::size_t block_row = 0;  ///< of `BlockRows`
    std::size_t target = 0;     ///< as in the site
    rockfall::Cover cover = rockfall::Cover::bare;
    double energy_kj = 0.0;
};

/// Hands over the rows one after the other: there may be many millions. Throws config::InputError (data) for
/// a rock or a target that the site does not have, and for a table that the run did not write.
void for_each_arrival(const std::filesystem::path& file, const Site& site, const BlockRows& blocks,
                      const std::function<void(const ArrivalRow&)>& take);

}  // namespace coupling::hazard::hits
