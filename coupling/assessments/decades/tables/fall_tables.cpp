#include "coupling/assessments/decades/tables/fall_tables.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/tables/member_columns.hpp"
#include "coupling/results/figures/stop_causes.hpp"
#include "coupling/results/maps/rasters.hpp"

namespace coupling::decades {
namespace {

using config::joined;

/// What arrives at a target, or on a slope, in a year.
template <class Figures>
struct AtTarget : Figures {
    std::int32_t year;
    TargetName target;
    Cover cover;
};
template <class Figures>
struct OnSlope : Figures {
    std::int32_t year;
    Cover cover;
};

constexpr auto cover_of_row = [](const auto& row) { return name_of(row.cover); };
constexpr auto target_of_row = [](const auto& row) -> const TargetName& { return row.target; };

MemberTable<AtTarget<ProtectionFigures>> protection() {
    return {"protection.csv",
            "Protection effect at each target in each year, with 95 % intervals.",
            "a target in a year with rocks",
            {member_columns<AtTarget<ProtectionFigures>>(),
             {target_columns(), target_of_row},
             protection_columns()}};
}

MemberTable<AtTarget<ArrivalFigures>> targets() {
    return {"targets.csv",
            "What arrives at each target in each year: share, energy, speed, height.",
            "a target on one slope in a year with rocks",
            {member_columns<AtTarget<ArrivalFigures>>(),
             {target_columns(), target_of_row},
             {cover_column(), cover_of_row},
             arrival_columns()}};
}

MemberTable<OnSlope<SlopeFigures>> runs() {
    return {"runs.csv",
            "All rocks of each year: how they stopped, run-out, speed, energy, tree hits.",
            "a slope in a year with rocks",
            {member_columns<OnSlope<SlopeFigures>>(), {cover_column(), cover_of_row}, slope_columns()}};
}

struct CauseShare {
    StopCause cause;
    Share share;
};

MemberTable<OnSlope<CauseShare>> causes() {
    constexpr const char* exact = "Clopper & Pearson 1934";
    const ColumnsOf<CauseShare> shares{
        {"cause", "what ended the fall: tree, log, net, ground, left_terrain or gave_up",
         [](const auto& of) { return name_of(of.cause); }},
        {"rocks", "rocks that fell", from_counting, [](const auto& of) { return of.share.whole; }},
        {"stopped", "rocks whose fall it ended", from_counting, [](const auto& of) { return of.share.part; }},
        {"share_percent", 4, "of the rocks that fell", from_counting,
         [](const auto& of) { return 100.0 * of.share.value; }},
        {"share_low_percent", 4, "lower end of the 95 % interval", exact,
         [](const auto& of) { return 100.0 * of.share.interval.low; }},
        {"share_high_percent", 4, "upper end of the 95 % interval", exact,
         [](const auto& of) { return 100.0 * of.share.interval.high; }}};
    return {"causes.csv",
            "Share of the rocks that tree, log or ground stopped each year, with 95 % intervals.",
            "a cause on one slope in a year with rocks",
            {member_columns<OnSlope<CauseShare>>(), {cover_column(), cover_of_row}, shares}};
}

void add_stop_causes(const MemberYears& member, const auto& add) {
    for (const SlopeRow& slope : member.slopes) {
        const std::array<Share, stop_causes> shares = shares_by_cause(slope.figures);
        for (std::size_t cause = 0; cause < stop_causes; ++cause) {
            const CauseShare share{static_cast<StopCause>(cause), shares[cause]};
            add(OnSlope<CauseShare>{share, slope.year, slope.cover});
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

std::vector<TableLayout> fall_layouts() {
    return {protection(), targets(), runs(), causes()};
}

std::vector<WrittenFile> write_fall_tables(const std::filesystem::path& folder, const Names& names,
                                           const Site& site, std::span<const MemberYears> members) {
    const auto name_of_target = [&](const TargetRow& row) {
        return TargetName{site.targets[row.target].id, site.targets[row.target].name};
    };
    const auto of_protection = [&](const MemberYears& member, const auto& add) {
        for (const TargetRow& t : member.targets) {
            const ProtectionFigures figures{
                t.bare.share.whole, t.paired, protection_effect(t.paired),
                risk_reduction(t.paired, t.forest.energy_kj.p95, t.bare.energy_kj.p95)};
            add(AtTarget<ProtectionFigures>{figures, t.year, name_of_target(t), Cover::forest});
        }
    };
    const auto of_targets = [&](const MemberYears& member, const auto& add) {
        for (const TargetRow& t : member.targets) {
            add(AtTarget<ArrivalFigures>{t.forest, t.year, name_of_target(t), Cover::forest});
            add(AtTarget<ArrivalFigures>{t.bare, t.year, name_of_target(t), Cover::bare});
        }
    };
    const auto of_slopes = [](const MemberYears& member, const auto& add) {
        for (const SlopeRow& slope : member.slopes) {
            add(OnSlope<SlopeFigures>{slope.figures, slope.year, slope.cover});
        }
    };
    const auto of_causes = [](const auto& member, const auto& add) { add_stop_causes(member, add); };
    return {protection().write(folder, member_rows(names, members, of_protection)),
            targets().write(folder, member_rows(names, members, of_targets)),
            runs().write(folder, member_rows(names, members, of_slopes)),
            causes().write(folder, member_rows(names, members, of_causes))};
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
