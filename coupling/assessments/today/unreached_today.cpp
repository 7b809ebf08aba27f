#include "coupling/assessments/today/unreached_today.hpp"

#include <string>
#include <vector>

#include "coupling/assessments/works/work_figures.hpp"
#include "coupling/results/figures/unreached.hpp"

namespace coupling {
namespace {

using Lines = std::vector<std::vector<Eigen::Vector2d>>;

/// What all targets and nets of a run are held against.
struct ReachedCells {
    const Site& site;
    std::span<const rockfall::CellSums> cells;  ///< of the bare slope
    config::GridFrame frame;                    ///< in coordinates of the terrain
    double highest_source;

    /// `number` counts what was described before: distances are measured for the first ones only, as that
    /// looks at every cell and nobody reads hundreds of them.
    [[nodiscard]] Unreached described(const std::string& what, const std::string& name, const Lines& lines_m,
                                      std::size_t number) const {
        constexpr std::size_t most_measured = 20;
        return {what, name, lies_above(highest_source, site.slope.terrain, lines_m),
                number < most_measured ? nearest_passage_m(lines_m, frame, cells) : std::nullopt,
                lowest_ground_m(site.slope.terrain, lines_m)};
    }
};

/// Nets and works with the rocks that they hold over the bare slope.
std::vector<Holder> holders_of(const Site& site, std::span<const NetRow> net_rows,
                               std::span<const NetRow> work_rows, std::uint64_t rocks) {
    std::vector<Holder> holders;
    for (const NetRecord& net : site.nets) {
        holders.push_back({net.name, 0, highest_ground_m(site.slope.terrain, net.net.line_m)});
    }
    for (const NetRow& row : net_rows) {
        holders[row.crossing.net].rocks +=
            row.cover == rockfall::Cover::bare && row.crossing.outcome == rockfall::NetOutcome::held;
    }
    for (const WorkFigures& work : work_figures(site.works, work_rows, rockfall::Cover::bare, rocks)) {
        const WorkRecord& record = site.works[work.work];
        holders.push_back({record.name, work.at(WorkOutcome::held).part,
                           highest_ground_m(site.slope.terrain, record.line_m)});
    }
    return holders;
}

}  // namespace

void warn_of_unreached(const Site& site, const rockfall::EnsembleTally& tally,
                       std::span<const NetRow> net_rows, std::span<const NetRow> work_rows,
                       config::Warnings& warnings) {
    const auto bare = static_cast<std::size_t>(rockfall::Cover::bare);
    const rockfall::RunTally& run = tally.runs[bare];
    if (run.rocks == 0) {
        return;
    }
    const ReachedCells where{site, tally.cells[bare].cells, site.map_frame_on_terrain(),
                             highest_source_m(site)};
    std::vector<Unreached> unreached;
    for (std::size_t i = 0; i < site.targets.size(); ++i) {
        const auto& by_cover = tally.targets[i].by_cover;
        if (by_cover[0].reached + by_cover[1].reached == 0) {
            const rockfall::Target& target = site.targets[i];
            unreached.push_back(where.described("target", target.name.empty() ? target.id : target.name,
                                                target.parts, unreached.size()));
        }
    }
    const StopsBefore meaning =
        unreached.size() < site.targets.size() ? StopsBefore::is_usual : StopsBefore::ends_the_answer;
    const Departures departures = departures_of(run.rocks, run.left_over, site.slope.terrain);
    warn_of_unreached(
        unreached, departures, meaning, warnings,
        unreached.empty() ? std::vector<Holder>{} : holders_of(site, net_rows, work_rows, run.rocks),
        run.rocks);

    std::vector<char> is_reached(site.nets.size(), 0);
    for (const NetRow& row : net_rows) {
        is_reached[row.crossing.net] = 1;
    }
    std::vector<Unreached> nets;
    for (std::size_t i = 0; i < site.nets.size(); ++i) {
        if (is_reached[i] == 0) {
            nets.push_back(where.described("net", site.nets[i].name, {site.nets[i].net.line_m}, nets.size()));
        }
    }
    warn_of_unreached(nets, departures, StopsBefore::costs_its_point, warnings);
}

}  // namespace coupling
