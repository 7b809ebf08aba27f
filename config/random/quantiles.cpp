#include "config/random/quantiles.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>

#include "config/random/distributions.hpp"

namespace config {
namespace {

namespace policies = boost::math::policies;
using InDouble = policies::policy<policies::promote_float<false>, policies::promote_double<false>,
                                  policies::discrete_quantile<policies::integer_round_down>>;
using Binomial = boost::math::binomial_distribution<double, InDouble>;

}  // namespace

double students_t_quantile(double degrees_of_freedom, double share_below) {
    return quantile(boost::math::students_t_distribution<double, InDouble>{degrees_of_freedom}, share_below);
}

double tolerance_factor(double values, double share_above, double chance) {
    const double root = std::sqrt(values);
    const boost::math::non_central_t_distribution<double, InDouble> spread{
        values - 1.0, normal_quantile(share_above) * root};
    return quantile(complement(spread, chance)) / root;
}

double least_probability(double trials, double hits, double chance) {
    return hits <= 0.0 ? 0.0 : Binomial::find_lower_bound_on_p(trials, hits, chance);
}

double greatest_probability(double trials, double hits, double chance) {
    return hits >= trials ? 1.0 : Binomial::find_upper_bound_on_p(trials, hits, chance);
}

double chance_of_at_most(double most, double trials, double probability) {
    return most < 0.0 ? 0.0 : cdf(Binomial{trials, probability}, std::min(most, trials));
}

double chance_of_more_than(double most, double trials, double probability) {
    return most < 0.0 ? 1.0 : cdf(complement(Binomial{trials, probability}, std::min(most, trials)));
}

double binomial_count(double trials, double probability, double share_below) {
    return quantile(Binomial{trials, probability}, share_below);
}

double gamma_quantile(double shape, double share_below) {
    return boost::math::gamma_p_inv(shape, share_below, InDouble{});
}

}  // namespace config
