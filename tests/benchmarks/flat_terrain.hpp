#pragma once

#include <istream>
#include <ostream>

#include "rockfall/terrain/terrain.hpp"

namespace benchmarks {

/// A terrain as its bytes lie in memory, for one machine only: lets a program run without CGAL, which does
/// not work under valgrind.
void write_flat(std::ostream& out, const rockfall::Terrain& terrain);
/// Throws std::runtime_error where the bytes end too early.
rockfall::Terrain read_flat(std::istream& in);

}  // namespace benchmarks
