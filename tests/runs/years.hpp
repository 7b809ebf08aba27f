#pragma once

#include <sstream>
#include <string>

#include "config/table/table.hpp"
#include "tests/coupling/inputs/forest_project.hpp"
#include "tests/runs/program.hpp"

namespace coupling {

inline config::Table table(const SampleProject& project, const std::string& name) {
    std::istringstream in{project.read(name)};
    return config::Table::read(in, name);
}

inline double number(const config::Table& table, std::size_t row, const std::string& column) {
    return std::stod(table.text(row, column));
}

/// Four members of a few years on 0.8 ha with rocks.
inline constexpr const char* four_members =
    "run scenario.ini --quiet --set trees.file= --set stands.records=records.csv --set run.replicates=2 "
    "--set climate.sequence=random --set \"regimes.list=none, single_tree_selection\" "
    "--set release.rocks=200 --set run.rockfall_every=2 ";

}  // namespace coupling
