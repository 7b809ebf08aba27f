#include <array>
#include <numeric>

#include "coupling/assessments/decades/report/figure_cells.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using report::page_text;
using report::PageFields;
using report::three_digits;

struct NamedFigure {
    const char* name;
    double (*of)(const YearView&);
    Bounds bounds = not_negative;
    bool forest::DisturbanceLaw::*simulated = nullptr;  ///< nothing is shown of what was switched off
};

double all_losses(const YearView& year) {
    return std::accumulate(year.losses.begin(), year.losses.end(), 0.0,
                           [](double sum, const forest::Loss& loss) { return sum + loss.volume_m3pha; });
}

double felled(const YearView& year) {
    return year.work.felled_m3pha;
}
double salvaged(const YearView& year) {
    return year.work.salvaged_m3pha;
}
double removed(const YearView& year) {
    return year.work.removed_m3pha;
}
double left(const YearView& year) {
    return year.work.left_m3pha;
}
double margin(const YearView& year) {
    return year.work.margin_eur_pha();
}

template <forest::Cause cause>
double lost_to(const YearView& year) {
    return year.losses[forest::index_of(cause)].volume_m3pha;
}

constexpr std::array standing{
    NamedFigure{"Stems from 12 cm on, per ha",
                [](const YearView& year) { return stems_from_12_cm(*year.stand); }},
    NamedFigure{"Stems from 1 cm on, per ha", [](const YearView& year) { return year.stand->stems_pha; }},
    NamedFigure{"Basal area, m²/ha", [](const YearView& year) { return year.stand->basal_area_m2pha; }},
    NamedFigure{"Volume, m³/ha", [](const YearView& year) { return year.stand->volume_m3pha; }},
    NamedFigure{"Mean diameter (quadratic), cm",
                [](const YearView& year) { return year.stand->mean_dbh_cm; }},
    NamedFigure{"Dominant height, m", [](const YearView& year) { return year.stand->dominant_height_m; }},
    NamedFigure{"Leaf area index", [](const YearView& year) { return year.stand->leaf_area_index; }},
    NamedFigure{"Saplings below 1 cm, per ha", [](const YearView& year) { return year.row->saplings_pha; }},
    NamedFigure{"Standing dead wood, m³/ha", [](const YearView& year) { return year.row->snags_m3pha; }},
    NamedFigure{"Lying dead wood, m³/ha", [](const YearView& year) { return year.row->logs_m3pha; }},
    NamedFigure{
        "of both in decay classes 1 and 2 (hard), m³/ha",
        [](const YearView& year) { return year.row->dead_wood_m3pha[0] + year.row->dead_wood_m3pha[1]; }},
    NamedFigure{"in decay class 3 (soft outside), m³/ha",
                [](const YearView& year) { return year.row->dead_wood_m3pha[2]; }},
    NamedFigure{
        "in decay classes 4 and 5 (soft through), m³/ha",
        [](const YearView& year) { return year.row->dead_wood_m3pha[3] + year.row->dead_wood_m3pha[4]; }},
    NamedFigure{"Dead wood as far as not rotted, dry, t/ha",
                [](const YearView& year) { return year.row->dead_stems_tpha; }},
};

constexpr std::array flows{
    NamedFigure{"Increment, m³/ha a year",
                [](const YearView& year) { return year.row->volume_increment_m3pha; }},
    NamedFigure{"Felled, m³/ha a year", felled},
    NamedFigure{"Salvaged, m³/ha a year", salvaged},
    NamedFigure{"Removed from the forest, m³/ha a year", removed},
    NamedFigure{"Left of felled and salvaged, m³/ha a year", left},
    NamedFigure{"Contribution margin, EUR/ha a year", margin, {}},
    NamedFigure{"Mortality, m³/ha a year",
                [](const YearView& year) {
                    return all_losses(year) -
                           year.losses[forest::index_of(forest::Cause::felled)].volume_m3pha;
                }},
    NamedFigure{"of it by storms, m³/ha a year", lost_to<forest::Cause::wind>, not_negative,
                &forest::DisturbanceLaw::wind},
    NamedFigure{"of it by wet snow, m³/ha a year", lost_to<forest::Cause::snow>, not_negative,
                &forest::DisturbanceLaw::snow},
    NamedFigure{"of it by bark beetles, m³/ha a year", lost_to<forest::Cause::beetle>, not_negative,
                &forest::DisturbanceLaw::beetle},
    NamedFigure{"Ingrowth over 1 cm, stems/ha a year",
                [](const YearView& year) { return year.row->ingrowth_stems_pha; }},
};

/// Three digits, but nothing finer than a hundredth.
std::string figure_text(double value) {
    return value == 0.0 || value >= 10.0 ? three_digits(value) : report::fixed(value, 2);
}

std::string text_cell(const Band& band, bool with_band) {
    return with_band && band.has_interval()
               ? interval_cell(figure_text(band.mean), figure_text(band.low), figure_text(band.high))
               : figure_text(band.mean);
}

/// The rows of a figure, one for each regime; of a single one under the name of the figure.
template <class CellsOf>
PageFields rows_of_figure(const RunView& run, const NamedFigure& figure, const CellsOf& cells_of) {
    const std::string name = page_text(figure.name);
    std::vector<PageFields> rows;
    for (const RegimeView& regime : run.regimes) {
        rows.push_back(row_of_course(run.regimes.size() > 1 ? regime.title() : name, cells_of(regime)));
    }
    return {{"figure", name}, {"rows", rows}};
}

PageFields standing_fields(const RunView& run) {
    const bool with_band = run.replicates() > 1;
    const std::vector<std::int32_t> years =
        three_of({0, static_cast<std::int32_t>(run.years / 2), static_cast<std::int32_t>(run.years)});
    std::vector<PageFields> heads;
    for (const std::int32_t year : years) {
        const auto place = static_cast<std::size_t>(year);
        const bool is_end = year > 0 && place == run.years;
        heads.push_back(
            {{"is_start", year == 0},
             {"is_end", is_end},
             {"is_between", year > 0 && !is_end},
             {"year", std::to_string(year)},
             {"calendar_year", std::to_string(run.regimes[0].replicates[0][place].row->calendar_year)}});
    }
    std::vector<PageFields> figures;
    for (const NamedFigure& figure : standing) {
        figures.push_back(rows_of_figure(run, figure, [&](const RegimeView& regime) {
            std::vector<std::string> cells;
            for (const std::int32_t year : years) {
                cells.push_back(text_cell(
                    regime.band(static_cast<std::size_t>(year), figure.of, figure.bounds), with_band));
            }
            return cells;
        }));
    }
    return {{"with_band", with_band},
            {"heads", heads},
            {"columns", std::to_string(years.size() + 1)},
            {"figures", figures}};
}

/// What changed for one regime from the start to the end, and what was taken from it.
PageFields answer_of_regime(const RunView& run, const RegimeView& regime) {
    const auto mean = [&](double (*figure)(const YearView&)) {
        return figure_text(regime.mean_band(1, run.years, figure).mean);
    };
    const auto at = [&](std::size_t year, double (*figure)(const YearView&)) {
        return figure_text(regime.band(year, figure).mean);
    };
    const auto volume = [](const YearView& year) { return year.stand->volume_m3pha; };
    const auto stems = [](const YearView& year) { return stems_from_12_cm(*year.stand); };
    const auto height = [](const YearView& year) { return year.stand->dominant_height_m; };
    return {{"course", regime.title()},
            {"volume", at(0, volume)},
            {"volume_at_end", at(run.years, volume)},
            {"stems", at(0, stems)},
            {"stems_at_end", at(run.years, stems)},
            {"height", at(0, height)},
            {"height_at_end", at(run.years, height)},
            {"felled", mean(felled)},
            {"salvaged", mean(salvaged)},
            {"removed", mean(removed)},
            {"left", mean(left)},
            {"margin", mean(margin)}};
}

PageFields flow_fields(const RunView& run) {
    struct Span {
        std::size_t first;
        std::size_t last;
    };
    const std::size_t middle = run.years / 2;
    std::vector<Span> spans;
    if (middle > 0) {
        spans = {{1, middle}, {middle + 1, run.years}};
    }
    spans.push_back({1, run.years});
    std::vector<PageFields> heads;
    for (const Span& span : spans) {
        heads.push_back({{"span", std::to_string(span.first)}, {"span_last", std::to_string(span.last)}});
    }
    const forest::DisturbanceLaw& law = run.disturbance;
    std::vector<PageFields> figures;
    for (const NamedFigure& figure : flows) {
        if (figure.simulated != nullptr && !(law.*figure.simulated)) {
            continue;
        }
        figures.push_back(rows_of_figure(run, figure, [&](const RegimeView& regime) {
            std::vector<std::string> cells;
            for (const Span& span : spans) {
                cells.push_back(text_cell(regime.mean_band(span.first, span.last, figure.of, figure.bounds),
                                          run.replicates() > 1));
            }
            return cells;
        }));
    }
    std::vector<PageFields> answers;
    for (const RegimeView& regime : run.regimes) {
        if (!run.chart_a_climate || regime.climate == 0) {
            answers.push_back(answer_of_regime(run, regime));
        }
    }
    return {{"answers", answers},
            {"splits_climates", run.chart_a_climate},
            {"undisturbed", !law.wind && !law.snow && !law.beetle},
            {"heads", heads},
            {"columns", std::to_string(spans.size() + 1)},
            {"figures", figures}};
}

}  // namespace

PageFields answers_of(const RunView& run) {
    const bool ran = !run.regimes.empty();
    return {{"grouped", run.regimes.size() > 1},
            {"standing", ran ? std::optional{standing_fields(run)} : std::nullopt},
            {"flows", ran && run.years > 0 ? std::optional{flow_fields(run)} : std::nullopt}};
}

}  // namespace coupling::decades
