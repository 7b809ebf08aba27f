#include "coupling/assessments/nets/siting/stretches.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coupling::siting {

std::vector<LineBin> bins_along(double length_m, std::span<const LineArrival> arrivals) {
    // A rest of a few centimetres is no piece of its own.
    constexpr double least_rest_m = 0.1;
    const auto count =
        std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil((length_m - least_rest_m) / bin_m)));
    std::vector<LineBin> bins(count);
    for (std::size_t i = 0; i < count; ++i) {
        bins[i].from_m = bin_m * static_cast<double>(i);
        bins[i].to_m = i + 1 == count ? length_m : bin_m * static_cast<double>(i + 1);
    }
    for (const LineArrival& arrival : arrivals) {
        const double place = std::max(0.0, arrival.along_m / bin_m);
        LineBin& bin = bins[std::min(count - 1, static_cast<std::size_t>(place))];
        ++bin.rocks;
        bin.energies_kj.push_back(arrival.energy_kj);
    }
    for (LineBin& bin : bins) {
        std::sort(bin.energies_kj.begin(), bin.energies_kj.end());
        bin.energy_sum_kj = std::accumulate(bin.energies_kj.begin(), bin.energies_kj.end(), 0.0);
    }
    return bins;
}

std::vector<Stretch> needed_stretches(std::span<const LineBin> bins, double wanted_share) {
    std::vector<std::size_t> order(bins.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto density = [&](std::size_t i) {
        return bins[i].energy_sum_kj / (bins[i].to_m - bins[i].from_m);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return density(a) > density(b); });
    const double all_kj = std::accumulate(bins.begin(), bins.end(), 0.0, [](double sum, const LineBin& bin) {
        return sum + bin.energy_sum_kj;
    });
    std::vector<bool> needed(bins.size(), false);
    double covered_kj = 0.0;
    for (const std::size_t i : order) {
        if (!(covered_kj < wanted_share * all_kj)) {
            break;
        }
        needed[i] = true;
        covered_kj += bins[i].energy_sum_kj;
    }
    std::vector<Stretch> stretches;
    for (std::size_t i = 0; i < bins.size(); ++i) {
        if (!needed[i]) {
            continue;
        }
        constexpr double hair_m = 1e-9;
        if (!stretches.empty() && bins[i].from_m - stretches.back().to_m <= joined_gap_m + hair_m) {
            stretches.back().to_m = bins[i].to_m;
        } else {
            stretches.push_back({bins[i].from_m, bins[i].to_m});
        }
    }
    return stretches;
}

}  // namespace coupling::siting
