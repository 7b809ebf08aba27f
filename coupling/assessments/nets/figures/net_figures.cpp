#include "coupling/assessments/nets/figures/net_figures.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "config/units/constants.hpp"
#include "coupling/inputs/nets/net_classes.hpp"

namespace coupling {
namespace {

using config::j_per_kj;

/// How many of `count` a share is, at least 1.
std::size_t rank_of(double share, std::size_t count) {
    // A hair less, so that 0.95 of 100 is 95 although 0.95 is a little more than that.
    const double wanted = std::ceil(share * static_cast<double>(count) - 1e-9);
    return std::clamp<std::size_t>(static_cast<std::size_t>(std::max(1.0, wanted)), 1, count);
}

NetQuantity quantity_of(std::vector<double> values) {
    NetQuantity quantity;
    if (values.empty()) {
        return quantity;
    }
    std::sort(values.begin(), values.end());
    quantity.mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    const auto known = [&](std::uint64_t percentile) {
        return percentile_is_known(values.size(), percentile)
                   ? quantile_of(values, 0.01 * static_cast<double>(percentile))
                   : QuantileEstimate{};
    };
    quantity.p50 = known(50).value;
    quantity.p90 = known(90).value;
    quantity.p95 = known(95);
    quantity.p99 = known(99);
    quantity.max = values.back();
    return quantity;
}

double rounded_up_m(double height_m) {
    constexpr double steps_per_m = 10.0;
    return std::ceil(height_m * steps_per_m - 1e-6) / steps_per_m;
}

}  // namespace

const char* name_of(rockfall::NetOutcome outcome) {
    constexpr std::array<const char*, rockfall::net_outcomes> names{"held", "over", "below", "broke"};
    return names[static_cast<std::size_t>(outcome)];
}

double length_m(const rockfall::Net& net) {
    double length = 0.0;
    for (std::size_t i = 1; i < net.line_m.size(); ++i) {
        length += (net.line_m[i] - net.line_m[i - 1]).norm();
    }
    return length;
}

QuantileEstimate quantile_of(std::span<const double> sorted, double share) {
    QuantileEstimate estimate;
    estimate.value = sorted[rank_of(share, sorted.size()) - 1];
    const Ranks ranks = quantile_ranks(sorted.size(), share);
    if (ranks.low > 0) {
        estimate.interval.low = sorted[ranks.low - 1];
    }
    if (ranks.high <= sorted.size()) {
        estimate.interval.high = sorted[ranks.high - 1];
    }
    return estimate;
}

std::uint64_t rocks_to_tell(double wanted_share) {
    // A hair less, so that 0.95 asks for 20 although 1 - 0.95 is a little less than a twentieth.
    return static_cast<std::uint64_t>(std::ceil(1.0 / (1.0 - wanted_share) - 1e-6));
}

void find_needs(NetFigures& figures, std::span<const double> energies_kj, std::span<const double> heights_m,
                double wanted_share) {
    if (energies_kj.size() < rocks_to_tell(wanted_share)) {
        return;
    }
    std::vector<double> sorted{energies_kj.begin(), energies_kj.end()};
    std::sort(sorted.begin(), sorted.end());
    figures.energy_needed_kj = sorted[rank_of(0.5 * (1.0 + wanted_share), sorted.size()) - 1];
    const std::size_t wanted = rank_of(wanted_share, sorted.size());
    for (const NetClass& entry : net_classes()) {
        std::vector<double> taken_m;
        for (std::size_t i = 0; i < energies_kj.size(); ++i) {
            if (energies_kj[i] <= entry.mel_kj) {
                taken_m.push_back(heights_m[i]);
            }
        }
        std::sort(taken_m.begin(), taken_m.end());
        NetNeed need{entry.name, entry.mel_kj, std::nullopt, share_of(taken_m.size(), energies_kj.size())};
        if (taken_m.size() >= wanted) {
            need.height_m = rounded_up_m(taken_m[wanted - 1]);
            // Heights come as float: those that rounding up took for the step itself lie a hair above it.
            constexpr double hair_m = 1e-6;
            const auto below = std::upper_bound(taken_m.begin(), taken_m.end(), *need.height_m + hair_m);
            need.held = share_of(static_cast<std::uint64_t>(below - taken_m.begin()), energies_kj.size());
        }
        if (entry.name == class_for(figures.energy_needed_kj).name) {
            figures.recommended = figures.needs.size();
        }
        figures.needs.push_back(std::move(need));
    }
}

std::vector<NetFigures> net_figures(std::span<const NetRecord> nets, std::span<const NetRow> rows,
                                    rockfall::Cover cover, std::uint64_t rocks, double wanted_share) {
    std::vector<NetFigures> all;
    for (std::uint32_t net = 0; net < nets.size(); ++net) {
        std::vector<double> energies_kj;
        std::vector<double> heights_m;
        std::array<std::uint64_t, rockfall::net_outcomes> outcomes{};
        for (const NetRow& row : rows) {
            if (row.cover == cover && row.crossing.net == net && row.crossing.first) {
                energies_kj.push_back(static_cast<double>(row.crossing.energy_j) / j_per_kj);
                heights_m.push_back(static_cast<double>(row.crossing.height_m));
                ++outcomes[static_cast<std::size_t>(row.crossing.outcome)];
            }
        }
        NetFigures& figures = all.emplace_back();
        figures.net = net;
        figures.cover = cover;
        figures.reached = share_of(energies_kj.size(), rocks);
        for (std::size_t i = 0; i < outcomes.size(); ++i) {
            figures.outcome[i] = share_of(outcomes[i], energies_kj.size());
        }
        find_needs(figures, energies_kj, heights_m, wanted_share);
        figures.energy_kj = quantity_of(std::move(energies_kj));
        figures.height_m = quantity_of(std::move(heights_m));
    }
    return all;
}

}  // namespace coupling
