#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coupling {
struct Scenario;
}

namespace coupling::decades {

/// Years with rocks, cut into blocks that are made, kept and read together. Depends on the scenario alone.
class YearBlocks {
public:
    explicit YearBlocks(const Scenario& scenario);
    [[nodiscard]] std::size_t count() const { return (years_.size() + years_each - 1) / years_each; }
    [[nodiscard]] std::span<const std::int32_t> years(std::size_t block) const;
    /// Requires a year with rocks.
    [[nodiscard]] std::size_t block_of(std::int32_t year) const;
    [[nodiscard]] bool with_cells(std::int32_t year) const;

    static constexpr std::size_t years_each = 10;

private:
    std::vector<std::int32_t> years_;  ///< rising
    std::vector<int> map_years_;
};

}  // namespace coupling::decades
