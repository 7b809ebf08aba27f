#pragma once

#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/compare/runs/finished_run.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling::compare {

/// A figure of a run minus that of the first one, with its 95 % interval (NaN: not known).
struct Difference {
    double value = 0.0;
    double low = std::numeric_limits<double>::quiet_NaN();
    double high = std::numeric_limits<double>::quiet_NaN();
    [[nodiscard]] bool has_interval() const { return low <= high; }
    /// Whether the interval leaves 0 out. Requires an interval.
    [[nodiscard]] bool is_more_than_chance() const { return low > 0.0 || high < 0.0; }
};

/// Replicates as pairs (Student's t) where `paired` and both have the same number of two and more; otherwise
/// both intervals taken as independent (MOVER: Zou and Donner 2008), which is wide where runs share rocks.
/// Nothing if one of the figures is not known.
std::optional<Difference> difference(const Figure& figure, const Figure& first, bool paired);

/// One figure in all runs.
struct Line {
    FigureKey key;
    std::vector<std::optional<Figure>> figures;          ///< by run
    std::vector<std::optional<Difference>> differences;  ///< by run; none for the first
};

/// A part that is 0 in all runs, such as timber where nobody works: tables for people leave it out.
bool is_nothing_everywhere(const Line& line);

/// A setting or input that is not the same in all runs; by run, "–" where a run has none. Of an input the
/// name of its file, with the beginning of its hash where the names alone do not tell them apart.
struct Disagreement {
    std::string what;
    std::vector<std::string> values;
};

/// Finished runs side by side.
struct SideBySide {
    std::vector<std::string> letters;         ///< "A", "B", ...
    std::vector<std::string> names;           ///< the letters; with the motion model where models differ
    std::vector<std::string> not_comparable;  ///< why, one sentence each; empty: the runs can be compared
    std::vector<std::string> notes;           ///< what to keep in mind
    std::vector<Disagreement> inputs;         ///< by their content, whatever the files are called
    std::vector<std::string> same_inputs;     ///< roles of inputs with the same content in all runs
    std::vector<Disagreement> settings;       ///< without those that name files: these are inputs
    std::vector<Line> lines;
};

/// Whether these are runs over years of one replicate: nothing is known of the chance between replicates.
bool all_of_one_replicate(std::span<const FinishedRun> runs);

/// Requires two runs or more. Throws config::InputError (settings) for runs of different kinds and for more
/// than 26.
SideBySide side_by_side(std::span<const FinishedRun> runs);

/// For people: runs, what differs, figures with intervals, differences to the first run.
void write_screen(std::ostream& out, std::span<const FinishedRun> runs, const SideBySide& comparison);

/// The layout of the table that write_csv writes.
const std::vector<TableLayout>& compare_layouts();
/// One row a figure of a run.
void write_csv(std::ostream& out, std::span<const FinishedRun> runs, const SideBySide& comparison);

}  // namespace coupling::compare
