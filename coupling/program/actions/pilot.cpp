#include "coupling/program/actions/pilot.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site_falls.hpp"

namespace coupling {
namespace {

/// A pilot ends after this CPU time, but not before it has seen a few rocks [choice].
constexpr double enough_s = 1.0;
constexpr std::uint64_t least_rocks = 8;
constexpr std::uint64_t most_rocks = 500;

/// One cell for all maps: such rocks take far longer to move than to count, and maps may be large.
config::GridFrame one_cell_of(const config::GridFrame& frame) {
    config::GridFrame one = frame;
    one.columns = 1;
    one.rows = 1;
    one.cell_width_m = frame.columns * frame.cell_width_m;
    one.cell_height_m = frame.rows * frame.cell_height_m;
    return one;
}

/// A chunk of a single rock.
rockfall::Chunk chunk_of(std::span<const rockfall::ReleaseSource> sources, std::uint64_t rock) {
    const auto behind = std::upper_bound(sources.begin(), sources.end(), rock,
                                         [](std::uint64_t number, const rockfall::ReleaseSource& source) {
                                             return number < source.first_rock;
                                         });
    const auto source = static_cast<std::uint32_t>(behind - sources.begin()) - 1;
    return {source, source + 1, rock, rock + 1, false, false};
}

/// The k-th of rocks in an order that is spread evenly however early it ends: steps of the golden section.
std::uint64_t spread(std::uint64_t k, std::uint64_t rocks) {
    constexpr double golden = 0.6180339887498949;
    const double share = std::fmod(static_cast<double>(k) * golden, 1.0);
    return std::min(rocks - 1, static_cast<std::uint64_t>(share * static_cast<double>(rocks)));
}

}  // namespace

double process_cpu_s() {
    return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

double pilot_seconds_per_rock(const Scenario& scenario, const Site& site,
                              const std::function<double()>& clock_s) {
    const std::uint64_t rocks = site.rocks();
    if (rocks == 0) {
        return 0.0;
    }
    const config::GridFrame frame = one_cell_of(site.map_frame_on_terrain());
    const SiteFalls falls{scenario, site, frame};
    rockfall::FedCells fed{frame.size()};
    rockfall::ChunkRows rows;
    rockfall::Worker worker{falls.assessment, {nullptr, nullptr}};
    const double begin_s = clock_s();
    const std::uint64_t most = std::min(rocks, most_rocks);
    std::uint64_t done = 0;
    while (done < most && (done < least_rocks || clock_s() - begin_s < enough_s)) {
        rows.clear();
        worker.run(chunk_of(site.sources, spread(done, rocks)), rows, &fed, {});
        ++done;
    }
    return (clock_s() - begin_s) / static_cast<double>(done);
}

}  // namespace coupling
