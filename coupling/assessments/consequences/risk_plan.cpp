#include "coupling/assessments/consequences/risk_plan.hpp"

#include <algorithm>
#include <utility>

#include "config/errors/input_error.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling::consequences {

RiskPlan read_risk_plan(Reading& reading, const RiskSettings& settings) {
    RiskPlan plan{{}, Curves::shipped(), settings};
    if (auto targets =
            reading.attempt([&] { return read_exposed_targets(reading, settings.vehicle_length_m); })) {
        plan.targets = std::move(*targets);
    }
    if (!settings.curves.empty()) {
        if (auto curves = reading.attempt(
                [&] { return Curves::read(reading.table("risk.curves", "risk_curves", settings.curves)); })) {
            plan.curves = std::move(*curves);
        }
    }
    return plan;
}

RiskPlan on_site(RiskPlan plan, std::span<const rockfall::Target> targets) {
    std::erase_if(plan.targets, [&](const ExposedTarget& exposed) {
        return std::none_of(targets.begin(), targets.end(),
                            [&](const rockfall::Target& target) { return target.id == exposed.id; });
    });
    if (plan.targets.empty()) {
        config::fail(
            config::ExitCode::data, {},
            "no target on the terrain with vehicles_per_day, persons or house_value beside risk.assess",
            "an exposed road or house that rocks can reach",
            "take a larger terrain, or set risk.assess = no");
    }
    return plan;
}

std::size_t place_among(const std::string& id, std::span<const rockfall::Target> targets) {
    const auto found = std::find_if(targets.begin(), targets.end(),
                                    [&](const rockfall::Target& target) { return target.id == id; });
    if (found == targets.end()) {
        config::fail(config::ExitCode::data, {}, config::in_quotes(id), "a target of this scenario");
    }
    return static_cast<std::size_t>(found - targets.begin());
}

}  // namespace coupling::consequences
