#include "coupling/assessments/vary/study/outcomes.hpp"

#include <limits>

namespace coupling::vary {

double TargetOutcome::answer(bool with_forest) const {
    if (!with_forest) {
        return bare.share.value;
    }
    return protection && !too_few ? protection->value : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace coupling::vary
