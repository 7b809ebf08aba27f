#include <algorithm>
#include <cmath>

#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/validation/page_parts.hpp"

namespace coupling::validation {

std::string factors_part(const CaseResult&) {
    return "";
}

}  // namespace coupling::validation
