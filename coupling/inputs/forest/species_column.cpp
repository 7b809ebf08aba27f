#include "coupling/inputs/forest/species_column.hpp"

#include "config/text/joined.hpp"

namespace coupling {

using config::joined;

SpeciesLookup lookup_in(const SpeciesTable& known) {
    std::string codes;
    for (const Species& species : known.all()) {
        codes += joined(codes.empty() ? "" : ", ", species.code);
    }
    return {[&known](const std::string& name) -> std::optional<std::size_t> {
                const Species* species = known.find(name);
                return species == nullptr
                           ? std::nullopt
                           : std::optional{static_cast<std::size_t>(species - known.all().data())};
            },
            [&known](const std::string& name) { return known.nearest(name); }, codes,
            [&known](std::size_t place) { return known.all()[place].is_conifer; }};
}

std::string SpeciesLookup::expected(const std::string& name) const {
    const std::string near = nearest(name);
    return near.empty() ? joined("a code or Latin name of the species table; codes: ", codes)
                        : joined("a code or Latin name of the species table (", near, "?)");
}

SpeciesColumn::SpeciesColumn(const config::Table& table, const SpeciesLookup& lookup,
                             config::Problems& problems) {
    species_.reserve(table.rows());
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& name = table.text(row, "species");
        const auto [entry, is_new] = seen_.try_emplace(name);
        if (is_new) {
            entry->second = {lookup.find(name), row, 0};
        }
        ++entry->second.count;
        species_.push_back(entry->second.species);
    }
    constexpr std::size_t most_told = 20;  // a column of something else would fill the screen
    std::size_t unknown = 0;
    for (const auto& [name, use] : seen_) {
        if (use.species || ++unknown > most_told) {
            continue;
        }
        std::string found = name.empty() ? "no species" : "species " + config::in_quotes(name);
        if (use.count > 1) {
            found += ", " + std::to_string(use.count) + " times";
        }
        problems.add(config::ExitCode::data, table.place(use.first_row, "species"), std::move(found),
                     lookup.expected(name));
    }
    if (unknown > most_told) {
        problems.add(
            config::ExitCode::data, {table.file()},
            std::to_string(unknown - most_told) + " more names in the column species that are no species",
            "codes or Latin names of the species table");
    }
}

std::map<std::size_t, std::size_t> SpeciesColumn::counts() const {
    std::map<std::size_t, std::size_t> counts;
    for (const auto& [name, use] : seen_) {
        if (use.species) {
            counts[*use.species] += use.count;
        }
    }
    return counts;
}

std::map<std::string, std::size_t> SpeciesColumn::counts_by_name() const {
    std::map<std::string, std::size_t> counts;
    for (const auto& [name, use] : seen_) {
        if (use.species) {
            counts[name] = use.count;
        }
    }
    return counts;
}

}  // namespace coupling
