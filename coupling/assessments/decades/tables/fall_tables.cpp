#include "coupling/assessments/decades/tables/fall_tables.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/tables/yearly_layouts.hpp"
#include "coupling/results/figures/stop_causes.hpp"
#include "coupling/results/maps/rasters.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling::decades {
namespace {

using config::joined;

void write_protection(std::ostream& out, const Names& names, const Site& site,
                      std::span<const MemberYears> members) {
    TableRows row{out, yearly_layouts(), "protection.csv"};
    for (const MemberYears& member : members) {
        for (const TargetRow& t : member.targets) {
            begin_row(row, names, member.member, t.year);
            row.text(site.targets[t.target].id).text(site.targets[t.target].name);
            add_protection(row, t.bare.share.whole, t.paired, protection_effect(t.paired),
                           risk_reduction(t.paired, t.forest.energy_kj.p95, t.bare.energy_kj.p95));
            row.end();
        }
    }
}

void write_targets(std::ostream& out, const Names& names, const Site& site,
                   std::span<const MemberYears> members) {
    TableRows row{out, yearly_layouts(), "targets.csv"};
    for (const MemberYears& member : members) {
        for (const TargetRow& t : member.targets) {
            for (const Cover cover : all_covers) {
                begin_row(row, names, member.member, t.year);
                row.text(site.targets[t.target].id).text(site.targets[t.target].name).text(name_of(cover));
                add_arrivals(row, cover == Cover::forest ? t.forest : t.bare);
                row.end();
            }
        }
    }
}

void write_runs(std::ostream& out, const Names& names, std::span<const MemberYears> members) {
    TableRows row{out, yearly_layouts(), "runs.csv"};
    for (const MemberYears& member : members) {
        for (const SlopeRow& slope : member.slopes) {
            begin_row(row, names, member.member, slope.year);
            row.text(name_of(slope.cover));
            add_slope(row, slope.figures);
            row.end();
        }
    }
}

void write_causes(std::ostream& out, const Names& names, std::span<const MemberYears> members) {
    TableRows row{out, yearly_layouts(), "causes.csv"};
    for (const MemberYears& member : members) {
        for (const SlopeRow& slope : member.slopes) {
            const std::array<Share, stop_causes> shares = shares_by_cause(slope.figures);
            for (std::size_t cause = 0; cause < stop_causes; ++cause) {
                begin_row(row, names, member.member, slope.year);
                row.text(name_of(slope.cover)).text(name_of(static_cast<StopCause>(cause)));
                row.whole(shares[cause].whole)
                    .whole(shares[cause].part)
                    .number<4>(100.0 * shares[cause].value);
                row.number<4>(100.0 * shares[cause].interval.low);
                row.number<4>(100.0 * shares[cause].interval.high);
                row.end();
            }
        }
    }
}

using Cells = std::vector<rockfall::CellSums>;

/// The cells of a year, summed over replicates; of the bare slope those of the first course, for all have the
/// same. By name of the bare slope or folder of the course, and year.
std::map<std::pair<std::string, std::int32_t>, Cells> summed(const Names& names,
                                                             std::span<const MemberYears> members) {
    std::map<std::pair<std::string, std::int32_t>, Cells> sums;
    for (const MemberYears& member : members) {
        for (const CellMap& map : member.maps) {
            if (map.cover == Cover::bare && names.course_of(member.member) > 0) {
                continue;
            }
            const std::string part =
                map.cover == Cover::bare ? "bare" : names.course_folder(names.course_of(member.member));
            Cells& sum = sums[{part, map.year}];
            sum.resize(map.cells.size());
            for (std::size_t i = 0; i < sum.size(); ++i) {
                sum[i].add(map.cells[i]);
            }
        }
    }
    return sums;
}

config::Raster<float> raster_of_cells(const RasterKind& kind, const config::GridFrame& frame,
                                      const Cells& cells) {
    config::Raster<float> raster{frame, std::numeric_limits<float>::quiet_NaN()};
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        if (cells[cell].passages > 0) {
            raster.values[cell] = kind.value(cells[cell], nullptr, cell);
        }
    }
    return raster;
}

}  // namespace

std::vector<WrittenFile> write_fall_tables(const std::filesystem::path& folder, const Names& names,
                                           const Site& site, std::span<const MemberYears> members) {
    std::vector<WrittenFile> written;
    const auto write = [&](const std::string& name, const std::string& sentence,
                           const std::function<void(std::ostream&)>& fill) {
        written.push_back(write_table(folder, name, sentence, fill));
    };
    write("protection.csv", "Protection effect at each target in each year, with 95 % intervals.",
          [&](std::ostream& out) { write_protection(out, names, site, members); });
    write("targets.csv", "What arrives at each target in each year: share, energy, speed, height.",
          [&](std::ostream& out) { write_targets(out, names, site, members); });
    write("runs.csv", "All rocks of each year: how they stopped, run-out, speed, energy, tree hits.",
          [&](std::ostream& out) { write_runs(out, names, members); });
    write("causes.csv", "Share of the rocks that tree, log or ground stopped each year, with 95 % intervals.",
          [&](std::ostream& out) { write_causes(out, names, members); });
    return written;
}

std::vector<WrittenFile> write_fall_maps(const std::filesystem::path& folder, const Names& names,
                                         const Site& site, std::span<const MemberYears> members,
                                         const WriteWatch& watch) {
    std::vector<WrittenFile> written;
    const auto sums = summed(names, members);
    for (const RasterKind& kind : raster_kinds()) {
        if (kind.percentile || kind.of_all) {
            continue;
        }
        ValueRange range;  // the same colours in all years and regimes
        for (const auto& [key, cells] : sums) {
            const ValueRange here = range_of(raster_of_cells(kind, site.map_frame, cells));
            range = {std::min(range.low, here.low), std::max(range.high, here.high)};
        }
        for (const auto& [key, cells] : sums) {
            const auto& [part, year] = key;
            const std::string number = std::to_string(year);
            const std::string path = joined("rasters/rockfall/", part, "/year_", number);
            watch(path);
            make_folder(folder / path);
            const config::Raster<float> raster = raster_of_cells(kind, site.map_frame, cells);
            const std::string sentence = joined(kind.stem, " [", kind.unit, "]: ", kind.meaning, "; year ",
                                                number, ", ", part == "bare" ? "bare slope." : part);
            written.push_back(write_raster(folder, {joined(path, "/", kind.stem), sentence, raster},
                                           site.projection, kind, range));
        }
    }
    return written;
}

}  // namespace coupling::decades
