#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coupling {

/// A species and its share of the trees.
struct SpeciesShare {
    std::string name;  ///< code or name, as written
    double share = 1.0;
};

/// "PIAB 60, FASY 30, Acer pseudoplatanus 10", or a single species: shares add up to 1 then. Throws
/// std::invalid_argument with what was found where a share is missing or none is above 0, and where they add
/// up to neither 100 nor 1 (within 1 %).
std::vector<SpeciesShare> species_shares(std::string_view text);

/// The species at a uniform number [0, 1): each as often as its share says.
const std::string& species_at(const std::vector<SpeciesShare>& shares, double uniform);

}  // namespace coupling
