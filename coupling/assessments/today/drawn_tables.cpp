#include "coupling/assessments/today/drawn_tables.hpp"

#include <string>

#include "config/units/constants.hpp"
#include "coupling/results/tables/drawn_rows.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling {
namespace {

using config::percent;

struct IntervalRow {
    std::string target_id;  ///< "" of all rocks of a slope
    std::string cover;
    DrawnRow drawn;
};

TableOf<IntervalRow> interval_table() {
    return {
        "intervals.csv",
        "Main figures with two 95 % intervals: of the rocks alone, and of all that is not known.",
        "a figure of a target, or of all rocks of a slope",
        {{"target_id", "short name of the target; empty: all rocks", "input targets.file",
          &IntervalRow::target_id},
         {cover_column(), [](const auto& row) { return row.cover; }},
         {drawn_columns("reached, energy_mean, energy_95, height_95, protection, run_out_mean or run_out_95"),
          &IntervalRow::drawn}}};
}

void add_intervals(auto& rows, const RunResults& results, const DrawnFigures& drawn) {
    const auto add = [&](const std::string& target, const std::string& cover, const char* quantity,
                         const char* unit, double factor, const std::optional<DrawnFigure>& figure) {
        if (const auto row = drawn_row(quantity, unit, factor, figure, *results.draws)) {
            rows.add({target, cover, *row});
        }
    };
    for (std::size_t i = 0; i < drawn.targets.size(); ++i) {
        const std::string& id = results.site.targets[i].id;
        for (const Cover cover : covers_of(results)) {
            const DrawnArrivals& at = drawn.targets[i].by_cover[index_of(cover)];
            add(id, name_of(cover), "reached", "%", percent, at.share);
            add(id, name_of(cover), "energy_mean", "kJ", 1.0, at.energy_mean_kj);
            add(id, name_of(cover), "energy_95", "kJ", 1.0, at.energy_95_kj);
            add(id, name_of(cover), "height_95", "m", 1.0, at.height_95_m);
        }
        add(id, name_of(Cover::forest), "protection", "%", percent, drawn.targets[i].protection);
    }
    for (const Cover cover : covers_of(results)) {
        const DrawnRunOut& run_out = drawn.run_outs[index_of(cover)];
        add("", name_of(cover), "run_out_mean", "m", 1.0, run_out.mean_m);
        add("", name_of(cover), "run_out_95", "m", 1.0, run_out.p95_m);
    }
}

}  // namespace

std::vector<WrittenFile> write_drawn(const RunResults& results, const Figures& figures,
                                     const std::filesystem::path& folder) {
    if (!figures.drawn) {
        return {};
    }
    return {interval_table().write(folder, [&](auto& rows) { add_intervals(rows, results, *figures.drawn); }),
            write_draws(*results.draws, folder)};
}

std::vector<TableLayout> drawn_layouts() {
    return {interval_table(), draws_layout()};
}

}  // namespace coupling
