#pragma once

#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling {

/// Two nets across the fall of a sample project: a weak one above, one of class 1 below.
inline void add_nets(const SampleProject& project) {
    project.write("nets.csv",
                  "name,height_m,capacity_kj,class,gap_m,wkt\n"
                  "upper,1.2,5,,0.1,\"LINESTRING (1075 2010, 1078 2050, 1075 2090)\"\n"
                  "lower,3,,1,,\"LINESTRING (1098 2005, 1098 2095)\"\n");
    project.replace("scenario.ini", "[targets]", "[nets]\nfile = nets.csv\n[targets]");
}

}  // namespace coupling
