// The comparison on the screen and as a table.

#include <cmath>
#include <iomanip>
#include <sstream>

#include "config/text/joined.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "coupling/assessments/compare/runs/side_by_side.hpp"
#include "coupling/results/tables/table_of.hpp"

namespace coupling::compare {
namespace {

using config::joined;

constexpr int name_width = 37;
constexpr int value_width = 27;

/// Widths count characters, not bytes: "–" has three bytes.
std::string padded(const std::string& text, int width) {
    int characters = 0;
    for (const char c : text) {
        characters += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;
    }
    return text + std::string(static_cast<std::size_t>(std::max(1, width - characters)), ' ');
}

std::string fixed(double value) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(std::abs(value) < 10.0 ? 2 : 1) << value;
    return text.str();
}

std::string in_words(const std::optional<Figure>& figure) {
    if (!figure || std::isnan(figure->value)) {
        return figure && !figure->why_none.empty() ? "too few rocks" : "–";
    }
    std::string text = fixed(figure->value);
    if (!std::isnan(figure->low) && !std::isnan(figure->high)) {
        text += joined(" (", fixed(figure->low), " to ", fixed(figure->high), ")");
    }
    if (figure->year >= 0) {
        text += joined(" y", std::to_string(figure->year));
    }
    return text;
}

std::string in_words(const std::optional<Difference>& difference) {
    if (!difference) {
        return "–";
    }
    const std::string value = joined(difference->value > 0.0 ? "+" : "", fixed(difference->value));
    if (!difference->has_interval()) {
        return value;
    }
    return joined(value, difference->is_more_than_chance() ? " *" : " not significant");
}

std::string title_of(const FigureKey& key) {
    return joined(key.target.empty() ? "forest" : key.target, key.regime.empty() ? "" : ", regime ",
                  course_name(key.regime, key.climate));
}

void write_runs(std::ostream& out, std::span<const FinishedRun> runs, const SideBySide& comparison) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const SummaryOfRun& s = runs[i].summary;
        out << comparison.names[i] << "  " << runs[i].folder.string() << ": " << s.rocks << " rocks"
            << (s.years > 0 ? " a year, " : "");
        if (s.years > 0) {
            out << s.years << " years, " << s.replicates
                << (s.replicates == 1 ? " replicate" : " replicates");
        }
        out << ", seed " << s.seed << ", version " << s.version << '\n';
    }
}

void write_disagreements(std::ostream& out, const char* title, const std::vector<Disagreement>& list,
                         const SideBySide& comparison) {
    if (list.empty()) {
        return;
    }
    out << '\n' << title << '\n';
    for (const Disagreement& d : list) {
        out << "  " << padded(d.what, name_width - 2);
        for (std::size_t i = 0; i < d.values.size(); ++i) {
            out << comparison.letters[i] << ' '
                << padded(d.values[i].empty() ? "–" : d.values[i], value_width - 2);
        }
        out << '\n';
    }
}

void write_lines(std::ostream& out, const SideBySide& comparison) {
    std::string title;
    for (const Line& line : comparison.lines) {
        if (is_nothing_everywhere(line)) {
            continue;
        }
        if (title != title_of(line.key)) {
            title = title_of(line.key);
            out << '\n' << padded(title, name_width);
            for (const std::string& name : comparison.names) {
                out << padded(name, value_width);
            }
            for (std::size_t i = 1; i < comparison.letters.size(); ++i) {
                out << padded(joined(comparison.letters[i], " - A"), value_width - 7);
            }
            out << '\n';
        }
        const std::string when = line.key.when == "today"      ? ""
                                 : line.key.when == worst_year ? ", worst"
                                 : line.key.when == last_year  ? ", last"
                                                               : ", mean";
        out << "  " << padded(line.key.quantity + when, name_width - 2);
        for (const auto& figure : line.figures) {
            out << padded(in_words(figure), value_width);
        }
        for (std::size_t i = 1; i < line.differences.size(); ++i) {
            out << padded(in_words(line.differences[i]), value_width - 7);
        }
        out << '\n';
    }
}

/// Why figures are missing, each reason once.
void write_missing(std::ostream& out, const SideBySide& comparison) {
    for (const Line& line : comparison.lines) {
        for (std::size_t i = 0; i < line.figures.size(); ++i) {
            if (line.figures[i] && !line.figures[i]->why_none.empty()) {
                out << "  " << comparison.letters[i] << ", " << title_of(line.key) << ": "
                    << line.figures[i]->why_none << '\n';
            }
        }
    }
}

void write_reading(std::ostream& out, std::span<const FinishedRun> runs, const SideBySide& comparison) {
    if (all_of_one_replicate(runs)) {
        out << "\nOne replicate: no intervals; which differences are significant is not known. mean: over "
               "the years;\nlast: in the last year; yN: year N"
            << (comparison.lines.empty() ? "; there is no figure to compare.\n" : ".\n");
        return;
    }
    out << "\nIn brackets: 95 % interval of the chance in the simulated rocks";
    if (runs.front().summary.years > 0) {
        out << " and years, over the replicates; at worst years\n(yN: year N) the 90 % interval of the "
               "mean. "
               "mean: over the years;\nlast: in the last year";
    }
    out << ".\n*: the difference is statistically significant (95 %)";
    out << (comparison.lines.empty() ? "; there is no figure to compare.\n" : ".\n");
}

}  // namespace

void write_screen(std::ostream& out, std::span<const FinishedRun> runs, const SideBySide& comparison) {
    write_runs(out, runs, comparison);
    for (const std::string& why : comparison.not_comparable) {
        out << "NOT COMPARABLE: " << why << '\n';
    }
    for (const std::string& note : comparison.notes) {
        out << "note: " << note << '\n';
    }
    if (!comparison.same_inputs.empty()) {
        out << "\nInputs with the same content: ";
        for (std::size_t i = 0; i < comparison.same_inputs.size(); ++i) {
            out << (i == 0 ? "" : ", ") << comparison.same_inputs[i];
        }
        out << '\n';
    }
    write_disagreements(out, "Inputs that differ", comparison.inputs, comparison);
    write_disagreements(out, "Settings that differ", comparison.settings, comparison);
    if (comparison.inputs.empty() && comparison.settings.empty()) {
        out << "\nSettings and inputs are the same.\n";
    }
    write_lines(out, comparison);
    write_missing(out, comparison);
    write_reading(out, runs, comparison);
}

namespace {

constexpr const char* from_runs = "tables of the runs";

/// A figure of a run.
struct FigureRow : FigureKey, Figure {
    const std::string& letter;
    const FinishedRun& run;
    const std::optional<Difference>& difference;
};

ColumnsOf<Difference> difference_columns() {
    constexpr const char* unit = "as the quantity says";
    constexpr const char* how = "pairs of replicates by Student's t, or Zou and Donner 2008";
    return {{"difference", unit, 4, "value minus that of the first run", from_runs, &Difference::value},
            {"difference_low_95", unit, 4, "lower end of its 95 % interval", how, &Difference::low},
            {"difference_high_95", unit, 4, "upper end of its 95 % interval", how, &Difference::high},
            {"more_than_chance", "yes: the interval of the difference leaves 0 out; empty: not known", how,
             [](const Difference& d) {
                 return d.has_interval() ? std::optional{d.is_more_than_chance()} : std::nullopt;
             }}};
}

TableOf<FigureRow> compare_table() {
    constexpr const char* interval = "as the run has it; over years Student's t over replicates";
    constexpr const char* of_call = "order of the call";
    constexpr const char* unit = "as the quantity says";
    return {
        "compare.csv",
        "",
        "a figure of a run (written by `bannwald compare --out DIR`)",
        {{"run", "letter of the run", of_call, [](const auto& row) { return &row.letter; }},
         {"folder", "folder of the run", of_call, [](const auto& row) { return row.run.folder.string(); }},

         {"target_id", "target; empty for figures of the forest", from_runs, &FigureKey::target},
         {"regime", "regime; empty in runs of today", from_runs, &FigureKey::regime},
         {"climate", "climate; empty in runs of today", from_runs, &FigureKey::climate},
         {"quantity", "the figure, its unit at the end", from_runs, &FigureKey::quantity},
         {"when", "today, mean over years, last year or worst year", from_runs, &FigureKey::when},

         {"year", "the worst year, empty elsewhere", from_runs,
          [](const Figure& f) { return f.year < 0 ? std::nullopt : std::optional{f.year}; }},
         {"value", unit, 4, "the figure", from_runs, &Figure::value},
         {"low", unit, 4, "lower end of the 95 % interval; at worst years of the 90 % interval of the mean",
          interval, &Figure::low},
         {"high", unit, 4, "upper end of the 95 % interval; at worst years of the 90 % interval of the mean",
          interval, &Figure::high},
         {difference_columns(), [](const auto& row) { return row.difference; }},
         {"why_none", "why there is no value, such as too few rocks; empty elsewhere",
          "the rule of the run's own page", &Figure::why_none}}};
}

}  // namespace

const std::vector<TableLayout>& compare_layouts() {
    static const std::vector<TableLayout> layouts{compare_table()};
    return layouts;
}

void write_csv(std::ostream& out, std::span<const FinishedRun> runs, const SideBySide& comparison) {
    compare_table().write_to(out, [&](auto& rows) {
        for (const Line& line : comparison.lines) {
            for (std::size_t i = 0; i < runs.size(); ++i) {
                if (line.figures[i]) {
                    rows.add(
                        {line.key, *line.figures[i], comparison.letters[i], runs[i], line.differences[i]});
                }
            }
        }
    });
}

}  // namespace coupling::compare
