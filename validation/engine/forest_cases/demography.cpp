#include <algorithm>
#include <memory>
#include <numeric>
#include <sstream>

#include "config/text/joined.hpp"
#include "coupling/results/text/markup.hpp"
#include "validation/engine/forest_cases/demography_trial/trial.hpp"
#include "validation/engine/forest_cases/shared/comparison.hpp"
#include "validation/engine/forest_cases/shared/level_forest.hpp"
#include "validation/engine/forest_cases/shared/unknown_columns.hpp"

namespace coupling::validation::forest_cases {

namespace {

using config::joined;
using demography_trial::DemographyTrial;
using demography_trial::Fate;
using report::fixed;

/// A size and competition of a species at a place of its range, with what inventories found.
struct DemographyCell {
    std::string code;
    forest::SpeciesId species{};
    int place = 2;  ///< 1 hot edge, 2 optimum, 3 cold edge
    demography_trial::PlaceClimate climate;
    double dbh_cm = 0.0;
    double larger_m2pha = 0.0;
    double growth_mm_pyear = 0.0;
    double mortality_pyear = 0.0;

    [[nodiscard]] std::string name() const {
        return joined(":", code, ":", std::to_string(place), ":", report::tick_text(dbh_cm), ":",
                      report::tick_text(larger_m2pha));
    }
};

struct DemographyData {
    forest::SpeciesTable species;
    std::vector<DemographyCell> cells;
    std::vector<forest::ClimateYear> climate;
    forest::Parameters parameters;
    DemographySettings settings;
};

constexpr std::array<const char*, 3> place_words{"hot edge", "optimum", "cold edge"};

bool growth_agrees(double ratio) {
    return ratio >= 0.6 && ratio <= 1.6;
}

bool mortality_agrees(double ratio) {
    constexpr double factor = 3.0;
    return ratio >= 1.0 / factor && ratio <= factor;
}

std::vector<std::string> cell_columns() {
    return {"species", "place",        "degree_days",     "wetness",
            "dbh_cm",  "larger_m2pha", "growth_mm_pyear", "mortality_pyear"};
}

std::vector<DemographyCell> read_cells(const config::Table& table, const forest::SpeciesTable& species,
                                       bool edges) {
    config::Problems problems;
    if (!table.require(cell_columns(), problems)) {
        problems.throw_if_any();
    }
    const auto number = [&](std::size_t row, const char* column, double low, double high) {
        return table.number(row, column, {.low = low, .high = high}, problems).value_or(low);
    };
    std::vector<DemographyCell> cells;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        DemographyCell cell;
        cell.code = table.text(row, "species");
        cell.species =
            species.find(cell.code, table.place(row, "species"), problems).value_or(forest::SpeciesId{});
        cell.place = static_cast<int>(number(row, "place", 1.0, 3.0));
        cell.climate = {number(row, "degree_days", 100.0, 6000.0), number(row, "wetness", -0.9, 10.0)};
        cell.dbh_cm = number(row, "dbh_cm", 5.0, 100.0);
        cell.larger_m2pha = number(row, "larger_m2pha", 0.0, 80.0);
        cell.growth_mm_pyear = number(row, "growth_mm_pyear", 0.01, 50.0);
        cell.mortality_pyear = number(row, "mortality_pyear", 1e-6, 1.0);
        if (edges || cell.place == 2) {
            cells.push_back(cell);
        }
    }
    problems.throw_if_any();
    return cells;
}

std::vector<std::string> codes_of(const DemographyData& data) {
    std::vector<std::string> codes;
    for (const DemographyCell& cell : data.cells) {
        if (std::find(codes.begin(), codes.end(), cell.code) == codes.end()) {
            codes.push_back(cell.code);
        }
    }
    return codes;
}

void add_figures(Comparison& comparison, const DemographyData& data) {
    for (const DemographyCell& cell : data.cells) {
        const std::string words =
            joined(", ", data.species[cell.species].latin_name, " of ", report::tick_text(cell.dbh_cm),
                   " cm under ", report::tick_text(cell.larger_m2pha), " m2/ha, ",
                   place_words[static_cast<std::size_t>(cell.place - 1)]);
        comparison.figures.push_back(
            {joined("growth_ratio", cell.name()), joined("growth / inventories", words), "-"});
        comparison.figures.push_back(
            {joined("mortality_ratio", cell.name()), joined("mortality / inventories", words), "-"});
    }
    for (int place = 1; place <= 3; ++place) {
        const std::string at = place_words[static_cast<std::size_t>(place - 1)];
        if (std::none_of(data.cells.begin(), data.cells.end(),
                         [&](const DemographyCell& cell) { return cell.place == place; })) {
            continue;
        }
        for (const char* of : {"growth", "mortality"}) {
            comparison.figures.push_back(
                {joined("share_", of, ":all:", std::to_string(place)),
                 joined("cells whose ", of, " agrees with inventories, all species, ", at), "-"});
            for (const std::string& code : codes_of(data)) {
                comparison.figures.push_back({joined("share_", of, ":", code, ":", std::to_string(place)),
                                              joined("the same, ", code, ", ", at), "-"});
            }
        }
    }
}

/// Shares of agreeing cells by species and place, and of all species.
void add_shares(Outcome& outcome, const DemographyData& data) {
    std::map<std::string, std::pair<double, double>> counts;  // agreeing, all
    const auto count = [&](const std::string& of, const DemographyCell& cell, bool agrees) {
        for (const std::string& who : {std::string{"all"}, cell.code}) {
            auto& [agreeing, all] = counts[joined("share_", of, ":", who, ":", std::to_string(cell.place))];
            agreeing += agrees ? 1.0 : 0.0;
            all += 1.0;
        }
    };
    for (const DemographyCell& cell : data.cells) {
        count("growth", cell, growth_agrees(outcome.values.at(joined("growth_ratio", cell.name()))));
        count("mortality", cell, mortality_agrees(outcome.values.at(joined("mortality_ratio", cell.name()))));
    }
    for (const auto& [name, shares] : counts) {
        outcome.values[name] = shares.first / shares.second;
    }
}

PlainTable cell_table(const DemographyData& data, const std::vector<Fate>& fates) {
    PlainTable table{.caption = "Trees among larger ones of their species: simulated / inventories",
                     .head = {"species", "place", "DBH, cm", "larger trees, m2/ha", "growth, mm a year",
                              "deaths, % a year"},
                     .rows = {}};
    const int years = static_cast<int>(data.settings.years);
    for (std::size_t i = 0; i < fates.size(); ++i) {
        const DemographyCell& cell = data.cells[i];
        table.rows.push_back(
            {data.species[cell.species].latin_name, place_words[static_cast<std::size_t>(cell.place - 1)],
             report::tick_text(cell.dbh_cm), report::tick_text(cell.larger_m2pha),
             joined(fixed(fates[i].mean_growth_mm_pyear(), 1), " / ", fixed(cell.growth_mm_pyear, 1)),
             joined(fixed(100.0 * fates[i].mortality_pyear(years), 2), " / ",
                    fixed(100.0 * cell.mortality_pyear, 2))});
    }
    return table;
}

Outcome compare(const DemographyData& data, const Work& work) {
    const forest::Site site =
        level_site(demography_trial::trial_grid(), config::Angle::from_degrees(47.7), data.climate);
    const int years = static_cast<int>(data.settings.years);
    std::vector<Fate> fates(data.cells.size());
    each_piece(work, data.cells.size(), [&](std::size_t piece) {
        const DemographyCell& cell = data.cells[piece];
        DemographyTrial trial{.species = cell.species,
                              .dbh_cm = cell.dbh_cm,
                              .larger_m2pha = cell.larger_m2pha,
                              .climate = demography_trial::shifted_to(data.climate, cell.climate),
                              .degree_days = cell.climate.degree_days,
                              .parameters = data.parameters,
                              .years = years};
        for (std::uint64_t seed = 1; seed <= data.settings.seeds; ++seed) {
            fates[piece] += grow_demography(trial, site, data.species, {seed, 0});
        }
    });
    Outcome outcome;
    for (std::size_t i = 0; i < fates.size(); ++i) {
        const DemographyCell& cell = data.cells[i];
        outcome.values[joined("growth_ratio", cell.name())] =
            fates[i].mean_growth_mm_pyear() / cell.growth_mm_pyear;
        outcome.values[joined("mortality_ratio", cell.name())] =
            fates[i].mortality_pyear(years) / cell.mortality_pyear;
    }
    add_shares(outcome, data);
    outcome.tables = {cell_table(data, fates)};
    return outcome;
}

}  // namespace

Comparison read_demography(const CaseFiles& files, const DemographySettings& settings,
                           const forest::Parameters& parameters) {
    auto data = std::make_shared<DemographyData>();
    config::Warnings warnings;
    data->species = species_of(files);
    const config::Table reference = table_of(files, "reference.csv");
    warn_of_unknown_columns(reference, cell_columns(), warnings);
    data->cells = read_cells(reference, data->species, settings.edges);
    data->climate = forest::read_climate_of_one_place(table_of(files, "climate.csv"), warnings).years;
    data->parameters = parameters;
    data->settings = settings;
    Comparison comparison;
    comparison.warnings = warnings.all();
    add_figures(comparison, *data);
    comparison.extent = joined(std::to_string(data->cells.size()), " sizes and competitions, ",
                               std::to_string(settings.seeds), " stands each over ",
                               std::to_string(settings.years), " years");
    comparison.pieces = data->cells.size();
    comparison.run = [data](const Work& work) { return compare(*data, work); };
    return comparison;
}

}  // namespace coupling::validation::forest_cases
