#include "coupling/assessments/decades/members/year_blocks.hpp"

#include <algorithm>

#include "coupling/assessments/decades/members/judged_cuts.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"
#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling::decades {

YearBlocks::YearBlocks(const Scenario& scenario)
    : years_{rock_years_of(scenario)},
      map_years_{chosen_years(scenario.forest.map_years, scenario.run.years)} {}

std::span<const std::int32_t> YearBlocks::years(std::size_t block) const {
    const std::size_t first = block * years_each;
    return std::span{years_}.subspan(first, std::min(years_each, years_.size() - first));
}

std::size_t YearBlocks::block_of(std::int32_t year) const {
    const auto place = std::lower_bound(years_.begin(), years_.end(), year) - years_.begin();
    return static_cast<std::size_t>(place) / years_each;
}

bool YearBlocks::with_cells(std::int32_t year) const {
    return std::find(map_years_.begin(), map_years_.end(), year) != map_years_.end();
}

}  // namespace coupling::decades
