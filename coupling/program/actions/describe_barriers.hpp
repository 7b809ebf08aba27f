#pragma once

#include <cstddef>
#include <ostream>
#include <span>

#include "coupling/inputs/works/work_record.hpp"

namespace coupling {

/// How many nets and works there are, and the earth and the ground that dams and ditches take.
void describe_barriers(std::size_t nets, std::span<const WorkRecord> works, std::ostream& out);

}  // namespace coupling
