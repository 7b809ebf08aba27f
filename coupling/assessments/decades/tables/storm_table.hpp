#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::decades {

/// A storm of a replicate. It depends on seed, replicate and calendar year alone: all regimes and climates of
/// a replicate have the same ones. What they throw differs with what stands.
struct StormYear {
    std::uint32_t replicate = 0;  ///< from 0
    std::int32_t year = 0;        ///< of the run
    std::int32_t calendar_year = 0;
    double intensity = 0.0;    ///< [0, 1]
    double towards_deg = 0.0;  ///< where it blows to, clockwise from north
};

/// All storms of a run by replicate and year; empty without disturbance.wind and disturbance.storm_years.
std::vector<StormYear> storm_years(const Scenario& scenario, int first_calendar_year);

TableLayout storms_layout();

/// Writes tables/storms.csv; nothing without disturbance.wind and disturbance.storm_years.
std::vector<WrittenFile> write_storms(const std::filesystem::path& folder, const Scenario& scenario,
                                      int first_calendar_year);

}  // namespace coupling::decades
