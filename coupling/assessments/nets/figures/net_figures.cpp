#include "coupling/assessments/nets/figures/net_figures.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "coupling/assessments/nets/figures/net_quantiles.hpp"
#include "coupling/inputs/nets/net_lines.hpp"

namespace coupling {
NetQuantity net_quantity_of(std::vector<double> values) {
    NetQuantity quantity;
    if (values.empty()) {
        return quantity;
    }
    std::sort(values.begin(), values.end());
    quantity.mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    const auto known = [&](std::uint64_t percentile) {
        return percentile_is_known(values.size(), percentile)
                   ? quantile_of(values, static_cast<double>(percentile) / 100.0)
                   : QuantileEstimate{};
    };
    quantity.p50 = known(50).value;
    quantity.p90 = known(90).value;
    quantity.p95 = known(95);
    quantity.p99 = known(99);
    quantity.max = values.back();
    return quantity;
}

const char* name_of(rockfall::NetOutcome outcome) {
    constexpr std::array<const char*, rockfall::net_outcomes> names{"held", "over", "below", "broke"};
    return names[static_cast<std::size_t>(outcome)];
}

double length_m(const rockfall::Net& net) {
    return plan_length_m(net.line_m);
}

std::vector<NetFigures> net_figures(std::span<const NetRecord> nets, std::span<const NetRow> rows,
                                    rockfall::Cover cover, std::uint64_t rocks,
                                    const DesignSettings& settings, const rockfall::Strata& strata) {
    std::vector<NetFigures> all;
    for (std::uint32_t net = 0; net < nets.size(); ++net) {
        std::vector<double> energies_kj;
        std::vector<double> heights_m;
        std::vector<Passage> passages;
        std::array<std::uint64_t, rockfall::net_outcomes> outcomes{};
        for (const NetRow& row : rows) {
            if (row.cover == cover && row.crossing.net == net && row.crossing.first) {
                passages.push_back(passage_of(row.crossing, strata.of(row.rock)));
                energies_kj.push_back(passages.back().energy_kj);
                heights_m.push_back(passages.back().top_m());
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
        figures.design = design_barrier(passages, settings, strata.count);
        if (figures.design) {
            figures.classes = outcomes_by_class(passages, *figures.design);
        }
        figures.energy_kj = net_quantity_of(std::move(energies_kj));
        figures.height_m = net_quantity_of(std::move(heights_m));
    }
    return all;
}

}  // namespace coupling
