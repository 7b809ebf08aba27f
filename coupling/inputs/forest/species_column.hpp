#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "config/table/table.hpp"
#include "coupling/inputs/forest/species_table.hpp"

namespace coupling {

/// How a species is found: its place in some table by code or Latin name, and the nearest name to a wrong
/// one.
struct SpeciesLookup {
    std::function<std::optional<std::size_t>(const std::string& name)> find;
    std::function<std::string(const std::string& name)> nearest;
    std::string codes;  ///< all that are known: "ABAL, ACPS, ..."
    std::function<bool(std::size_t place)> is_conifer;

    /// What the message of a wrong name suggests: the nearest one, or all codes.
    [[nodiscard]] std::string expected(const std::string& name) const;
};

/// In the shipped species, which must outlive the lookup.
SpeciesLookup lookup_in(const SpeciesTable& known);

/// The column `species` of a table: looks up each name and counts, so that there is one message for each
/// unknown name, wherever else a row is wrong.
class SpeciesColumn {
public:
    /// Looks all rows up and adds a problem for each unknown name. Requires the column.
    SpeciesColumn(const config::Table& table, const SpeciesLookup& lookup, config::Problems& problems);

    /// Place of the row's species, nothing for an unknown one.
    [[nodiscard]] std::optional<std::size_t> find(std::size_t row) const { return species_[row]; }
    /// How often each species was found, by its place.
    [[nodiscard]] std::map<std::size_t, std::size_t> counts() const;
    /// How often each name was found.
    [[nodiscard]] std::map<std::string, std::size_t> counts_by_name() const;

private:
    struct Use {
        std::optional<std::size_t> species{};
        std::size_t first_row = 0;
        std::size_t count = 0;
    };
    std::map<std::string, Use> seen_;
    std::vector<std::optional<std::size_t>> species_;
};

}  // namespace coupling
