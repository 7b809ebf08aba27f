#pragma once

#include <set>
#include <string>
#include <vector>

#include "config/table/table.hpp"

namespace coupling {

/// Shipped ground types by words in the names that people give to grounds (config/data/ground_words.csv).
class GroundProposals {
public:
    GroundProposals();

    /// The type of the longest word in a name, whatever its capitals and accents; "" without any.
    [[nodiscard]] std::string of(const std::string& name) const;

private:
    config::Table words_;
};

/// surface_types.csv of a new project.
struct ProposedTypes {
    std::string table;
    std::string codes;  ///< "1, 2"; "" for none
    std::string names;  ///< "Fels" like bedrock, ...; "" for none
};

/// A row for each code, like `usual`, and for each name, like the type that is proposed for it.
ProposedTypes proposed_types(const std::set<long long>& codes, const std::vector<std::string>& names,
                             const std::string& usual);

}  // namespace coupling
