#include "coupling/assessments/nets/siting/net_design.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/units/constants.hpp"
#include "coupling/assessments/nets/figures/net_quantiles.hpp"

namespace coupling::siting {
namespace {

constexpr double shortest_net_m = 5.0;  // less is not built [choice]

std::size_t wanted_of(double share, std::size_t count) {
    return static_cast<std::size_t>(std::ceil(share * static_cast<double>(count) - 1e-9));
}

/// The shortest piece that holds `count` of the sorted places; the first of several.
std::pair<double, double> shortest_piece(const std::vector<double>& sorted, std::size_t count) {
    std::pair<double, double> best{sorted.front(), sorted.back()};
    for (std::size_t first = 0; first + count <= sorted.size(); ++first) {
        const double low = sorted[first];
        const double high = sorted[first + count - 1];
        if (high - low < best.second - best.first) {
            best = {low, high};
        }
    }
    return best;
}

/// The ends of a net, at whole metres and on the line.
void set_ends(NetDesign& net, std::vector<double> places_m, std::size_t count, double line_length_m) {
    std::sort(places_m.begin(), places_m.end());
    const auto [low_m, high_m] = shortest_piece(places_m, count);
    net.from_m = std::floor(low_m);
    net.to_m = std::ceil(high_m);
    const double missing_m = std::max(0.0, shortest_net_m - net.length_m());
    net.from_m = std::max(0.0, net.from_m - std::ceil(0.5 * missing_m));
    net.to_m = std::min(line_length_m, net.to_m + std::ceil(0.5 * missing_m));
}

}  // namespace

std::vector<Passage> passages_within(std::span<const PassingRock> crossings, double from_m, double to_m) {
    std::vector<Passage> passages;
    std::optional<std::uint32_t> last_path;
    for (const PassingRock& rock : crossings) {
        const auto along_m = static_cast<double>(rock.along_m);
        if (along_m >= from_m && along_m <= to_m && last_path != rock.path) {
            last_path = rock.path;
            passages.push_back({static_cast<double>(rock.energy_j) / config::j_per_kj,
                                static_cast<double>(rock.centre_m), static_cast<double>(rock.radius_m),
                                rock.stratum});
        }
    }
    return passages;
}

std::optional<NetDesign> design_net(std::span<const CrossingRock> rocks,
                                    std::span<const PassingRock> crossings, const NetWish& wish,
                                    double line_length_m) {
    std::vector<double> places_m;
    for (const CrossingRock& rock : rocks) {
        if (!rock.crossings.empty()) {
            places_m.push_back(rock.crossings.front().along_m);
        }
    }
    if (places_m.size() < rocks_to_tell(wish.share)) {
        return std::nullopt;
    }
    const std::size_t crossing = places_m.size();
    std::size_t wanted = wanted_of(wish.share, rocks.size());
    if (crossing < wanted) {
        wanted = wanted_of(wish.share, crossing);
    }
    NetDesign net;
    set_ends(net, std::move(places_m), crossing - (crossing - wanted) / 2, line_length_m);
    const auto barrier = design_barrier(passages_within(crossings, net.from_m, net.to_m), wish.design);
    if (!barrier) {
        return std::nullopt;
    }
    static_cast<BarrierToOrder&>(net) = *barrier;
    return net;
}

Left left_below(std::span<const CrossingRock> rocks, const NetDesign& net) {
    const auto is_within = [&](const Crossing& c) {
        return c.along_m >= net.from_m && c.along_m <= net.to_m;
    };
    std::uint64_t kept = 0;
    double all_kj = 0.0;
    Left left;
    for (const CrossingRock& rock : rocks) {
        all_kj += rock.energy_on_line_kj;
        const auto met = std::find_if(rock.crossings.begin(), rock.crossings.end(), [&](const Crossing& c) {
            return is_within(c) && c.height_m <= net.height_m;
        });
        if (met != rock.crossings.end() && met->energy_kj <= net.capacity_kj) {
            ++kept;
        } else {
            ++(met != rock.crossings.end()                                            ? left.through
               : std::any_of(rock.crossings.begin(), rock.crossings.end(), is_within) ? left.over
                                                                                      : left.beside);
            left.energy_kj += rock.energy_on_line_kj;
            left.largest_kj = std::max(left.largest_kj, rock.energy_on_line_kj);
        }
    }
    left.kept = share_of(kept, rocks.size());
    left.energy_percent = all_kj > 0.0 ? 100.0 * left.energy_kj / all_kj : 0.0;
    return left;
}

}  // namespace coupling::siting
