#include "config/text/joined.hpp"
#include "coupling/assessments/today/arrival_breakdown.hpp"
#include "coupling/assessments/today/figures/static_layouts.hpp"
#include "coupling/inputs/tables/csv_row.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling {
namespace {

void add_target_name(TableRows& row, const rockfall::Target& target) {
    row.text(target.id).text(target.name);
}

/// A row for each slope on which rocks fell.
template <class Begin>
void add_covers(TableRows& row, const RunResults& results, const rockfall::TargetTally& tally,
                std::uint64_t rocks, const Begin& begin) {
    for (const Cover cover : covers_of(results)) {
        begin();
        row.text(name_of(cover));
        add_arrivals(row, figures_of(tally.by_cover[index_of(cover)], rocks));
        row.end();
    }
}

}  // namespace

void write_along_lines(std::ostream& out, const RunResults& results) {
    TableRows row{out, static_layouts(), "along_lines.csv"};
    for (const AlongLine& line : results.breakdown.lines) {
        for (const Stretch& stretch : line.stretches) {
            add_covers(row, results, stretch.tally, results.rocks, [&] {
                add_target_name(row, results.site.targets[line.target]);
                row.number<1>(stretch.from_m).number<1>(stretch.to_m);
                row.number<2>(stretch.middle_m.x()).number<2>(stretch.middle_m.y());
            });
        }
    }
}

void write_by_zone(std::ostream& out, const RunResults& results) {
    TableRows row{out, static_layouts(), "by_zone.csv"};
    for (const ReleaseGroup& group : results.breakdown.zones) {
        for (std::size_t target = 0; target < group.targets.size(); ++target) {
            add_covers(row, results, group.targets[target], group.released, [&] {
                row.whole(group.zone);
                add_target_name(row, results.site.targets[target]);
            });
        }
    }
}

void write_by_size(std::ostream& out, const RunResults& results) {
    TableRows row{out, static_layouts(), "by_size.csv"};
    for (const ReleaseGroup& group : results.breakdown.sizes) {
        for (std::size_t target = 0; target < group.targets.size(); ++target) {
            add_covers(row, results, group.targets[target], group.released, [&] {
                row.number<3>(group.smallest_m).number<3>(group.largest_m);
                add_target_name(row, results.site.targets[target]);
            });
        }
    }
}

}  // namespace coupling
