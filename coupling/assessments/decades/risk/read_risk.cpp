#include "coupling/assessments/decades/risk/read_risk.hpp"

#include <algorithm>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/risk/risk_over_years.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling::decades {
namespace {

/// The whole file counts where its exposed targets do, not its places alone.
void add_inputs(const std::vector<InputFile>& read, std::vector<InputFile>& inputs) {
    for (const InputFile& input : read) {
        const auto known = std::find_if(inputs.begin(), inputs.end(), [&](const InputFile& other) {
            return other.name == input.name && other.role.starts_with(input.role);
        });
        if (known == inputs.end()) {
            inputs.push_back(input);
        } else {
            *known = input;
        }
    }
}

consequences::RiskPlan read_plan(const Scenario& scenario, Reading& reading) {
    consequences::RiskPlan plan = consequences::read_risk_plan(reading, scenario.risk);
    for (const ExposedTarget& target : plan.targets) {
        if (target.id == all_targets) {
            reading.refuse({reading.shown(reading.targets().file)},
                           config::joined("target_id '", all_targets, "' beside risk.assess"),
                           "another name: tables of risk call the sum over targets so");
        }
    }
    reading.finish();
    return plan;
}

}  // namespace

std::optional<consequences::RiskPlan> read_risk(const Scenario& scenario, Site& site,
                                                config::Warnings& warnings) {
    if (!scenario.risk.assess) {
        return std::nullopt;
    }
    config::Warnings known_already;  // the reader of the site has said all of these files
    Reading reading{scenario, known_already};
    consequences::RiskPlan plan = scenario.with_paths([&] { return read_plan(scenario, reading); });
    plan = consequences::on_site(std::move(plan), site.targets);
    add_inputs(reading.inputs(), site.inputs);
    if (plan.settings.curves.empty()) {
        warnings.add(consequences::shipped_curves_warning, config::Effect::answer);
    }
    if (plan.settings.currency != currency_of_timber) {
        warnings.add_note(config::joined(
            "timber and work are in EUR, the risk is in ", plan.settings.currency,
            ": no figure joins them; give the amounts of the risk in EUR and set risk.currency = EUR"));
    }
    return plan;
}

double real_rocks_per_year(const Scenario& scenario) {
    return scenario.risk.rocks_per_year > 0.0 ? scenario.risk.rocks_per_year : scenario.forest.rocks_per_year;
}

}  // namespace coupling::decades
