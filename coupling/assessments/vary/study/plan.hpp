#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "config/options/options.hpp"
#include "config/table/declared.hpp"
#include "config/table/table.hpp"

namespace coupling::vary {

/// More runs than this are a mistake in the table [choice].
inline constexpr std::size_t most_combinations = 500;

/// A setting of a scenario and the values that it takes.
struct Factor {
    std::string setting;  ///< section.key
    std::vector<std::string> values;
    bool crossed = false;  ///< with all other crossed ones; else moved alone
    config::Place place{};
};

/// Settings of one run of the study.
struct Combination {
    std::vector<std::string> values;  ///< of each factor; "": as in the scenario
    std::string alone;  ///< the setting that is moved alone; "" of the scenario and crossed ones

    /// "section.key=value" of what differs from the scenario.
    [[nodiscard]] std::vector<std::string> overrides(const std::vector<Factor>& factors) const;
};

struct FactorRow;
const config::Schema<FactorRow>& factor_columns();

/// Throws InputError (data) with every problem, for more than `most_combinations` too.
std::vector<Factor> read_factors(const config::Table& table);

/// The scenario itself, then each value of the factors that are moved alone, then all crossed combinations.
std::vector<Combination> combinations_of(const std::vector<Factor>& factors);

/// Finds the factors that change nothing, since another setting that they need has the wrong value in each of
/// their runs.
class IdleFactors {
public:
    explicit IdleFactors(const std::vector<Factor>& factors) : factors_{factors}, uses_(factors.size()) {}

    void see(const Combination& combination, const config::Options& options);
    /// Throws InputError (data) that names all of them.
    void refuse() const;

private:
    struct Uses {
        bool acts = false;
        std::string other;  ///< "release.rocks is 100", of the first run
    };

    const std::vector<Factor>& factors_;
    std::vector<Uses> uses_;
};

}  // namespace coupling::vary
