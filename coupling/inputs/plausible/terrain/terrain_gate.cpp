#include "coupling/inputs/plausible/terrain/terrain_gate.hpp"

#include <array>

#include "coupling/inputs/plausible/terrain/limits.hpp"
#include "coupling/inputs/plausible/terrain/spikes.hpp"
#include "coupling/inputs/plausible/terrain/steep.hpp"
#include "coupling/inputs/plausible/terrain/steps.hpp"
#include "coupling/inputs/plausible/terrain/stripes.hpp"
#include "coupling/inputs/plausible/terrain/uneven.hpp"
#include "coupling/inputs/plausible/terrain/upside_down.hpp"

namespace coupling::plausible::terrain {

std::span<const Rule> all_rules() {
    // A picture in 8 bits has steps, stripes have bends: the order names the cause.
    static constexpr std::array rules{
        Rule{"picture", judge_pictures},    Rule{"ups_and_downs", judge_ups_and_downs},
        Rule{"steps", judge_steps},         Rule{"stripes", judge_stripes},
        Rule{"spikes", judge_spikes},       Rule{"unevenness", judge_unevenness},
        Rule{"steepness", judge_steepness}, Rule{"upside_down", judge_upside_down},
        Rule{"cell_size", judge_cell_size},
    };
    return rules;
}

std::vector<Verdict> judge_heights(const HeightField& field) {
    std::vector<Verdict> verdicts;
    if (values_of(field).known < limits::fewest_cells) {
        return verdicts;
    }
    for (const Rule& rule : all_rules()) {
        if (std::optional<Finding> finding = rule.judge(field)) {
            if (finding->is_error) {
                return {{rule.name, std::move(*finding)}};
            }
            verdicts.push_back({rule.name, std::move(*finding)});
        }
    }
    return verdicts;
}

}  // namespace coupling::plausible::terrain
