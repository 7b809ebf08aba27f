#include "config/random/latin_hypercube.hpp"

#include <numeric>
#include <utility>

namespace config {
namespace {

using Order = std::vector<std::int64_t>;

Order random_order(RandomStream& stream, std::size_t points) {
    Order order(points);
    std::iota(order.begin(), order.end(), std::int64_t{0});
    for (std::size_t i = points; i > 1; --i) {
        const auto other = static_cast<std::size_t>(stream.uniform() * static_cast<double>(i));
        std::swap(order[i - 1], order[other]);
    }
    return order;
}

/// Of ranks around their middle, in whole numbers: the same on every machine.
std::int64_t covariance(const Order& a, const Order& b) {
    const auto points = static_cast<std::int64_t>(a.size());
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += (2 * a[i] + 1 - points) * (2 * b[i] + 1 - points);
    }
    return sum;
}

double badness(const Order& order, const std::vector<Order>& before) {
    double sum = 0.0;
    for (const Order& other : before) {
        const auto shared = static_cast<double>(covariance(order, other));
        sum += shared * shared;
    }
    return sum;
}

}  // namespace

std::vector<std::vector<double>> latin_hypercube(const StreamKey& key, Purpose purpose,
                                                 std::span<const std::uint64_t> dimensions,
                                                 std::size_t points) {
    constexpr int candidates = 32;
    std::vector<std::vector<double>> cube(points, std::vector<double>(dimensions.size()));
    std::vector<Order> orders;
    for (std::size_t d = 0; d < dimensions.size(); ++d) {
        RandomStream stream{{key.seed, key.replicate, key.year, dimensions[d]}, purpose};
        std::vector<double> inside(points);
        for (double& u : inside) {
            u = stream.uniform();
        }
        Order best = random_order(stream, points);
        double least = badness(best, orders);
        for (int i = 1; i < candidates; ++i) {
            Order order = random_order(stream, points);
            const double of_order = badness(order, orders);
            if (of_order < least) {
                least = of_order;
                best = std::move(order);
            }
        }
        for (std::size_t i = 0; i < points; ++i) {
            cube[i][d] = (static_cast<double>(best[i]) + inside[i]) / static_cast<double>(points);
        }
        orders.push_back(std::move(best));
    }
    return cube;
}

}  // namespace config
