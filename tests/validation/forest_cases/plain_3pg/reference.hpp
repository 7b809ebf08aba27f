#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "config/table/table.hpp"
#include "validation/engine/forest_cases/plain_3pg/plain_3pg.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

inline config::Table reference_table(const std::string& name) {
    std::ifstream in{BANNWALD_SOURCE_DIR "/validation/forest_production/" + name};
    return config::Table::read(in, name);
}

/// The demonstration stand of r3PG with the given species of it.
inline Inputs demonstration(const std::vector<std::string>& species, bool thinned = false) {
    const Site site = read_site(reference_table("demo_site.csv"));
    std::vector<StartingSpecies> starting;
    for (const StartingSpecies& candidate : read_species(reference_table("demo_species.csv"))) {
        for (const std::string& wanted : species) {
            if (candidate.species == wanted) {
                starting.push_back(candidate);
            }
        }
    }
    return inputs_of(
        site, starting, read_parameters(reference_table("demo_parameters.csv")),
        read_climate(reference_table("demo_climate.csv"), site),
        thinned ? read_thinnings(reference_table("demo_thinning.csv")) : std::vector<Thinning>{});
}

inline double value(const Row& row, std::string_view column) {
    for (const Column& candidate : columns()) {
        if (candidate.name == column) {
            return candidate.of(row);
        }
    }
    ADD_FAILURE() << "no column " << column;
    return 0.0;
}

}  // namespace coupling::validation::forest_cases::plain_3pg
