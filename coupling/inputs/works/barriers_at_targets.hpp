#pragma once

#include <span>

#include "coupling/inputs/nets/net_record.hpp"
#include "coupling/inputs/works/work_record.hpp"
#include "rockfall/tally/target.hpp"

namespace coupling {

class Reading;

/// Warns of nets and walls that run through a house or across a line, and of dams and ditches over a house,
/// across a line or along it: nobody can build them there, and what they hold protects nothing. Areas larger
/// than houses are no obstacle (is_house), and galleries stand over roads. All in coordinates of the terrain.
void judge_barriers_at_targets(std::span<const NetRecord> nets, std::span<const WorkRecord> works,
                               std::span<const rockfall::Target> targets, Reading& reading);

}  // namespace coupling
