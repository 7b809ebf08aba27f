#include "coupling/assessments/decades/tables/storm_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/tables/table_of.hpp"
#include "forest/disturbance/wind.hpp"

namespace coupling::decades {

std::vector<StormYear> storm_years(const Scenario& scenario, int first_calendar_year) {
    std::vector<StormYear> storms;
    const forest::DisturbanceLaw& law = scenario.forest.parameters.disturbance;
    const auto years = law.has_storms() ? static_cast<std::int32_t>(scenario.run.years) : 0;
    for (std::uint32_t replicate = 0; replicate < scenario.forest.replicates; ++replicate) {
        for (std::int32_t year = 1; year <= years; ++year) {
            const int calendar_year = first_calendar_year - 1 + year;
            const auto storm = forest::storm_of_year(law.in_year(calendar_year), scenario.run.seed, replicate,
                                                     calendar_year);
            if (storm) {
                const double east_deg = storm->towards_rad * 180.0 / std::numbers::pi;
                storms.push_back(
                    {replicate, year, calendar_year, storm->intensity, std::fmod(450.0 - east_deg, 360.0)});
            }
        }
    }
    return storms;
}

namespace {

TableOf<StormYear> storms() {
    constexpr const char* drawn = "drawn by seed, replicate and calendar year";
    return {"storms.csv",
            "The storms of each replicate: the same in all regimes and climates.",
            "a storm of a replicate, the same in all regimes and climates",
            {{"replicate", "number of the replicate, from 1", "run.replicates",
              [](const auto& storm) { return storm.replicate + 1; }},
             {"year", "simulated years since the start", drawn, &StormYear::year},
             {"calendar_year", "calendar year", "run.first_year", &StormYear::calendar_year},
             {"intensity", 4, "0 to 1",
              "Beta(1.2, 4) [choice]; disturbance.storm_years_intensity in disturbance.storm_years",
              &StormYear::intensity},
             {"towards_deg", 1, "where it blows to, clockwise from north", "any direction alike [choice]",
              &StormYear::towards_deg}}};
}

}  // namespace

TableLayout storms_layout() {
    return storms();
}

std::vector<WrittenFile> write_storms(const std::filesystem::path& folder, const Scenario& scenario,
                                      int first_calendar_year) {
    if (!scenario.forest.parameters.disturbance.has_storms()) {
        return {};
    }
    return {storms().write(folder, [&](auto& rows) {
        std::ranges::for_each(storm_years(scenario, first_calendar_year),
                              [&](const StormYear& storm) { rows.add(storm); });
    })};
}

}  // namespace coupling::decades
