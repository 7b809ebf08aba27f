#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/table/declared.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"
#include "forest/climate/change.hpp"
#include "forest/climate/co2.hpp"
#include "forest/climate/sequence.hpp"
#include "forest/site/season.hpp"

namespace coupling {

struct ClimateChangeRow;
const config::Schema<ClimateChangeRow>& climate_change_columns();

/// The weather of a year on all units of a site.
struct YearWeather {
    std::vector<forest::ClimateYear> units;  ///< one for each site unit, at its elevation
    double co2_ppm = 350.0;
    bool co2_response = false;
    int source_year = 0;                        ///< year of the series that stands for this one
    std::span<const double> usual_summer_mm{};  ///< by site unit; of the source of this weather

    /// As the forest takes it; lives as long as this object.
    [[nodiscard]] forest::SiteWeather view() const { return {units, co2_ppm, co2_response, usual_summer_mm}; }
};

/// Where the weather of simulated years comes from.
struct ClimateSource {
    forest::ClimateSeries series;  ///< years of the window only, with its elevation
    ClimateOrder order = ClimateOrder::once;
    std::uint64_t seed = 1;
    forest::ClimateChange change;
    int change_years = 0;           ///< after which the change is complete
    std::vector<double> dry_years;  ///< calendar years that have `dry_season`, too
    forest::ClimateChange dry_season;
    int first_year = 0;  ///< calendar year of the first simulated year
    forest::Co2Series co2 = forest::Co2Series::shipped();
    bool co2_response = false;
    forest::LapseRates lapse_rates = forest::LapseRates::shipped();

    /// Year of the series that stands for a calendar year. With order `once` it has to be one of the series.
    [[nodiscard]] int source_of(int year, std::uint32_t replicate) const;
    /// Whether there is a change in any month.
    [[nodiscard]] bool changes() const;
    /// Share of the change that a calendar year has, 0 before the first simulated one.
    [[nodiscard]] double share_of_change(int year) const;
    /// What a calendar year is changed by, with the dry season that was asked for.
    [[nodiscard]] forest::ClimateChange change_of(int year) const;
    /// The weather of a calendar year at some elevations. The same years of the series for all runs with the
    /// same seed.
    [[nodiscard]] YearWeather weather(int year, std::uint32_t replicate,
                                      std::span<const double> elevations_m) const;
    /// Precipitation of June to August in a mean year of the window, without the change [mm].
    [[nodiscard]] double usual_summer_mm(double elevation_m) const;
    /// Degree-days above 5.5 degC of a mean year of the window, without the change.
    [[nodiscard]] double degree_days(double elevation_m) const;
    /// Global radiation of mean days of the months [MJ/m2].
    [[nodiscard]] std::array<double, 12> mean_radiation_mjpm2() const;
};

/// The name of the climate of a scenario that names none.
inline constexpr const char* only_climate = "as_given";

struct NamedClimate {
    std::string name;
    ClimateSource source;
};

/// Reads and checks the climates of the scenario for its years: the one of its settings, or with
/// climate.variants one for each row of that table, which takes from the settings what it leaves out. All
/// begin in the same calendar year. Empty where something is wrong.
std::vector<NamedClimate> read_climates(Reading& reading);

}  // namespace coupling
