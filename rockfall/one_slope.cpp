#include "rockfall/one_slope.hpp"

#include <cmath>

#include "rockfall/trajectory.hpp"

namespace rockfall {

void enter_fall(const Footprint& footprint, Cover cover, const Assessment& assessment, const RockStart& start,
                EnsembleTally& tally, ChunkRows& rows, FedCells* fed, CellHistograms* histograms) {
    const auto c = static_cast<std::size_t>(cover);
    CellTally& cells = tally.cells[c];
    if (assessment.repeats > 0) {
        const std::uint64_t rock = start.id - assessment.sources[start.source].first_rock;
        cells.repeats.grow_to(cells.cells.size());
        for (const CellVisit& visit : footprint.visits()) {
            cells.repeats[visit.cell] |= std::uint64_t{1} << (rock % assessment.repeats);
        }
    }
    if (assessment.spread) {
        const std::uint32_t stratum = assessment.stratum_of(start.id);
        cells.spread.grow_to(cells.cells.size());
        for (const CellVisit& visit : footprint.visits()) {
            cells.spread[visit.cell].add(stratum, visit.energy_j);
        }
    }
    if (!assessment.release_weights.empty()) {
        const std::uint64_t weight = assessment.release_weights[start.source];
        cells.releases.grow_to(cells.cells.size());
        const auto enter = [&](std::size_t cell, float energy_j) {
            cells.releases[cell].add(weight, energy_j);
        };
        for (const CellVisit& visit : footprint.visits()) {
            assessment.release_reach.is_of_one_cell()
                ? enter(visit.cell, visit.energy_j)
                : cells.window.note(visit.cell, visit.energy_j, cells.frame, assessment.release_reach);
        }
        cells.window.hand_over(enter);
    }
    for (const CellVisit& visit : footprint.visits()) {
        CellSums& sums = cells.cells[visit.cell];
        sums.add(visit);
        if (fed != nullptr) {
            fed->mark(cover, visit.cell);
        } else if (sums.fed_by != start.source + 1) {
            sums.fed_by = start.source + 1;
            sums.fed_rocks += assessment.sources[start.source].rocks;
        }
        if (histograms != nullptr) {
            histograms->add(visit);
        }
    }
    if (footprint.deposit_cell() < cells.cells.size()) {
        ++cells.cells[footprint.deposit_cell()].deposited;
    }
    tally.runs[c].add(footprint.record());
    StratumTally* stratum =
        assessment.draws.empty() ? nullptr : &tally.strata[assessment.stratum_of(start.id)];
    if (stratum != nullptr) {
        stratum->run_outs[c].add(footprint.record());
    }
    for (const auto& [target, arrival] : footprint.arrivals()) {
        tally.targets[target].by_cover[c].add(arrival);
        if (stratum != nullptr) {
            stratum->targets[target].by_cover[c].add(arrival);
        }
        rows.arrivals[c].push_back({start.id, target, arrival});
    }
    for (const TreeHitRecord& hit : footprint.tree_hits()) {
        tally.stems[hit.stem].add(
            {1, hit.broken ? 1U : 0U, static_cast<std::uint64_t>(std::lround(hit.loss_j))});
        rows.tree_hits.emplace_back(start.id, hit);
    }
    for (const LogHitRecord& hit : footprint.log_hits()) {
        tally.logs[hit.log].add({1, hit.outcome == LogOutcome::broke ? 1U : 0U,
                                 hit.outcome == LogOutcome::stopped ? 1U : 0U,
                                 static_cast<std::uint64_t>(std::lround(hit.loss_j))});
        rows.log_hits.emplace_back(start.id, hit);
    }
    for (const NetCrossingRecord& crossing : footprint.net_crossings()) {
        rows.net_crossings[c].emplace_back(start.id, crossing);
    }
    rows.rocks[c].push_back(footprint.record());
    if (!footprint.path().empty()) {
        PathRecord& path = rows.paths.emplace_back();
        path.rock = start.id;
        path.cover = cover;
        path.points.assign(footprint.path().begin(), footprint.path().end());
        path.diameter_m = footprint.record().diameter_m;
        if (start.block.solid) {
            for (const Eigen::Vector3d& vertex_m : start.block.solid->hull.vertices_m) {
                path.shape_m.emplace_back(vertex_m.cast<float>());
            }
        }
    }
}

OneSlopeWorker::OneSlopeWorker(const Assessment& assessment, Cover cover)
    : assessment_{assessment},
      cover_{cover},
      tally_{assessment.map_frame, assessment.targets.size(), assessment.stems.placed().size(),
             assessment.log_count()},
      footprint_{assessment.slope.terrain, assessment.map_frame, assessment.targets} {
    tally_.strata.assign(assessment.draws.size(), StratumTally{assessment.targets.size()});
}

void OneSlopeWorker::run(const Chunk& chunk, ChunkRows& rows, FedCells* fed) {
    const Obstacles obstacles = assessment_.obstacles(cover_, {});
    each_start(assessment_, chunk, rows, [&](const RockStart& start) {
        const config::StreamKey key{assessment_.seed, assessment_.replicate, assessment_.year, start.id};
        footprint_.begin(start, assessment_.keeps_path(start.id));
        footprint_.finish(fall(assessment_.slope_of(start.id), obstacles, assessment_.law_of(start.id), key,
                               start, scratch_, footprint_));
        enter_fall(footprint_, cover_, assessment_, start, tally_, rows, fed, nullptr);
    });
}

}  // namespace rockfall
