#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coupling {

/// A species as the shipped tables know it.
struct Species {
    std::string code;  ///< four capitals, such as ABAL
    std::string latin_name;
    double fracture_energy = 0;      ///< relative to Abies alba [-]
    std::string stand_in;            ///< code of the species whose other parameters it takes, "" with its own
    std::vector<std::string> names;  ///< in other languages and short forms, as `letters_of_name` has them
    std::vector<std::string> written_names{};  ///< the same as people write them
    bool is_conifer = false;
};

/// The letters by which names of species are compared: lower case, umlauts and accents written out or left
/// out (`Lärche`, `LAERCHE` and `laerche` are one), without blanks, dots and
/// hyphens. Other marks stay: `Fi?` is no spruce.
std::string letters_of_name(std::string_view name);

/// Finds species by code, Latin name, German, French, Italian or English name or a common short form, upper
/// or lower case alike. What inventories write around a Latin name does not count (botanical_name.hpp).
class SpeciesTable {
public:
    /// From config/data/tree_resistance.csv, species_names.csv and species_aliases.csv.
    static SpeciesTable shipped();

    /// Null for a species that no table knows.
    [[nodiscard]] const Species* find(std::string_view code_or_name) const;
    /// The code or name that comes nearest to what the user wrote, or all species of its genus; "" if none is
    /// near.
    [[nodiscard]] std::string nearest(std::string_view code_or_name) const;
    [[nodiscard]] const std::vector<Species>& all() const { return species_; }

private:
    [[nodiscard]] const Species* find_as_written(std::string_view code_or_name) const;
    [[nodiscard]] bool has_genus(std::string_view genus) const;

    std::vector<Species> species_;
};

}  // namespace coupling
