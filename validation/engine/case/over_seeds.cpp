#include "validation/engine/case/over_seeds.hpp"

#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace coupling::validation {
namespace {

double mean_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    return sum / static_cast<double>(values.size());
}

double deviation_of(const std::vector<double>& values) {
    const double mean = mean_of(values);
    double sum = 0.0;
    for (const double value : values) {
        sum += (value - mean) * (value - mean);
    }
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

/// Puts means and deviations in the place of the values of the first seed.
void combine(const std::vector<std::map<std::string, double>>& seeds, Outcome& outcome) {
    for (auto& [name, value] : outcome.values) {
        std::vector<double> values;
        for (const std::map<std::string, double>& seed : seeds) {
            values.push_back(seed.at(name));
        }
        value = mean_of(values);
        if (std::isfinite(value)) {
            outcome.seed_deviations[name] = deviation_of(values);
        }
    }
}

}  // namespace

Comparison over_seeds(Comparison first, std::vector<std::function<Comparison()>> more) {
    if (more.empty()) {
        return first;
    }
    first.extent += ", " + std::to_string(more.size() + 1) + " seeds";
    first.pieces *= more.size() + 1;
    first.run = [run = std::move(first.run), more = std::move(more)](const Work& work) {
        Outcome outcome = run(work);
        std::vector<std::map<std::string, double>> seeds{outcome.values};
        for (const std::function<Comparison()>& read : more) {
            seeds.push_back(read().run(work).values);
        }
        combine(seeds, outcome);
        for (PlotGroup& group : outcome.plots) {
            group.title += ", first seed";
        }
        return outcome;
    };
    return first;
}

}  // namespace coupling::validation
