#include "coupling/assessments/decades/decision/worst_year.hpp"

#include <algorithm>

#include "config/random/quantiles.hpp"
#include "config/random/stream.hpp"
#include "coupling/assessments/decades/decision/course_law.hpp"

namespace coupling::decades {
namespace {

/// A draw of Beta(a, b) by two numbers on [0, 1): nothing and all where one of them is 0.
double beta_of(double a, double b, double of_yes, double of_no) {
    if (a == 0.0 || b == 0.0) {
        return a == 0.0 ? 0.0 : 1.0;
    }
    const double yes = config::gamma_quantile(a, of_yes);
    return yes / (yes + config::gamma_quantile(b, of_no));
}

}  // namespace

/// What so many of so many replicates tell: a draw of Beta(k + 1/2, n - k + 1/2) (Jeffreys 1946), and with
/// the same numbers of Beta(k, n - k + 1) and Beta(k + 1, n - k), whose quantiles are the exact bounds
/// (Clopper & Pearson 1934).
WorstYear::WorstYear(std::span<const double> kept, std::size_t replicates) {
    for (std::size_t draw = 0; draw < kept.size() * CourseLaw::draws_of_group; ++draw) {
        // Beside the numbers of the courses (course_law.cpp).
        config::RandomStream numbers{{1, 0, 0, draw + 1}, config::Purpose::parameter};
        const double of_yes = numbers.uniform();
        const double of_no = numbers.uniform();
        const double k = kept[draw / CourseLaw::draws_of_group];
        const double rest = static_cast<double>(replicates) - k;
        middles_.push_back(beta_of(k + 0.5, rest + 0.5, of_yes, of_no));
        lows_.push_back(beta_of(k, rest + 1.0, of_yes, of_no));
        highs_.push_back(beta_of(k + 1.0, rest, of_yes, of_no));
    }
    for (std::vector<double>* list : {&middles_, &lows_, &highs_}) {
        std::sort(list->begin(), list->end());
    }
}

double WorstYear::quantile(const std::vector<double>& rising, double share) {
    const double place = share * static_cast<double>(rising.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, rising.size() - 1);
    return rising[below] + (place - static_cast<double>(below)) * (rising[above] - rising[below]);
}

}  // namespace coupling::decades
