#include "coupling/assessments/hazard/hazard_plan.hpp"

#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/release/zone_blocks.hpp"
#include "coupling/inputs/scenario/hazard_settings.hpp"

namespace coupling::hazard {
namespace {

using config::joined;
namespace fs = std::filesystem;

Matrix read_matrix(Reading& reading) {
    const std::string& file = reading.hazard().matrix;
    return file.empty() ? Matrix::shipped() : Matrix::read(reading.table("hazard.matrix", "matrix", file));
}

}  // namespace

std::string period_folder(double return_period_years) {
    return joined(period_prefix, config::to_text(return_period_years));
}

HazardPlan read_plan(const Scenario& scenario) {
    config::Warnings ignored;  // the sites of the return periods print them
    Reading reading{scenario, ignored};
    return scenario.with_paths([&] {
        HazardPlan plan{return_periods_of(read_zone_blocks(reading)), read_matrix(reading), {}, {}};
        if (scenario.risk.assess) {
            plan.risk = consequences::read_risk_plan(reading, scenario.risk);
        }
        reading.finish();
        plan.inputs = reading.inputs();
        return plan;
    });
}

std::unique_ptr<Scenario> scenario_of(const fs::path& file, std::vector<std::string> overrides,
                                      double return_period_years, const fs::path& inputs_within) {
    overrides.push_back(joined("hazard.return_period_years=", config::to_text(return_period_years)));
    return read_scenario(file, overrides, inputs_within);
}

}  // namespace coupling::hazard
