// Lets rocks fall over a terrain from a file, for tools that count instructions. CGAL, which fails under
// them, is not linked.
//
//   impacts_counted bare|forest|pairs TERRAIN ROCKS
//
// bare: ends only; forest: 290 stems per hectare with maps and records; pairs: each rock with that forest and
// without, with maps and records of both. Prints the number of ground impacts, of pairs those of both falls.

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>

#include "tests/benchmarks/flat_terrain.hpp"
#include "tests/benchmarks/one_cover.hpp"
#include "tests/benchmarks/scene.hpp"

namespace {

/// Of all falls of a worker.
std::uint64_t count_pairs(const rockfall::Slope& slope, const rockfall::StemIndex& stems,
                          const rockfall::FallLaw& law, const config::GridFrame& frame,
                          const std::vector<rockfall::ReleaseSource>& sources) {
    const rockfall::Assessment assessment{slope, stems, sources, {}, benchmarks::compared_start(),
                                          law,   frame};
    rockfall::Worker worker{assessment, {nullptr, nullptr}};
    rockfall::ChunkRows rows;
    for (const rockfall::Chunk& chunk : rockfall::plan_chunks(sources)) {
        rows.clear();
        worker.run(chunk, rows, nullptr, {});
    }
    return worker.tally().runs[0].ground_impacts + worker.tally().runs[1].ground_impacts;
}

int count(const std::string& cover, const std::string& file, std::uint64_t rocks) {
    std::ifstream in{file, std::ios::binary};
    const rockfall::Slope slope = benchmarks::slope_of(benchmarks::read_flat(in));
    const rockfall::FallLaw law = benchmarks::compared_law();
    std::vector<rockfall::ReleaseSource> sources = benchmarks::bench_sources(slope.terrain);
    rockfall::allot(sources, rocks);
    const rockfall::StemIndex stems{benchmarks::bench_trees(), slope.terrain,
                                    0.5 * benchmarks::compared_start().diameter.largest_m(), law.tree.taper};
    const config::GridFrame frame = benchmarks::map_frame(benchmarks::bench_heights().frame, slope.terrain);
    if (cover == "pairs") {
        std::cout << count_pairs(slope, stems, law, frame, sources) << '\n';
        return 0;
    }
    benchmarks::OneCover forest{slope, law, &stems, frame, nullptr};
    const benchmarks::Totals totals =
        cover == "forest" ? forest.fall(sources) : benchmarks::fall_bare(slope, sources, law);
    std::cout << totals.impacts << '\n';
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::cerr << "impacts_counted bare|forest|pairs TERRAIN ROCKS\n";
        return 2;
    }
    try {
        return count(argv[1], argv[2], std::strtoull(argv[3], nullptr, 10));
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 3;
    }
}
