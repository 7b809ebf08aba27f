#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace coupling {

/// What a motion model is asked for, in the order of tables and pages.
inline constexpr std::array<std::string_view, 7> judged_quantities{"stops",  "spread", "sideways", "speed",
                                                                   "height", "energy", "rebounds"};

/// How many criteria of the shipped field cases a motion model meets with its default settings, in one
/// quantity.
struct QuantityVerdict {
    std::string quantity;
    std::uint64_t met = 0;
    std::uint64_t missed = 0;
    /// Of these, criteria that no ground type was fitted to and no slope rebuilt with.
    std::uint64_t independent_met = 0;
    std::uint64_t independent_missed = 0;

    [[nodiscard]] std::uint64_t criteria() const { return met + missed; }
    [[nodiscard]] std::uint64_t independent() const { return independent_met + independent_missed; }
};

/// Of all judged_quantities, those without any criterion too. From the shipped table `model_verdicts.csv`,
/// which `bannwald validate all` makes (validation/engine/update_readme.sh); cases are added up.
std::vector<QuantityVerdict> verdicts_on(std::string_view model);

/// "stops 5 of 12, spread 0 of 1, ...; energy not judged": independent criteria, for the screen.
std::string verdicts_in_words(std::string_view model);

}  // namespace coupling
