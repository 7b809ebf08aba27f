#include "coupling/assessments/nets/siting/net_design.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/inputs/nets/net_classes.hpp"

namespace coupling::siting {
namespace {

constexpr double shortest_net_m = 5.0;  // less is not built [choice]
constexpr double height_step_m = 0.1;
constexpr double open_class_step_kj = 100.0;
constexpr double lowest_net_m = 0.5;  // lower ones are doubted as input too

double rounded_up(double value, double step) {
    return step * std::ceil(value / step - 1e-6);
}

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

const Crossing* first_within(const CrossingRock& rock, const NetDesign& net) {
    const auto found = std::find_if(rock.crossings.begin(), rock.crossings.end(), [&](const Crossing& c) {
        return c.along_m >= net.from_m && c.along_m <= net.to_m;
    });
    return found == rock.crossings.end() ? nullptr : &*found;
}

}  // namespace

std::optional<NetDesign> design_net(std::span<const CrossingRock> rocks, double wanted_share,
                                    double line_length_m) {
    std::vector<double> places_m;
    for (const CrossingRock& rock : rocks) {
        if (!rock.crossings.empty()) {
            places_m.push_back(rock.crossings.front().along_m);
        }
    }
    if (places_m.size() < rocks_to_tell(wanted_share)) {
        return std::nullopt;
    }
    const std::size_t crossing = places_m.size();
    std::size_t wanted = wanted_of(wanted_share, rocks.size());
    if (crossing < wanted) {
        wanted = wanted_of(wanted_share, crossing);
    }
    NetDesign net;
    set_ends(net, std::move(places_m), crossing - (crossing - wanted) / 2, line_length_m);

    std::vector<double> energies_kj;
    std::vector<const Crossing*> met;
    for (const CrossingRock& rock : rocks) {
        if (const Crossing* crossed = first_within(rock, net)) {
            met.push_back(crossed);
            energies_kj.push_back(crossed->energy_kj);
        }
    }
    std::sort(energies_kj.begin(), energies_kj.end());
    wanted = std::min(wanted, met.size());
    const double energy_kj = energies_kj[met.size() - (met.size() - wanted) / 2 - 1];
    const NetClass& of_net = class_for(energy_kj);
    net.energy_class = of_net.name;
    net.capacity_kj =
        std::isfinite(of_net.mel_kj) ? of_net.mel_kj : rounded_up(energy_kj, open_class_step_kj);

    std::vector<double> heights_m;
    for (const Crossing* crossed : met) {
        if (crossed->energy_kj <= net.capacity_kj) {
            heights_m.push_back(crossed->height_m);
        }
    }
    std::sort(heights_m.begin(), heights_m.end());
    net.height_m = std::max(lowest_net_m, rounded_up(heights_m[wanted - 1], height_step_m));
    return net;
}

Left left_below(std::span<const CrossingRock> rocks, const NetDesign& net) {
    // Heights come as float: those that rounding up took for the step itself lie a hair above it.
    constexpr double hair_m = 1e-6;
    std::uint64_t kept = 0;
    double all_kj = 0.0;
    Left left;
    for (const CrossingRock& rock : rocks) {
        all_kj += rock.energy_on_line_kj;
        const auto met = std::find_if(rock.crossings.begin(), rock.crossings.end(), [&](const Crossing& c) {
            return c.along_m >= net.from_m && c.along_m <= net.to_m && c.height_m <= net.height_m + hair_m;
        });
        if (met != rock.crossings.end() && met->energy_kj <= net.capacity_kj) {
            ++kept;
        } else {
            left.energy_kj += rock.energy_on_line_kj;
            left.largest_kj = std::max(left.largest_kj, rock.energy_on_line_kj);
        }
    }
    left.kept = share_of(kept, rocks.size());
    left.energy_percent = all_kj > 0.0 ? 100.0 * left.energy_kj / all_kj : 0.0;
    return left;
}

}  // namespace coupling::siting
