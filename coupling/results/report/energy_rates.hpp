#pragma once

#include <array>
#include <span>
#include <string>

#include "coupling/results/figures/figures.hpp"

namespace coupling::report {

/// A row of the table of rocks above given energies.
struct EnergyRates {
    std::string name;  ///< HTML
    std::array<Share, rockfall::counted_energies_j.size()> above;
};

/// Rocks above 30, 100, 300 and 1000 kJ per 1000 released, with their 95 % intervals. HTML; a table without
/// rows is empty.
std::string energy_rates_table(const std::string& first_head, std::span<const EnergyRates> rows);

}  // namespace coupling::report
