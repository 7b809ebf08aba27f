#pragma once

#include <string>

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

}  // namespace coupling
