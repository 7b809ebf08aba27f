#pragma once

// A scene for tests of ensembles.

#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "rockfall/ensemble.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::testing {

/// Ridges and gullies without any function of the mathematical library.
inline double ridges_m(double x, double y) {
    const double phase = x / 80.0 + y / 105.0;
    return 4.0 * std::abs(phase - std::floor(phase) - 0.5);
}

/// A forested slope with a road below, small enough to fall a thousand rocks in a blink.
struct Scene {
    Slope slope;
    std::vector<Stem> stems;
    StemIndex index;
    std::vector<ReleaseSource> sources;
    std::vector<Target> targets;
    Assessment assessment;

    explicit Scene(std::uint64_t rocks)
        : slope{slope_over(heights_of({80, 40, 0.0, 0.0, 5.0, 5.0},
                                      [](double x, double y) { return 400.0 - 0.75 * x + ridges_m(x, y); }),
                           {0.30, 0.78}, 0.01)},
          stems{random_stems()},
          index{stems, slope.terrain, 0.5, true},
          sources{source_row(rocks)},
          targets{road()},
          assessment{slope, index, sources, targets, start_law(), law(), frame(), 42} {}

    static std::vector<Stem> random_stems() {
        std::vector<Stem> stems;
        for (std::size_t i = 0; i < 1500; ++i) {
            config::RandomStream stream{{3, 0, 0, i}, config::Purpose::test};
            stems.push_back({100.0 + 200.0 * stream.uniform(), 200.0 * stream.uniform(),
                             10.0 + 40.0 * stream.uniform(), 20.0, 1.0});
        }
        return stems;
    }
    std::vector<ReleaseSource> source_row(std::uint64_t rocks) const {
        std::vector<ReleaseSource> row;
        for (int i = 0; i < 20; ++i) {
            ReleaseSource source;
            source.first_m = Eigen::Vector2d{20.0, 50.0 + 5.0 * i} - slope.terrain.origin_m();
            source.last_m = source.first_m + Eigen::Vector2d{5.0, 5.0};
            source.weight = 1.0 + 0.1 * i;
            row.push_back(source);
        }
        allot(row, rocks);
        return row;
    }
    std::vector<Target> road() const {
        Target line;
        const Eigen::Vector2d o = slope.terrain.origin_m();
        line.parts = {{Eigen::Vector2d{320.0, 2.0} - o, Eigen::Vector2d{320.0, 198.0} - o}};
        return {with_bounds(line)};
    }
    config::GridFrame frame() const {
        return {80, 40, -slope.terrain.origin_m().x(), -slope.terrain.origin_m().y(), 5.0, 5.0};
    }
    static StartLaw start_law() {
        StartLaw law;
        law.diameter = DiameterLaw::uniform(0.4, 1.0);
        return law;
    }
    static FallLaw law() {
        FallLaw law;
        law.tree.deviation = deterministic_law().tree.deviation;
        return law;
    }
};

/// Falls the chunks in the order given, dealt out to some workers in turn, and adds the workers up.
inline EnsembleTally tally_of(const Scene& scene, std::vector<Chunk> chunks, std::size_t workers) {
    std::vector<std::unique_ptr<Worker>> crew;
    for (std::size_t i = 0; i < workers; ++i) {
        crew.push_back(std::make_unique<Worker>(scene.assessment,
                                                std::array<CellHistograms*, covers>{nullptr, nullptr}));
    }
    FedCells fed{scene.assessment.map_frame.size()};
    ChunkRows rows;
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        rows.clear();
        crew[i % workers]->run(chunks[i], rows, chunks[i].whole_sources ? nullptr : &fed, {});
    }
    EnsembleTally total{scene.assessment.map_frame, scene.targets.size(), scene.stems.size(),
                        scene.assessment.log_count()};
    for (const auto& worker : crew) {
        total.add(worker->tally());
    }
    return total;
}

/// Whether cells hold the same but for which source they saw last.
inline bool same_but_for_marks(const CellTally& a, const CellTally& b) {
    for (std::size_t i = 0; i < a.cells.size(); ++i) {
        CellSums x = a.cells[i];
        CellSums y = b.cells[i];
        x.fed_by = y.fed_by = 0;
        if (std::memcmp(&x, &y, sizeof x) != 0) {
            return false;
        }
    }
    return true;
}

}  // namespace rockfall::testing
