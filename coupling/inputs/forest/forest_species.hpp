#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "coupling/inputs/forest/species_column.hpp"
#include "coupling/inputs/forest/species_table.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "forest/parameters.hpp"
#include "forest/stand/species.hpp"

namespace coupling {

/// The species that can grow, and how strong rocks find them.
struct ForestSpecies {
    forest::SpeciesTable table;
    std::vector<double>
        fracture_energy;  ///< by species, relative to Abies alba [-]; empty where no rocks fall
    std::map<forest::SpeciesId, double>
        browsing;  ///< factor on forest.browsing_pressure of species that have one; `table` holds it already

    [[nodiscard]] double browsing_factor(forest::SpeciesId species) const {
        const auto found = browsing.find(species);
        return found == browsing.end() ? 1.0 : found->second;
    }

    /// Finds a species by code or Latin name, or the one that stands in for it. Keeps a reference to this
    /// object.
    [[nodiscard]] SpeciesLookup lookup() const;
};

/// Reads forest.species or takes the shipped table, with the chances of browsing by
/// forest.browsing_by_species. With rocks every species needs a strength in tree_resistance.csv.
std::optional<ForestSpecies> read_forest_species(Reading& reading);

/// The forest's settings with the species of forest.region_species.
std::optional<forest::Parameters> read_forest_parameters(const ForestSpecies& species, Reading& reading);

/// Tells which names of a column grow as another species.
void warn_of_stand_ins(const SpeciesColumn& column, const ForestSpecies& species, const std::string& file,
                       Reading& reading);

}  // namespace coupling
