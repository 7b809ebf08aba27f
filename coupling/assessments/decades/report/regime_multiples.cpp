#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::Axis;
using report::Chart;
using report::ChartPoint;
using report::ChartRange;

constexpr std::size_t most_multiple_points = 100;
/// Of an axis: what a word needs to stand inside an area.
constexpr double room_for_a_word = 0.07;
/// Where foresters begin to count.
constexpr double first_dbh_cm = 8.0;

std::string with_regime(const RunView& run, const std::string& title, const RegimeView& regime) {
    return report::join_with_commas({title, run.regimes.size() > 1 ? regime.title() : ""});
}

Axis years_axis(std::size_t years) {
    return {report::page_text("Years since the start"), 0.0, static_cast<double>(years), false, true};
}

std::vector<std::size_t> drawn_years(std::size_t years) {
    std::vector<std::size_t> drawn;
    const std::size_t step = years / most_multiple_points + 1;
    for (std::size_t year = 0; year < years; year += step) {
        drawn.push_back(year);
    }
    drawn.push_back(years);
    return drawn;
}

double most_of(const RunView& run, std::size_t first_year, const YearFigure& figure) {
    double most = 0.0;
    for (const RegimeView& regime : run.regimes) {
        for (std::size_t year = first_year; year <= run.years; ++year) {
            most = std::max(most, regime.band(year, figure).mean);
        }
    }
    return most;
}

/// The code of a species in its area, where it is widest; not at the ends, where it would lie half outside.
void add_word(Chart& chart, const std::vector<ChartRange>& area, double axis_high, const std::string& word) {
    const std::size_t tenth = area.size() / 10;
    const auto widest = std::max_element(
        area.begin() + static_cast<std::ptrdiff_t>(tenth), area.end() - static_cast<std::ptrdiff_t>(tenth),
        [](const ChartRange& a, const ChartRange& b) { return a.high - a.low < b.high - b.low; });
    if (widest != area.end() && widest->high - widest->low > room_for_a_word * axis_high) {
        chart.add_word({widest->x, 0.5 * (widest->low + widest->high)}, word);
    }
}

std::string species_chart(const PageContent& content, const RunView& run, const RegimeView& regime,
                          double most_m3pha) {
    const Axis volume = Axis::from_zero(report::page_text("Volume, m³/ha"), most_m3pha);
    Chart chart{with_regime(run, report::page_text("Volume by species"), regime), years_axis(run.years),
                volume};
    const std::vector<std::size_t> years = drawn_years(run.years);
    std::vector<double> below(years.size(), 0.0);
    for (const std::size_t s : run.species) {
        std::vector<ChartRange> area;
        for (std::size_t i = 0; i < years.size(); ++i) {
            const double mean =
                regime.band(years[i], [s](const YearView& year) { return year.volumes_m3pha[s]; }).mean;
            area.push_back({static_cast<double>(years[i]), below[i], below[i] + mean});
            below[i] += mean;
        }
        const forest::Species& species = content.names.species.all()[s];
        chart.add_band(fill_of_species(s), area);
        chart.add_band_name(fill_of_species(s), joined(species.latin_name, " (", species.code, ")"));
        add_word(chart, area, volume.high, species.code);
    }
    return chart.figure(run.replicates() > 1
                            ? report::page_text("Areas on top of each other; means of the replicates.")
                            : report::page_text("Areas on top of each other."));
}

/// How many years a bar takes together.
std::size_t years_of_a_bar(std::size_t years) {
    return years <= 20    ? 1
           : years <= 60  ? 5
           : years <= 250 ? 10
                          : static_cast<std::size_t>(report::nice_step(static_cast<double>(years) / 25.0));
}

double lost(const YearView& year) {
    double sum = 0.0;
    for (const forest::Loss& loss : year.losses) {
        sum += loss.volume_m3pha;
    }
    return sum;
}

struct Period {
    std::size_t first;
    std::size_t last;
};

std::vector<Period> periods_of(std::size_t years) {
    std::vector<Period> periods;
    const std::size_t length = years_of_a_bar(years);
    for (std::size_t first = 1; first <= years; first += length) {
        periods.push_back({first, std::min(years, first + length - 1)});
    }
    return periods;
}

std::vector<forest::Cause> causes_of(const RunView& run) {
    std::vector<forest::Cause> causes;
    // Felled last: on top of what died of itself.
    for (std::size_t c = 0; c <= forest::cause_count; ++c) {
        const std::size_t place = c == forest::cause_count ? forest::index_of(forest::Cause::felled) : c;
        const auto cause = static_cast<forest::Cause>(place);
        if (c == forest::index_of(forest::Cause::felled)) {
            continue;
        }
        if (most_of(run, 1, [place](const YearView& year) { return year.losses[place].volume_m3pha; }) >
            0.0) {
            causes.push_back(cause);
        }
    }
    return causes;
}

std::string words_of(forest::Cause cause) {
    std::string name{forest::name_of(cause)};
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

std::string loss_chart(const RunView& run, const RegimeView& regime, const std::vector<forest::Cause>& causes,
                       double most_m3pha) {
    Chart chart{with_regime(run, report::page_text("Increment and losses"), regime), years_axis(run.years),
                Axis::from_zero(report::page_text("m³/ha a year"), most_m3pha)};
    const std::vector<Period> periods = periods_of(run.years);
    std::vector<ChartPoint> increment;
    std::vector<double> below(periods.size(), 0.0);
    for (const forest::Cause cause : causes) {
        for (std::size_t i = 0; i < periods.size(); ++i) {
            const Period& period = periods[i];
            const double mean = regime
                                    .mean_band(period.first, period.last,
                                               [cause](const YearView& year) {
                                                   return year.losses[forest::index_of(cause)].volume_m3pha;
                                               })
                                    .mean;
            // A bar stands over its years: year 1 is the one from 0 to 1.
            const double from = static_cast<double>(period.first - 1);
            const double to = static_cast<double>(period.last);
            const double gap = 0.1 * (to - from);
            if (mean > 0.0) {
                chart.add_bar(fill_of_cause(cause), {from + gap, below[i], below[i] + mean}, to - gap);
            }
            below[i] += mean;
        }
        chart.add_band_name(fill_of_cause(cause), words_of(cause));
    }
    for (const Period& period : periods) {
        increment.push_back(
            {0.5 * static_cast<double>(period.first - 1 + period.last),
             regime
                 .mean_band(period.first, period.last,
                            [](const YearView& year) { return year.row->volume_increment_m3pha; })
                 .mean});
    }
    chart.add_line("increment", increment);
    chart.add_dots("increment", increment);
    chart.add_dot_name("increment", report::page_text("increment"));
    const std::size_t length = years_of_a_bar(run.years);
    return chart.figure(
        length > 1 ? report::page_text(
                         "Bars: stem wood of trees that died or were felled, by cause, means over {length} "
                         "years. Where the dots stand above the bars the stock grows.",
                         {{"length", std::to_string(length)}})
                   : report::page_text(
                         "Bars: stem wood of trees that died or were felled, by cause. Where the dots stand "
                         "above the bars the stock grows."));
}

double most_lost_or_grown(const RunView& run) {
    double most = 0.0;
    for (const RegimeView& regime : run.regimes) {
        for (const Period& period : periods_of(run.years)) {
            most = std::max(most, regime.mean_band(period.first, period.last, lost).mean);
            most = std::max(
                most, regime
                          .mean_band(period.first, period.last,
                                     [](const YearView& year) { return year.row->volume_increment_m3pha; })
                          .mean);
        }
    }
    return most;
}

struct ShownYear {
    const char* series;
    std::string name;
    std::size_t year;
};

std::vector<ShownYear> shown_years(std::size_t years) {
    std::vector<ShownYear> shown{{"most", report::page_text("start"), 0}};
    if (years > 1) {
        shown.push_back(
            {"bare", report::page_text("year {years}", {{"years", std::to_string(years / 2)}}), years / 2});
    }
    if (years > 0) {
        shown.push_back(
            {"forest", report::page_text("year {years}", {{"years", std::to_string(years)}}), years});
    }
    return shown;
}

std::string dbh_chart(const RunView& run, const RegimeView& regime, std::size_t classes, double most_pha) {
    const std::size_t first = forest::dbh_class_of(first_dbh_cm);
    std::vector<double> edges;
    for (std::size_t c = first; c <= classes; ++c) {
        edges.push_back(forest::dbh_class_cm * static_cast<double>(c));
    }
    Chart chart{with_regime(run, report::page_text("Stems by diameter"), regime),
                Axis{report::page_text("Diameter at breast height, cm"), edges.front(), edges.back()},
                Axis::from_zero(report::page_text("Stems per ha in a class of 4 cm"), most_pha)};
    std::vector<std::string> thin;
    for (const ShownYear& shown : shown_years(run.years)) {
        std::vector<double> heights;
        double thinner = 0.0;
        for (std::size_t c = 0; c < classes; ++c) {
            const double mean =
                regime
                    .band(shown.year, [c](const YearView& year) { return year.stand->stems_pha_by_class[c]; })
                    .mean;
            if (c < first) {
                thinner += mean;
            } else {
                heights.push_back(mean);
            }
        }
        chart.add_steps(shown.series, edges, heights);
        chart.add_name(shown.series, shown.name);
        thin.push_back(report::with_label(shown.name, report::three_digits(thinner)));
    }
    return chart.figure(report::join_sentences(
        {report::page_text("Thinner stems per ha: {thin}.", {{"thin", report::join_with_semicolons(thin)}}),
         classes == forest::dbh_classes ? report::page_text("The last class is open.") : ""}));
}

/// One more than the last class that ever held a stem in a shown year.
std::size_t classes_worth_showing(const RunView& run) {
    std::size_t classes = forest::dbh_class_of(first_dbh_cm) + 4;
    for (const ShownYear& shown : shown_years(run.years)) {
        for (const RegimeView& regime : run.regimes) {
            for (std::size_t c = classes; c < forest::dbh_classes; ++c) {
                const auto stems = [c](const YearView& year) { return year.stand->stems_pha_by_class[c]; };
                classes = regime.band(shown.year, stems).mean > 0.0 ? c + 1 : classes;
            }
        }
    }
    return classes;
}

double most_in_a_class(const RunView& run, std::size_t classes) {
    double most = 0.0;
    for (const ShownYear& shown : shown_years(run.years)) {
        for (const RegimeView& regime : run.regimes) {
            for (std::size_t c = forest::dbh_class_of(first_dbh_cm); c < classes; ++c) {
                const auto stems = [c](const YearView& year) { return year.stand->stems_pha_by_class[c]; };
                most = std::max(most, regime.band(shown.year, stems).mean);
            }
        }
    }
    return most;
}

}  // namespace

std::optional<report::PageFields> charts_by_regime(const PageContent& content, const RunView& run) {
    if (run.regimes.empty()) {
        return std::nullopt;
    }
    std::string by_species;
    std::string losses;
    std::string diameters;
    const double most_m3pha = most_of(run, 0, [](const YearView& year) { return year.stand->volume_m3pha; });
    const std::vector<forest::Cause> causes = causes_of(run);
    const double most_flow = most_lost_or_grown(run);
    const std::size_t classes = classes_worth_showing(run);
    const double most_stems = most_in_a_class(run, classes);
    for (const RegimeView& regime : run.regimes) {
        if (run.years > 0) {
            by_species += species_chart(content, run, regime, most_m3pha);
            losses += loss_chart(run, regime, causes, most_flow);
        }
        diameters += dbh_chart(run, regime, classes, most_stems);
    }
    // One regime: three charts in a row of their own; several: a block for each kind.
    std::vector<report::PageFields> blocks;
    const auto add_block = [&](const std::string& charts) {
        if (!charts.empty()) {
            blocks.push_back({{"charts", charts}});
        }
    };
    if (run.regimes.size() == 1) {
        add_block(joined(by_species, losses, diameters));
    } else {
        add_block(by_species);
        add_block(losses);
        add_block(diameters);
    }
    return report::PageFields{{"blocks", blocks}};
}

}  // namespace coupling::decades
