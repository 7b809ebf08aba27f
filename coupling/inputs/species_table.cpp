#include "coupling/inputs/species_table.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "config/data/shipped_tables.hpp"
#include "config/table/table.hpp"

namespace coupling {

namespace {

config::Table shipped_table(const std::string& name) {
    std::istringstream in{std::string{config::shipped_table(name)}};
    return config::Table::read(in, name);
}

bool same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

SpeciesTable SpeciesTable::shipped() {
    config::Problems problems;
    SpeciesTable result;
    const config::Table resistance = shipped_table("tree_resistance.csv");
    for (std::size_t row = 0; row < resistance.rows(); ++row) {
        const auto energy =
            resistance.number(row, "fracture_energy", {.low = 0.0, .low_excluded = true}, problems);
        result.species_.push_back(
            {resistance.text(row, "code"), resistance.text(row, "latin_name"), energy.value_or(0.0), ""});
    }
    const config::Table aliases = shipped_table("species_aliases.csv");
    for (std::size_t row = 0; row < aliases.rows(); ++row) {
        for (Species& species : result.species_) {
            if (species.code == aliases.text(row, "code")) {
                species.stand_in = aliases.text(row, "stand_in");
            }
        }
    }
    problems.throw_if_any();
    return result;
}

const Species* SpeciesTable::find(std::string_view code_or_latin_name) const {
    const auto found = std::find_if(species_.begin(), species_.end(), [&](const Species& species) {
        return same_word(species.code, code_or_latin_name) ||
               same_word(species.latin_name, code_or_latin_name);
    });
    return found == species_.end() ? nullptr : &*found;
}

std::string SpeciesTable::nearest(std::string_view code_or_latin_name) const {
    std::vector<std::string> words;
    for (const Species& species : species_) {
        words.push_back(species.code);
        words.push_back(species.latin_name);
    }
    return config::nearest_word(code_or_latin_name, words);
}

}  // namespace coupling
