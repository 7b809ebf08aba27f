#pragma once

namespace coupling {

/// [decision]: what a regime must keep, and how money of later years counts.
struct DecisionSettings {
    double protection_at_least_percent = 90.0;  ///< [0, 100], in all years with rocks after the start
    double probability = 0.8;                   ///< (0, 1), with which it must do so
    double discount_percent = 1.5;              ///< [0, 20] a year, of the present value
    double years_beyond = 20.0;                 ///< >= 0, for which protection stays as in the last year
};

}  // namespace coupling
