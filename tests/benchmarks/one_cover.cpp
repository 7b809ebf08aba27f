#include "tests/benchmarks/one_cover.hpp"

namespace benchmarks {
namespace {

/// Calls visit(start, key) for each rock of the sources, one source after the other.
template <class Visit>
void for_each_rock(const rockfall::Slope& slope, std::span<const rockfall::ReleaseSource> sources,
                   const rockfall::StartLaw& law, Visit visit) {
    for (std::uint32_t i = 0; i < sources.size(); ++i) {
        const std::uint64_t end = sources[i].first_rock + sources[i].rocks;
        for (std::uint64_t rock = sources[i].first_rock; rock < end; ++rock) {
            const config::StreamKey key = key_of(rock);
            if (const auto start = rockfall::start_of(slope, sources[i], i, law, key)) {
                visit(*start, key);
            }
        }
    }
}

}  // namespace

Totals fall_bare(const rockfall::Slope& slope, std::span<const rockfall::ReleaseSource> sources,
                 const rockfall::FallLaw& law, const rockfall::StemIndex* stems) {
    const rockfall::Obstacles obstacles{stems, {}};
    rockfall::FallScratch scratch;
    rockfall::NoObserver nobody;
    Totals totals;
    for_each_rock(slope, sources, compared_start(),
                  [&](const rockfall::RockStart& start, const config::StreamKey& key) {
                      totals.add(start.position_m,
                                 rockfall::fall(slope, obstacles, law, key, start, scratch, nobody));
                  });
    return totals;
}

OneCover::OneCover(const rockfall::Slope& slope, const rockfall::FallLaw& law,
                   const rockfall::StemIndex* stems, const config::GridFrame& frame,
                   rockfall::CellHistograms* histograms)
    : slope_{slope},
      law_{law},
      obstacles_{stems, {}},
      start_{compared_start()},
      histograms_{histograms},
      footprint_{slope.terrain, frame, {}},
      cells_{frame} {}

Totals OneCover::fall(std::span<const rockfall::ReleaseSource> sources) {
    Totals totals;
    records_.clear();
    tree_hits_.clear();
    for_each_rock(slope_, sources, start_,
                  [&](const rockfall::RockStart& start, const config::StreamKey& key) {
                      footprint_.begin(start, false);
                      const rockfall::FallEnd end =
                          rockfall::fall(slope_, obstacles_, law_, key, start, scratch_, footprint_);
                      footprint_.finish(end);
                      count(sources[start.source]);
                      totals.add(start.position_m, end);
                  });
    return totals;
}

void OneCover::count(const rockfall::ReleaseSource& source) {
    for (const rockfall::CellVisit& visit : footprint_.visits()) {
        rockfall::CellSums& sums = cells_.cells[visit.cell];
        sums.add(visit);
        if (sums.fed_by != footprint_.record().source + 1) {
            sums.fed_by = footprint_.record().source + 1;
            sums.fed_rocks += source.rocks;
        }
        if (histograms_ != nullptr) {
            histograms_->add(visit);
        }
    }
    if (footprint_.deposit_cell() < cells_.cells.size()) {
        ++cells_.cells[footprint_.deposit_cell()].deposited;
    }
    run_.add(footprint_.record());
    records_.push_back(footprint_.record());
    tree_hits_.insert(tree_hits_.end(), footprint_.tree_hits().begin(), footprint_.tree_hits().end());
}

}  // namespace benchmarks
