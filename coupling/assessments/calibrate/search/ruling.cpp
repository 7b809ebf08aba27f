#include "coupling/assessments/calibrate/search/ruling.hpp"

#include <algorithm>
#include <cmath>

#include "config/random/distributions.hpp"
#include "coupling/inputs/parameters/correlated_draws.hpp"

namespace coupling::calibrate {

double Rule::implausibility(const Eigen::VectorXd& terms) const {
    return std::abs(observed - emulator.at(terms)) / deviation;
}

bool Ruling::keeps(const Eigen::VectorXd& terms) const {
    return std::all_of(rules.begin(), rules.end(),
                       [&](const Rule& rule) { return rule.implausibility(terms) <= most_implausible; });
}

bool keep(std::span<const Ruling> rulings, const Point& point) {
    const Eigen::VectorXd terms = terms_at(point);
    return std::all_of(rulings.begin(), rulings.end(),
                       [&](const Ruling& ruling) { return ruling.keeps(terms); });
}

Ruling ruling_of(std::span<const Ruling> so_far, const std::vector<Fallen>& sets,
                 const std::vector<double>& observed, const std::vector<double>& scatter) {
    std::vector<Fallen> complete;
    std::vector<Fallen> kept;
    for (const Fallen& set : sets) {
        const bool has_all = std::all_of(set.summary->begin(), set.summary->end(),
                                         [](double figure) { return std::isfinite(figure); });
        if (has_all) {
            complete.push_back(set);
            if (keep(so_far, *set.point)) {
                kept.push_back(set);
            }
        }
    }
    if (complete.empty()) {
        return {};
    }
    constexpr std::size_t sets_a_term = 3;
    const auto dimensions = static_cast<std::size_t>(complete.front().point->size());
    const std::vector<Fallen>& fitted =
        kept.size() >= sets_a_term * terms_of(Form::squares, dimensions) ? kept : complete;
    std::vector<Point> points;
    std::vector<std::vector<double>> figures(observed.size());
    for (const Fallen& set : fitted) {
        points.push_back(*set.point);
        for (std::size_t i = 0; i < observed.size(); ++i) {
            figures[i].push_back((*set.summary)[i]);
        }
    }
    std::vector<Emulator> emulators = fitted_emulators(points, figures);
    Ruling ruling;
    for (std::size_t i = 0; i < emulators.size(); ++i) {
        const double deviation = std::hypot(emulators[i].error, scatter[i]);
        if (std::isfinite(deviation) && deviation > 0.0) {
            ruling.rules.push_back(
                {static_cast<std::uint32_t>(i), std::move(emulators[i]), observed[i], deviation});
        }
    }
    return ruling;
}

std::vector<double> deviations_of(const std::vector<std::vector<double>>& summaries) {
    std::vector<double> deviations;
    const auto n = static_cast<double>(summaries.size());
    for (std::size_t i = 0; i < summaries.front().size(); ++i) {
        double mean = 0.0;
        double squares = 0.0;
        for (const std::vector<double>& summary : summaries) {
            mean += summary[i] / n;
        }
        for (const std::vector<double>& summary : summaries) {
            squares += (summary[i] - mean) * (summary[i] - mean);
        }
        deviations.push_back(std::sqrt(squares / (n - 1.0)));
    }
    return deviations;
}

std::vector<double> tolerated(std::vector<double> deviations, const std::vector<Fallen>& kept,
                              const std::vector<double>& observed) {
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        double squares = 0.0;
        for (const Fallen& set : kept) {
            const double off = (*set.summary)[i] - observed[i];
            squares += off * off / static_cast<double>(kept.size());
        }
        deviations[i] = std::max(deviations[i], std::sqrt(squares));
    }
    return deviations;
}

Point point_by_widths(std::size_t dimensions, const std::function<double()>& uniform) {
    static const config::TruncatedNormal normal{most_deviations};
    Point point(static_cast<Eigen::Index>(dimensions));
    for (double& number : point) {
        number = normal(uniform());
    }
    return point;
}

double share_left(std::span<const Ruling> rulings, std::size_t dimensions,
                  const std::function<double()>& uniform) {
    constexpr int enough = 400;
    constexpr int least_draws = 20'000;
    constexpr int most_draws = 2'000'000;
    int kept = 0;
    int drawn = 0;
    while (drawn < least_draws || (kept < enough && drawn < most_draws)) {
        kept += keep(rulings, point_by_widths(dimensions, uniform)) ? 1 : 0;
        ++drawn;
    }
    return static_cast<double>(kept) / drawn;
}

std::vector<double> shares_ruled_out(std::span<const Ruling> rulings, std::size_t dimensions,
                                     const std::vector<std::size_t>& observation_of, std::size_t observations,
                                     const std::function<double()>& uniform) {
    constexpr int draws = 20'000;
    std::vector<double> shares(observations, 0.0);
    for (int i = 0; i < draws; ++i) {
        const Eigen::VectorXd terms = terms_at(point_by_widths(dimensions, uniform));
        std::vector<char> is_out(observations, 0);
        for (const Ruling& ruling : rulings) {
            for (const Rule& rule : ruling.rules) {
                if (rule.implausibility(terms) > most_implausible) {
                    is_out[observation_of[rule.figure]] = 1;
                }
            }
        }
        for (std::size_t k = 0; k < observations; ++k) {
            shares[k] += is_out[k] != 0 ? 1.0 / draws : 0.0;
        }
    }
    return shares;
}

}  // namespace coupling::calibrate
