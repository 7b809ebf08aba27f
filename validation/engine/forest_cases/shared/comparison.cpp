#include "validation/engine/forest_cases/shared/comparison.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "config/text/joined.hpp"

namespace coupling::validation::forest_cases {

namespace {

using config::joined;

}  // namespace

void declare(config::Options& options, Settings& settings, CaseKind kind) {
    if (kind == CaseKind::forest_light) {
        options.count("light.first_month", settings.light.first_month,
                      {.low = 1.0, .high = 12.0, .meaning = "first month that light is a mean of"});
        options.count("light.last_month", settings.light.last_month,
                      {.low = 1.0, .high = 12.0, .meaning = "last month that light is a mean of"});
        options.number("light.least_angle_deg", settings.light.least_angle_deg,
                       {.unit = "deg",
                        .low = 0.0,
                        .high = 60.0,
                        .meaning = "light flatter than this to the ground does not count"});
    }
}

Comparison read(CaseKind kind, const CaseFiles& files, const Settings& settings) {
    switch (kind) {
        case CaseKind::forest_production:
            return read_production(files);
        case CaseKind::forest_light:
            return read_light(files, settings.light);
        case CaseKind::slope:
        case CaseKind::profile:
        case CaseKind::factors:
        case CaseKind::field:
        case CaseKind::collapse:
        case CaseKind::forest_years:
            break;
    }
    throw std::logic_error{"no kind of the forest"};
}

std::string code_in_figures(const forest::Species& species) {
    std::string code = species.code;
    std::transform(code.begin(), code.end(), code.begin(), [](unsigned char c) { return std::tolower(c); });
    return code;
}

}  // namespace coupling::validation::forest_cases
