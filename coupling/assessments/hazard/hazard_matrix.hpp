#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/table/declared.hpp"
#include "config/table/table.hpp"

namespace coupling::hazard {

/// How much a place is in danger, in the colours of Swiss hazard maps.
enum class Level : std::uint8_t {
    none,
    residual,  ///< yellow and white: rarer than what planning reckons with
    low,       ///< yellow
    moderate,  ///< blue
    high,      ///< red
};
inline constexpr std::array<const char*, 5> level_names{"none", "residual", "low", "moderate", "high"};
constexpr std::size_t levels = level_names.size();

constexpr const char* level_name(Level level) {
    return level_names[static_cast<std::size_t>(level)];
}

struct MatrixRow;
const config::Schema<MatrixRow>& matrix_columns();

/// Which level an energy and a return period have together.
///
/// A class of energy holds its lower end and goes up to the next one; a class of return periods ends with its
/// upper end. Source: config/data/hazard_matrix.csv.
class Matrix {
public:
    /// Throws config::InputError (data) for fields that are none, pairs that are missing or doubled, and
    /// classes that do not begin with 0 kJ or do not end without end.
    static Matrix read(const config::Table& table);
    /// The one that is shipped.
    static Matrix shipped();

    [[nodiscard]] std::size_t intensities() const { return energy_from_kj_.size(); }
    [[nodiscard]] std::size_t frequencies() const { return return_period_to_years_.size(); }
    /// Lower ends, rising from 0.
    [[nodiscard]] std::span<const double> energy_from_kj() const { return energy_from_kj_; }
    /// Upper ends, rising to infinity.
    [[nodiscard]] std::span<const double> return_period_to_years() const { return return_period_to_years_; }

    /// Number of the class, from 0. Requires energy_kj >= 0.
    [[nodiscard]] std::size_t intensity_of(double energy_kj) const;
    /// Number of the class, from 0. Requires return_period_years > 0.
    [[nodiscard]] std::size_t frequency_of(double return_period_years) const;
    [[nodiscard]] Level at(std::size_t intensity, std::size_t frequency) const {
        return levels_[intensity * frequencies() + frequency];
    }

    /// "below 30 kJ", "30 to 300 kJ", "from 300 kJ".
    [[nodiscard]] std::string intensity_name(std::size_t intensity) const;
    /// "up to 30 years", "30 to 100 years", "over 300 years".
    [[nodiscard]] std::string frequency_name(std::size_t frequency) const;

private:
    std::vector<double> energy_from_kj_;
    std::vector<double> return_period_to_years_;
    std::vector<Level> levels_;  ///< by intensity, then by frequency
};

}  // namespace coupling::hazard
