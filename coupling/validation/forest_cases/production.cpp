#include <algorithm>
#include <cmath>
#include <memory>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/validation/forest_cases/comparison.hpp"
#include "coupling/validation/forest_cases/production_runs.hpp"

namespace coupling::validation::forest_cases {
namespace {

using config::joined;

namespace check = plain_3pg;

/// How far a column lies from its reference.
struct ColumnDifference {
    const check::Column* column = nullptr;
    double largest = 0.0;           ///< relative [-]
    double largest_absolute = 0.0;  ///< in the unit of the column
    std::size_t row = 0;            ///< of the run, where the largest stands
    std::size_t compared = 0;
};

struct RunOutcome {
    std::vector<check::Row> rows;
    std::vector<ColumnDifference> columns;
};

bool is_stock(const check::Column& column) {
    return column.name.starts_with("biom_") && column.unit == "t/ha";
}

std::string month_words(const check::YearMonth& when) {
    return joined(std::to_string(when.year), when.month < 10 ? "-0" : "-", std::to_string(when.month));
}

/// " of Fagus sylvatica" in a run of several species.
std::string species_words(const ReferenceRun& run, const check::Row& row,
                          const std::vector<check::Row>& rows) {
    const auto place = static_cast<std::size_t>(&row - rows.data());
    const std::size_t count = run.inputs.species.size();
    return count > 1 ? joined(" of ", run.inputs.species[place % count].species) : "";
}

/// A run that is no number any more would agree with everything: no comparison with it holds. Throws
/// InputError (data) with the first month and column.
void require_numbers(const ReferenceRun& run, const std::vector<check::Row>& rows) {
    for (const check::Row& row : rows) {
        for (const check::Column& column : check::columns()) {
            if (run.table.has(column.name) && !std::isfinite(column.of(row))) {
                config::fail(config::ExitCode::data, {run.table.file()},
                             joined("run ", run.name, " is not a number since ", month_words(row.when),
                                    " in column ", column.name, species_words(run, row, rows)),
                             "parameters and weather that give numbers in every month",
                             "look at the parameters that the column depends on");
            }
        }
    }
}

/// A reference without a figure would agree with everything. Throws InputError (data).
void require_comparison(const ReferenceRun& run, const RunOutcome& outcome) {
    const bool any = std::any_of(outcome.columns.begin(), outcome.columns.end(),
                                 [](const ColumnDifference& column) { return column.compared > 0; });
    if (!any) {
        config::fail(config::ExitCode::data, {run.table.file()}, "no figure to compare",
                     "columns of r3PG such as biom_stem, dbh, lai or npp, with numbers",
                     "name the columns as r3PG does (README.md of forest_production)");
    }
}

/// All figures of all months that both programs give. What has not been computed before the first month is 0
/// in r3PG, and is not compared.
RunOutcome compare(const ReferenceRun& run) {
    RunOutcome outcome{check::run(run.inputs, run.settings), {}};
    require_numbers(run, outcome.rows);
    for (const check::Column& column : check::columns()) {
        if (!run.table.has(column.name)) {
            continue;
        }
        ColumnDifference difference{&column, 0.0, 0.0, 0, 0};
        for (std::size_t i = 0; i < run.table.rows(); ++i) {
            const std::optional<double> expected = config::parse_number(run.table.text(i, column.name));
            const std::size_t row = run.row_in_run[i];
            if (!expected || (row < run.inputs.species.size() && *expected == 0.0)) {
                continue;
            }
            const double absolute = std::abs(column.of(outcome.rows[row]) - *expected);
            const double relative = absolute / std::max(std::abs(*expected), run.floor);
            ++difference.compared;
            difference.largest_absolute = std::max(difference.largest_absolute, absolute);
            if (relative > difference.largest) {
                difference.largest = relative;
                difference.row = row;
            }
        }
        outcome.columns.push_back(difference);
    }
    require_comparison(run, outcome);
    return outcome;
}

constexpr double per_billion = 1e9;
constexpr double g_per_t = 1e6;

std::string difference_name(const ReferenceRun& run) {
    return joined("largest_difference_ppb:", run.name);
}

std::string biomass_name(const ReferenceRun& run) {
    return joined("largest_biomass_difference_gpha:", run.name);
}

/// The end of a month in years since the beginning of the first.
double time_of(const check::YearMonth& when, const check::Site& site) {
    return static_cast<double>(when.count() + 1 - site.from.count()) / 12.0;
}

/// One of r3PG's columns over the months, ours as a line and every so many months of the reference as a dot.
struct Curve {
    std::string_view column;
    const char* words;
    const char* style;
};

void add_curve(Plot& plot, const ReferenceRun& run, const RunOutcome& outcome, const Curve& curve,
               std::size_t species, std::size_t every) {
    const std::span<const check::Column> columns = check::columns();
    const auto column = std::find_if(columns.begin(), columns.end(),
                                     [&](const check::Column& one) { return one.name == curve.column; });
    PlotSeries ours{curve.words, curve.style, PlotSeries::Form::line, {}, {}};
    PlotSeries reference{"reference", "published", PlotSeries::Form::dots, {}, {}};
    const std::size_t count = run.inputs.species.size();
    std::vector<std::size_t> reference_of(outcome.rows.size(), run.table.rows());
    for (std::size_t i = 0; i < run.row_in_run.size(); ++i) {
        reference_of[run.row_in_run[i]] = i;
    }
    double most = plot.y.high;
    for (std::size_t row = species; row < outcome.rows.size(); row += count) {
        const double at = time_of(outcome.rows[row].when, run.inputs.site);
        ours.points.push_back({at, column->of(outcome.rows[row])});
        most = std::max(most, ours.points.back().y);
        const std::size_t month = row / count;
        if (reference_of[row] == run.table.rows() || month % every != 0 || !run.table.has(column->name)) {
            continue;
        }
        if (const auto value = config::parse_number(run.table.text(reference_of[row], column->name))) {
            reference.points.push_back({at, *value});
        }
    }
    plot.y = report::Axis::from_zero(plot.y.title, most);
    plot.series.push_back(std::move(ours));
    if (!reference.points.empty()) {
        plot.series.push_back(std::move(reference));
    }
}

Plot empty_plot(const ReferenceRun& run, std::string title, std::string unit) {
    const check::Site& site = run.inputs.site;
    return {.title = std::move(title),
            .x = report::Axis::from_zero(joined("Years since the beginning of ", month_words(site.from)),
                                         time_of(site.to, site)),
            .y = {std::move(unit), 0.0, 0.0},
            .series = {},
            .labels = {},
            .caption = ""};
}

PlotGroup plots_of(const ReferenceRun& run, const RunOutcome& outcome, std::size_t species) {
    const std::string& latin = run.inputs.species[species].species;
    PlotGroup group{
        .title = joined(latin, ", run ", run.name, ", against ", run.source), .plots = {}, .small = false};
    Plot stocks = empty_plot(run, "Biomass", "Dry mass, t/ha");
    constexpr std::size_t twice_a_year = 6;
    for (const Curve& curve : {Curve{"biom_stem", "stem", "default"}, Curve{"biom_root", "root", "other0"},
                               Curve{"biom_foliage", "foliage", "other1"}}) {
        add_curve(stocks, run, outcome, curve, species, twice_a_year);
    }
    stocks.caption = "Lines: Bannwald. Of the reference every sixth month is drawn.";
    // Our second implementation has the gross production alone.
    const bool has_npp = run.table.has("npp");
    Plot flux = empty_plot(run, has_npp ? "Net primary production" : "Gross primary production",
                           has_npp ? "NPP, t/ha in the month" : "GPP, t/ha in the month");
    add_curve(flux, run, outcome, {has_npp ? "npp" : "gpp", has_npp ? "NPP" : "GPP", "default"}, species, 1);
    flux.caption = "Line: Bannwald. Of the reference every month is drawn.";
    group.plots = {std::move(stocks), std::move(flux)};
    return group;
}

PlainTable table_for(const ReferenceRun& run, const RunOutcome& outcome) {
    constexpr std::size_t shown = 10;
    std::vector<ColumnDifference> worst = outcome.columns;
    std::stable_sort(worst.begin(), worst.end(), [](const ColumnDifference& a, const ColumnDifference& b) {
        return a.largest > b.largest;
    });
    std::size_t compared = 0;
    for (const ColumnDifference& one : worst) {
        compared += one.compared;
    }
    PlainTable table{
        .caption = joined("Run ", run.name, " against ", run.source, ": ", std::to_string(compared),
                          " figures of ", std::to_string(worst.size()), " columns; the ",
                          std::to_string(std::min(shown, worst.size())), " columns that differ most"),
        .head = {"column of r3PG", "unit", "largest difference, ppb",
                 "largest difference, unit of the column", "month of the largest"},
        .rows = {}};
    worst.resize(std::min(shown, worst.size()));
    for (const ColumnDifference& one : worst) {
        table.rows.push_back({std::string{one.column->name}, std::string{one.column->unit},
                              report::three_digits(per_billion * one.largest),
                              report::three_digits(one.largest_absolute),
                              month_words(outcome.rows[one.row].when)});
    }
    return table;
}

Outcome compare_all(const std::vector<ReferenceRun>& runs, const Work& work) {
    std::vector<RunOutcome> outcomes(runs.size());
    each_piece(work, runs.size(), [&](std::size_t i) { outcomes[i] = compare(runs[i]); });
    Outcome out;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        double largest = 0.0;
        double largest_stock_tpha = 0.0;
        for (const ColumnDifference& column : outcomes[i].columns) {
            largest = std::max(largest, column.largest);
            largest_stock_tpha =
                std::max(largest_stock_tpha, is_stock(*column.column) ? column.largest_absolute : 0.0);
        }
        out.values[difference_name(runs[i])] = per_billion * largest;
        out.values[biomass_name(runs[i])] = g_per_t * largest_stock_tpha;
        for (std::size_t species = 0; species < runs[i].inputs.species.size(); ++species) {
            out.plots.push_back(plots_of(runs[i], outcomes[i], species));
        }
        out.tables.push_back(table_for(runs[i], outcomes[i]));
    }
    return out;
}

}  // namespace

Comparison read_production(const CaseFiles& files) {
    const auto runs = std::make_shared<const std::vector<ReferenceRun>>(read_reference_runs(files));
    Comparison comparison;
    std::size_t months = 0;
    for (const ReferenceRun& run : *runs) {
        months += rows_of(run.inputs) / run.inputs.species.size();
        comparison.figures.push_back(
            {difference_name(run), joined("largest difference of any column and month, ", run.name), "ppb"});
        comparison.figures.push_back(
            {biomass_name(run), joined("largest difference of biomass, ", run.name), "g/ha"});
    }
    comparison.extent =
        joined(std::to_string(runs->size()), " reference runs, ", std::to_string(months), " months");
    comparison.pieces = runs->size();
    comparison.run = [runs](const Work& work) { return compare_all(*runs, work); };
    return comparison;
}

}  // namespace coupling::validation::forest_cases
