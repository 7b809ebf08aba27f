#include "coupling/assessments/calibrate/sites/run_kind.hpp"

#include "config/errors/input_error.hpp"
#include "coupling/inputs/parameters/parameter_knowledge.hpp"

namespace coupling::calibrate {

void refuse_other_runs(const Scenario& scenario) {
    const char* other = scenario.run.years != 0             ? "run.years above 0"
                        : !scenario.terrain.profile.empty() ? "terrain.profile"
                        : wants_hazard_map(scenario)        ? "a hazard map"
                        : !scenario.run.parameter_draws     ? "run.parameter_draws = no"
                                                            : nullptr;
    if (other != nullptr) {
        config::fail(config::ExitCode::settings, {scenario.file.string()}, other,
                     scenario.run.parameter_draws ? "an assessment of today on a map: the rocks of one event"
                                                  : "draws: their widths are what is known before");
    }
}

void refuse_samples(const Scenario& scenario, const Site& site) {
    if (site.knowledge->sample) {
        config::fail(config::ExitCode::settings, scenario.options->place_of("run.parameters"),
                     "the sample of an earlier calibration", "widths: a sample is a result, not a beginning",
                     "leave run.parameters out, or name a table of widths");
    }
}

}  // namespace coupling::calibrate
