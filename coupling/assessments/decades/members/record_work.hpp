#pragma once

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/exchange/regimes/apply.hpp"
#include "coupling/exchange/regimes/timber_value.hpp"

namespace coupling::decades {

/// Writes down what people did in a year and what it brought. Years without anything due leave nothing.
void record_work(const RegimeReport& report, const Regime& regime, const PriceTable& prices,
                 double machine_m3ph, std::int32_t year, MemberYears& kept);

}  // namespace coupling::decades
