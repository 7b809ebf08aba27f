#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <set>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/results/text/markup.hpp"
#include "validation/engine/forest_cases/compared_columns.hpp"
#include "validation/engine/forest_cases/production_runs.hpp"
#include "validation/engine/forest_cases/shared/comparison.hpp"

namespace coupling::validation::forest_cases {
namespace {

using config::joined;

namespace check = plain_3pg;

/// The largest difference of a column and where it is.
struct LargestDifference {
    double size = 0.0;    ///< relative [-], or in the unit of the column
    std::size_t row = 0;  ///< of the run
    double ours = 0.0;    ///< there, in the unit of the column
    double reference = 0.0;

    void note(const LargestDifference& other) {
        if (other.size > size) {
            *this = other;
        }
    }
};

/// How far a column lies from its reference. The largest relative difference is often that of a small figure,
/// so the largest absolute one has its own month.
struct ColumnDifference {
    const check::Column* column = nullptr;
    LargestDifference relative{};
    LargestDifference absolute{};
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
        for (const ComparedColumn& compared : run.compared) {
            if (!std::isfinite(compared.column->of(row))) {
                config::fail(config::ExitCode::data, {run.parameters_file},
                             joined("run ", run.name, ", which gives no number from ", month_words(row.when),
                                    " on in column ", compared.column->name, species_words(run, row, rows)),
                             "parameters and weather that give numbers in every month",
                             joined("look at the parameters that ", compared.column->name,
                                    " depends on, and at the weather of that month"));
            }
        }
    }
}

ColumnDifference difference_of(const ReferenceRun& run, const ComparedColumn& compared,
                               const std::vector<check::Row>& rows) {
    ColumnDifference difference{.column = compared.column, .compared = compared.figures.size()};
    for (const ComparedFigure& figure : compared.figures) {
        const double ours = compared.column->of(rows[figure.row]);
        const double absolute = std::abs(ours - figure.reference);
        const double relative = absolute / std::max(std::abs(figure.reference), run.floor);
        difference.relative.note({relative, figure.row, ours, figure.reference});
        difference.absolute.note({absolute, figure.row, ours, figure.reference});
    }
    return difference;
}

/// All figures of all months that both programs give.
RunOutcome compare(const ReferenceRun& run) {
    RunOutcome outcome{check::run(run.inputs, run.settings), {}};
    require_numbers(run, outcome.rows);
    for (const ComparedColumn& compared : run.compared) {
        outcome.columns.push_back(difference_of(run, compared, outcome.rows));
    }
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
        return a.relative.size > b.relative.size;
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
                              report::three_digits(per_billion * one.relative.size),
                              report::three_digits(one.absolute.size),
                              month_words(outcome.rows[one.relative.row].when)});
    }
    return table;
}

/// "0.021 %", or "12 times the reference" where per cent would only be long.
std::string relative_words(double relative) {
    constexpr double many = 10.0;
    return relative < many ? joined(report::three_digits(100.0 * relative), " %")
                           : joined(report::three_digits(relative), " times the reference");
}

/// As many digits as r3PG prints.
std::string nine_digits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

/// The names where they are few; many columns are only counted.
std::string column_names(const std::vector<ComparedColumn>& compared) {
    constexpr std::size_t most_named = 8;
    std::string list;
    for (const ComparedColumn& one : compared) {
        list += joined(list.empty() ? "" : ", ", one.column->name);
    }
    return compared.size() <= most_named ? joined(" (", list, ")") : "";
}

/// "column dbh, 2001-03: Bannwald 20.0 cm, reference 10 cm".
std::string difference_words(const ReferenceRun& run, const RunOutcome& outcome, const check::Column& column,
                             const LargestDifference& where) {
    const check::Row& row = outcome.rows[where.row];
    const std::string unit = column.unit == "-" ? "" : joined(" ", column.unit);
    return joined("column ", column.name, species_words(run, row, outcome.rows), ", ", month_words(row.when),
                  ": Bannwald ", nine_digits(where.ours), unit, ", reference ", nine_digits(where.reference),
                  unit);
}

/// "compared 2 columns (dbh, lai) in 3 months, 6 figures".
std::string compared_words(const ReferenceRun& run, const RunOutcome& outcome) {
    std::set<int> months;
    std::size_t figures = 0;
    for (const ComparedColumn& one : run.compared) {
        figures += one.figures.size();
        for (const ComparedFigure& figure : one.figures) {
            months.insert(outcome.rows[figure.row].when.count());
        }
    }
    return joined("compared ", std::to_string(run.compared.size()),
                  run.compared.size() == 1 ? " column" : " columns", column_names(run.compared), " in ",
                  std::to_string(months.size()), months.size() == 1 ? " month, " : " months, ",
                  std::to_string(figures), figures == 1 ? " figure" : " figures");
}

/// The stock of biomass that differs most; null without stocks.
const ColumnDifference* worst_stock(const RunOutcome& outcome) {
    const ColumnDifference* worst = nullptr;
    for (const ColumnDifference& one : outcome.columns) {
        if (is_stock(*one.column) && (worst == nullptr || one.absolute.size > worst->absolute.size)) {
            worst = &one;
        }
    }
    return worst;
}

/// "8.59 t/ha", or in g/ha below a kilogram.
std::string biomass_words(double tpha) {
    constexpr double small_tpha = 1e-3;
    return tpha < small_tpha ? joined(report::three_digits(g_per_t * tpha), " g/ha")
                             : joined(report::three_digits(tpha), " t/ha");
}

/// How much was compared and where the run differs most: without it a small figure says little.
std::string detail_of(const ReferenceRun& run, const RunOutcome& outcome) {
    const auto worst = std::max_element(outcome.columns.begin(), outcome.columns.end(),
                                        [](const ColumnDifference& a, const ColumnDifference& b) {
                                            return a.relative.size < b.relative.size;
                                        });
    const std::string compared = joined("run ", run.name, ": ", compared_words(run, outcome), "; ");
    if (worst->relative.size == 0.0) {
        return joined(compared, "no difference");
    }
    const bool is_floored = std::abs(worst->relative.reference) < run.floor;
    const std::string relative =
        joined("largest difference in ", difference_words(run, outcome, *worst->column, worst->relative),
               is_floored ? joined(", relative to the floor ", config::to_text(run.floor))
                          : joined(", ", relative_words(worst->relative.size)));
    const ColumnDifference* const stock = worst_stock(outcome);
    const bool is_named = stock == nullptr || stock->absolute.size == 0.0 ||
                          (stock->column == worst->column && stock->absolute.row == worst->relative.row);
    return joined(compared, relative,
                  is_named ? ""
                           : joined("; largest difference of biomass in ",
                                    difference_words(run, outcome, *stock->column, stock->absolute), ", ",
                                    biomass_words(stock->absolute.size)));
}

/// Whether a reference has any stock of biomass.
bool has_stocks(const ReferenceRun& run) {
    return std::any_of(run.compared.begin(), run.compared.end(),
                       [](const ComparedColumn& one) { return is_stock(*one.column); });
}

Outcome compare_all(const std::vector<ReferenceRun>& runs, const Work& work) {
    std::vector<RunOutcome> outcomes(runs.size());
    each_piece(work, runs.size(), [&](std::size_t i) { outcomes[i] = compare(runs[i]); });
    Outcome out;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        double largest = 0.0;
        for (const ColumnDifference& column : outcomes[i].columns) {
            largest = std::max(largest, column.relative.size);
        }
        out.values[difference_name(runs[i])] = per_billion * largest;
        if (const ColumnDifference* const stock = worst_stock(outcomes[i])) {
            out.values[biomass_name(runs[i])] = g_per_t * stock->absolute.size;
        }
        out.details.push_back(detail_of(runs[i], outcomes[i]));
        for (std::size_t species = 0; species < runs[i].inputs.species.size(); ++species) {
            out.plots.push_back(plots_of(runs[i], outcomes[i], species));
        }
        out.tables.push_back(table_for(runs[i], outcomes[i]));
    }
    return out;
}

}  // namespace

Comparison read_production(const CaseFiles& files) {
    config::Warnings warnings;
    const auto runs = std::make_shared<const std::vector<ReferenceRun>>(read_reference_runs(files, warnings));
    Comparison comparison;
    comparison.warnings = warnings.all();
    std::size_t months = 0;
    for (const ReferenceRun& run : *runs) {
        months += rows_of(run.inputs) / run.inputs.species.size();
        comparison.figures.push_back(
            {difference_name(run), joined("largest difference of any column and month, ", run.name), "ppb"});
        if (has_stocks(run)) {
            comparison.figures.push_back(
                {biomass_name(run), joined("largest difference of biomass, ", run.name), "g/ha"});
        } else {
            comparison.unknown[biomass_name(run)] =
                joined(run.table.file(),
                       " has no column of biomass in t/ha with numbers (biom_stem, biom_root, biom_foliage)",
                       unread_columns(run));
        }
    }
    comparison.extent =
        joined(std::to_string(runs->size()), runs->size() == 1 ? " reference run, " : " reference runs, ",
               std::to_string(months), " months");
    comparison.pieces = runs->size();
    comparison.run = [runs](const Work& work) { return compare_all(*runs, work); };
    return comparison;
}

}  // namespace coupling::validation::forest_cases
