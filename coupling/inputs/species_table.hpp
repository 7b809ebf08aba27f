#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coupling {

/// A species as the shipped tables know it.
struct Species {
    std::string code;  ///< four capitals, such as ABAL
    std::string latin_name;
    double fracture_energy = 0;  ///< relative to Abies alba [-]
    std::string stand_in;        ///< code of the species whose other parameters it takes, "" with its own
};

/// Finds species by code or Latin name, upper or lower case alike.
class SpeciesTable {
public:
    /// From config/data/tree_resistance.csv and species_aliases.csv.
    static SpeciesTable shipped();

    /// Null for a species that no table knows.
    [[nodiscard]] const Species* find(std::string_view code_or_latin_name) const;
    /// The code or name that comes nearest to what the user wrote, "" if none is near.
    [[nodiscard]] std::string nearest(std::string_view code_or_latin_name) const;
    [[nodiscard]] const std::vector<Species>& all() const { return species_; }

private:
    std::vector<Species> species_;
};

}  // namespace coupling
