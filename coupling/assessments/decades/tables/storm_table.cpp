#include "coupling/assessments/decades/tables/storm_table.hpp"

#include <cmath>
#include <numbers>

#include "coupling/inputs/tables/csv_row.hpp"
#include "coupling/results/tables/table_layout.hpp"
#include "forest/disturbance/wind.hpp"

namespace coupling::decades {

std::vector<StormYear> storm_years(const Scenario& scenario, int first_calendar_year) {
    std::vector<StormYear> storms;
    const forest::DisturbanceLaw& law = scenario.forest.parameters.disturbance;
    const auto years = law.wind ? static_cast<std::int32_t>(scenario.years) : 0;
    for (std::uint32_t replicate = 0; replicate < scenario.forest.replicates; ++replicate) {
        for (std::int32_t year = 1; year <= years; ++year) {
            const int calendar_year = first_calendar_year - 1 + year;
            const auto storm =
                forest::storm_of_year(law.storm_interval_years, scenario.seed, replicate, calendar_year);
            if (storm && law.in_year(calendar_year).wind) {
                const double east_deg = storm->towards_rad * 180.0 / std::numbers::pi;
                storms.push_back(
                    {replicate, year, calendar_year, storm->intensity, std::fmod(450.0 - east_deg, 360.0)});
            }
        }
    }
    return storms;
}

TableLayout storms_layout() {
    constexpr const char* drawn = "drawn by seed, replicate and calendar year";
    return {
        "storms.csv",
        "a storm of a replicate, the same in all regimes and climates",
        {{"replicate", "-", "number of the replicate, from 1", "run.replicates"},
         {"year", "-", "simulated years since the start", drawn},
         {"calendar_year", "-", "calendar year", "run.first_year"},
         {"intensity", "-", "0 to 1", "Beta(1.2, 4) [choice]"},
         {"towards_deg", "deg", "where it blows to, clockwise from north", "any direction alike [choice]"}}};
}

std::vector<WrittenFile> write_storms(const std::filesystem::path& folder, const Scenario& scenario,
                                      int first_calendar_year) {
    if (!scenario.forest.parameters.disturbance.wind) {
        return {};
    }
    return {write_table(folder, "storms.csv",
                        "The storms of each replicate: the same in all regimes and climates.",
                        [&](std::ostream& out) {
                            TableRows row{out, storms_layout()};
                            for (const StormYear& storm : storm_years(scenario, first_calendar_year)) {
                                row.whole(storm.replicate + 1).whole(static_cast<std::uint32_t>(storm.year));
                                row.whole(static_cast<std::uint32_t>(storm.calendar_year));
                                row.number<4>(storm.intensity).number<1>(storm.towards_deg).end();
                            }
                        })};
}

}  // namespace coupling::decades
