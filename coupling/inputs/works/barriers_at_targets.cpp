#include "coupling/inputs/works/barriers_at_targets.hpp"

#include "config/text/joined.hpp"
#include "coupling/inputs/places/line_through.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/scenario/net_settings.hpp"

namespace coupling {
namespace {

using config::joined;

void warn_of(const std::string& barrier, const std::vector<const rockfall::Target*>& met,
             const std::string& file, Reading& reading) {
    if (met.empty()) {
        return;
    }
    const std::string first = config::in_quotes(met.front()->id);
    reading.warn(
        {shown_tables(file, reading)},
        met.size() == 1 ? joined(barrier, " over the target ", first)
                        : joined(barrier, " over ", std::to_string(met.size()), " targets, such as ", first),
        "a place upslope of what it protects", "move it: nobody can build it there", config::Effect::answer);
}

}  // namespace

void judge_barriers_at_targets(std::span<const NetRecord> nets, std::span<const WorkRecord> works,
                               std::span<const rockfall::Target> targets, Reading& reading) {
    // A line may be a mark at which rocks are counted, along a net or across it; a house is none.
    const auto runs_through_house = [](const auto& line_m, const rockfall::Target& target) {
        return target.is_area && runs_over(line_m, target);
    };
    for (const NetRecord& net : nets) {
        warn_of(joined("the net ", config::in_quotes(net.name)),
                targets_under(net.net.line_m, targets, runs_through_house), reading.nets().file, reading);
    }
    for (const WorkRecord& work : works) {
        const std::string name = joined("the work ", config::in_quotes(work.name));
        if (is_of_earth(work.kind)) {
            warn_of(name, targets_under(work.outline_m, targets, covers_part), reading.works().file, reading);
        } else if (work.kind == WorkKind::wall) {
            warn_of(name, targets_under(work.line_m, targets, runs_through_house), reading.works().file,
                    reading);
        }
    }
}

}  // namespace coupling
