#include "coupling/inputs/scenario/hazard_settings.hpp"

namespace coupling {

void declare(config::Options& options, RiskSettings& risk) {
    const std::vector<config::Need> assessed{{"risk.assess", {"yes"}}};
    const std::vector<config::Need> on_hazard_maps{{"risk.assess", {"yes"}}, {"run.years", {"0"}}};
    options.flag(
        "risk.assess", risk.assess,
        {.meaning = "with the hazard map or over years: deaths, damage and closures a year at targets "
                    "that have vehicles_per_day, persons or house_value; needs hazard.blocks or "
                    "run.years > 0",
         .source = "choice"});
    options.file("risk.curves", risk.curves,
                 {.meaning = "CSV of lethality and damage by energy, as `bannwald info risk_curves` shows "
                             "it; none: that one",
                  .needs = assessed});
    options.number("risk.rocks_per_year", risk.rocks_per_year,
                   {.unit = "1/yr",
                    .low = 0.0,
                    .high = 1e6,
                    .meaning = "over years: rocks that really start in a year on the whole slope; 0: "
                               "feedback.rocks_per_year",
                    .source = "needed with run.years > 0",
                    .needs = assessed});
    options.number("risk.vehicle_length_m", risk.vehicle_length_m,
                   {.unit = "m",
                    .low = 0.5,
                    .high = 400.0,
                    .meaning = "length of a vehicle on roads whose target has no vehicle_length_m",
                    .source = "choice",
                    .needs = assessed});
    options.number("risk.passages_per_day", risk.passages_per_day,
                   {.low = 0.0,
                    .high = 1000.0,
                    .meaning = "passages a day of the one person whose individual risk on a road is given",
                    .source = "choice: there and back",
                    .needs = assessed});
    options.number("risk.prevented_death", risk.prevented_death,
                   {.low = 0.0,
                    .high = 1e12,
                    .meaning = "worth of preventing one death, in risk.currency",
                    .source = "choice",
                    .needs = assessed});
    options.number("risk.closure_days", risk.closure_days,
                   {.unit = "days",
                    .low = 0.0,
                    .high = 3650.0,
                    .meaning = "closure of a road after each rock that hits it",
                    .source = "choice",
                    .needs = assessed});
    options.number("risk.closure_cost_per_day", risk.closure_cost_per_day,
                   {.low = 0.0,
                    .high = 1e12,
                    .meaning = "what a day of closure costs, in risk.currency",
                    .source = "choice",
                    .needs = assessed});
    options.text("risk.without", risk.without,
                 {.meaning = "folder of a finished hazard run of the same rocks without nets and works: what "
                             "they spare a year, and what that costs; none: not assessed",
                  .needs = on_hazard_maps});
    options.number("risk.interest_percent", risk.interest_percent,
                   {.unit = "%",
                    .low = 0.0,
                    .high = 30.0,
                    .meaning = "interest a year on the investment in nets and works",
                    .source = "choice",
                    .needs = on_hazard_maps});
    options.number("risk.individual_goal", risk.individual_goal,
                   {.unit = "1/yr",
                    .low = 1e-9,
                    .high = 1.0,
                    .meaning = "protection goal: individual risk of death a year that is not to be exceeded",
                    .source = "Canton of Bern, protection goals of its risk strategy: 1e-5",
                    .needs = on_hazard_maps});
    options.text("risk.currency", risk.currency,
                 {.meaning = "name of the currency of all amounts", .source = "choice", .needs = assessed});
}

void check(const RiskSettings& risk, const config::Options& options, config::Problems& problems) {
    if ((risk.closure_days > 0.0) != (risk.closure_cost_per_day > 0.0)) {
        const bool days = risk.closure_days > 0.0;
        const char* given = days ? "risk.closure_days" : "risk.closure_cost_per_day";
        const char* other = days ? "risk.closure_cost_per_day" : "risk.closure_days";
        problems.add(config::ExitCode::settings, options.place_of(given),
                     std::string{given} + " without " + other, "both above 0, or none of them");
    }
    if (risk.currency.empty()) {
        problems.add(config::ExitCode::settings, options.place_of("risk.currency"), "no risk.currency",
                     "a name, such as CHF or EUR");
    }
}

}  // namespace coupling
