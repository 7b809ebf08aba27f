#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace coupling {

/// An energy class of nets: config/data/net_classes.csv.
struct NetClass {
    std::string name;
    double mel_kj = std::numeric_limits<double>::infinity();  ///< infinite: an open class
    std::optional<double> sel_kj;                             ///< service energy level; nothing: none
};

/// All classes, weakest first, the open one last.
const std::vector<NetClass>& net_classes();

/// What nets of the strongest class with a level hold [kJ]: the open class begins above it.
double strongest_closed_kj();

/// The weakest class that takes an energy.
const NetClass& class_for(double energy_kj);

}  // namespace coupling
