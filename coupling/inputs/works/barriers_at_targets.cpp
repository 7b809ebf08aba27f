#include "coupling/inputs/works/barriers_at_targets.hpp"

#include "config/text/joined.hpp"
#include "coupling/inputs/places/line_through.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/scenario/net_settings.hpp"

namespace coupling {
namespace {

using config::joined;

/// Whether a line lies on an axis: half of the axis or more is within so much of it.
bool lies_along(const rockfall::Target& line, const std::vector<Eigen::Vector2d>& axis_m, double within_m) {
    constexpr int samples = 50;  // on each piece of the axis
    double on_m = 0.0;
    double all_m = 0.0;
    for (std::size_t i = 0; i + 1 < axis_m.size(); ++i) {
        const Eigen::Vector2d way_m = axis_m[i + 1] - axis_m[i];
        for (int k = 0; k < samples; ++k) {
            const Eigen::Vector2d place_m = axis_m[i] + (k + 0.5) / samples * way_m;
            all_m += way_m.norm() / samples;
            on_m += rockfall::first_touch(line, place_m, place_m, within_m) ? way_m.norm() / samples : 0.0;
        }
    }
    return on_m > 0.0 && on_m >= 0.5 * all_m;
}

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

/// Of what stands upright and crosses a road.
void warn_of_crossed(const std::string& barrier, const std::vector<Eigen::Vector2d>& line_m,
                     std::span<const rockfall::Target> targets, const std::string& file, Reading& reading) {
    const std::vector<const rockfall::Target*> met = targets_under(line_m, targets, runs_across);
    if (met.empty()) {
        return;
    }
    const std::string first = config::in_quotes(met.front()->id);
    reading.warn({shown_tables(file, reading)},
                 met.size() == 1
                     ? joined(barrier, " across the line ", first)
                     : joined(barrier, " across ", std::to_string(met.size()), " lines, such as ", first),
                 "a place beside roads and ways",
                 "end it there if that is a road: nobody can build it across one", config::Effect::answer);
}

}  // namespace

void judge_barriers_at_targets(std::span<const NetRecord> nets, std::span<const WorkRecord> works,
                               std::span<const rockfall::Target> targets, Reading& reading) {
    // A line may be a mark at which rocks are counted, along a barrier or across its foot.
    const auto runs_through_house = [](const auto& line_m, const rockfall::Target& target) {
        return is_house(target) && runs_over(line_m, target);
    };
    const auto lies_under = [](const WorkRecord& work) {
        return [&work](const auto& ring_m, const rockfall::Target& target) {
            return target.is_area ? is_house(target) && covers_part(ring_m, target)
                                  : lies_along(target, work.line_m, 0.5 * work.width_m) ||
                                        runs_over(work.line_m, target);
        };
    };
    for (const NetRecord& net : nets) {
        const std::string name = joined("the net ", config::in_quotes(net.name));
        warn_of(name, targets_under(net.net.line_m, targets, runs_through_house), reading.nets().file,
                reading);
        warn_of_crossed(name, net.net.line_m, targets, reading.nets().file, reading);
    }
    for (const WorkRecord& work : works) {
        const std::string name = joined("the work ", config::in_quotes(work.name));
        if (is_of_earth(work.kind)) {
            warn_of(name, targets_under(work.outline_m, targets, lies_under(work)), reading.works().file,
                    reading);
        } else if (work.kind == WorkKind::wall) {
            warn_of(name, targets_under(work.line_m, targets, runs_through_house), reading.works().file,
                    reading);
            warn_of_crossed(name, work.line_m, targets, reading.works().file, reading);
        }
    }
}

}  // namespace coupling
