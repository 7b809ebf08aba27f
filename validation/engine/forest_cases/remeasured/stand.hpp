#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "config/errors/warnings.hpp"
#include "config/table/table.hpp"
#include "config/units/angle.hpp"
#include "forest/climate/series.hpp"
#include "forest/stand/patch.hpp"
#include "forest/stand/species.hpp"
#include "forest/start/starting_dead_wood.hpp"

namespace coupling::validation::forest_cases::remeasured {

/// A tree of the first measurement and what became of it.
struct MeasuredTree {
    std::uint64_t id = 0;
    forest::SpeciesId species{};
    double x_m = 0.0;
    double y_m = 0.0;
    double dbh_cm = 0.0;
    std::optional<double> height_m{};
    std::optional<double> age_years{};
    std::optional<double> end_dbh_cm{};  ///< nothing: it died or was felled
    std::optional<int> felled{};         ///< calendar year
};

/// A tree of the second measurement that the first had not.
struct IngrownTree {
    forest::SpeciesId species{};
    double dbh_cm = 0.0;
};

/// A rectangular plot that was measured at the ends of two growing seasons.
struct MeasuredStand {
    double width_m = 0.0;   ///< along x, a multiple of 10 m
    double length_m = 0.0;  ///< along y, the same
    double elevation_m = 0.0;
    config::Angle latitude;
    config::Angle slope;
    config::Angle aspect;  ///< direction it faces, clockwise from the y axis
    forest::Soil soil;
    int first_year = 0;         ///< of the first measurement
    int last_year = 0;          ///< of the second one
    double least_dbh_cm = 0.0;  ///< from which both counted trees
    std::vector<MeasuredTree> trees;
    std::vector<IngrownTree> ingrown;
    std::vector<forest::SaplingRecord> saplings;  ///< at the first measurement; may be empty
    forest::ClimateSeries climate;                ///< at the plot; holds the years between

    [[nodiscard]] double area_ha() const { return width_m * length_m / 10'000.0; }
    [[nodiscard]] int years() const { return last_year - first_year; }
};

/// The tables of a case; saplings and the list of felled trees may be missing.
struct MeasuredTables {
    config::Table site;
    config::Table trees;
    config::Table trees_end;
    config::Table climate;
    std::optional<config::Table> fell_list{};
    std::optional<config::Table> saplings{};
};

/// Reads and checks the tables (validation/README.md has their columns). Throws one InputError (data) for
/// what is missing, no number, or out of range; trees off the plot or below the least diameter; a tree of
/// another species at the end, thinner by more than a fifth, or felled and measured again; a mean growth that
/// no forest has; felled trees that were not there or fell outside the period; years without climate. Warns
/// of columns that nothing reads, of single trees that grow too fast or shrink, and of what was made of the
/// climate.
MeasuredStand read_measured_stand(const MeasuredTables& tables, const forest::SpeciesTable& species,
                                  config::Warnings& warnings);

}  // namespace coupling::validation::forest_cases::remeasured
