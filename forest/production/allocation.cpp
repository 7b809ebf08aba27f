#include "forest/production/allocation.hpp"

#include <numbers>

#include "forest/production/power.hpp"

namespace forest {

double root_share(const RootShare& range, double physiology, double fertility_response) {
    return range.max * range.min / (range.min + (range.max - range.min) * physiology * fertility_response);
}

FoliageToStemLaw::FoliageToStemLaw(const FoliageToStem& ratio)
    : exponent_{config::ln_of(ratio.at_20cm / ratio.at_2cm) / std::numbers::ln10},
      factor_{ratio.at_2cm / config::pow_of(2.0, exponent_)} {}

double FoliageToStemLaw::at(double dbh_cm) const {
    return factor_ * power(dbh_cm, exponent_);
}

double litterfall_pmonth(double age_years, const Litterfall& litterfall) {
    const double mature = litterfall.mature_pmonth;
    const double initial = litterfall.initial_pmonth;
    if (litterfall.median_months * mature == 0.0) {
        return mature;
    }
    constexpr double months_per_year = 12.0;
    const double rate_pyear =
        months_per_year * config::ln_of(1.0 + mature / initial) / litterfall.median_months;
    return mature * initial / (initial + (mature - initial) * config::exp_of(-rate_pyear * age_years));
}

double by_age(double age_years, double young, double mature, double half_years, double power_of_age) {
    if (half_years == 0.0) {
        return mature;
    }
    return mature + (young - mature) *
                        config::exp_of(-std::numbers::ln2 * power(age_years / half_years, power_of_age));
}

}  // namespace forest
