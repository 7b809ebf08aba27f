#include "coupling/inputs/forest/species_table.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <sstream>

#include "config/data/shipped_tables.hpp"
#include "config/table/table.hpp"
#include "config/text/joined.hpp"
#include "config/text/plain_letters.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/forest/botanical_name.hpp"

namespace coupling {

namespace {

bool same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// The first word of a name: the genus of a Latin one.
std::string_view genus_of(std::string_view name) {
    return name.substr(0, name.find(' '));
}

}  // namespace

std::string letters_of_name(std::string_view name) {
    static constexpr std::string_view passed_over = " \t.-_'";
    std::string letters = config::plain_letters(name);
    std::erase_if(letters, [](char c) { return passed_over.find(c) != std::string_view::npos; });
    return letters;
}

SpeciesTable SpeciesTable::shipped() {
    config::Problems problems;
    SpeciesTable result;
    const config::Table resistance = config::read_shipped_table("tree_resistance.csv");
    for (std::size_t row = 0; row < resistance.rows(); ++row) {
        const auto energy =
            resistance.number(row, "fracture_energy", {.low = 0.0, .low_excluded = true}, problems);
        result.species_.push_back({resistance.text(row, "code"),
                                   resistance.text(row, "latin_name"),
                                   energy.value_or(0.0),
                                   "",
                                   {},
                                   {},
                                   resistance.text(row, "group") == "conifer"});
    }
    const config::Table names = config::read_shipped_table("species_names.csv");
    for (std::size_t row = 0; row < names.rows(); ++row) {
        for (Species& species : result.species_) {
            if (species.code != names.text(row, "code")) {
                continue;
            }
            for (const char* column : {"german", "french", "italian", "english", "short"}) {
                std::istringstream words{names.text(row, column)};
                for (std::string word; std::getline(words, word, '/');) {
                    species.names.push_back(letters_of_name(word));
                    species.written_names.push_back(word);
                }
            }
        }
    }
    const config::Table aliases = config::read_shipped_table("species_aliases.csv");
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

const Species* SpeciesTable::find(std::string_view code_or_name) const {
    if (const Species* species = find_as_written(code_or_name)) {
        return species;
    }
    for (const std::string& reading : botanical_readings(code_or_name)) {
        // Alone a word counts as a genus only: "Tanne L." is no name.
        const bool is_binomial = reading.find(' ') != std::string::npos;
        if (const Species* species = is_binomial || has_genus(reading) ? find_as_written(reading) : nullptr) {
            return species;
        }
    }
    const std::string closed = without_open_words(code_or_name);
    return closed == code_or_name ? nullptr : find_as_written(closed);
}

bool SpeciesTable::has_genus(std::string_view genus) const {
    return std::any_of(species_.begin(), species_.end(), [&](const Species& species) {
        return species.latin_name.find(' ') != std::string::npos &&
               same_word(genus_of(species.latin_name), genus);
    });
}

const Species* SpeciesTable::find_as_written(std::string_view code_or_name) const {
    const auto first = [&](auto is_meant) {
        const auto found = std::find_if(species_.begin(), species_.end(), is_meant);
        return found == species_.end() ? nullptr : &*found;
    };
    if (const Species* species = first([&](const Species& s) {
            return same_word(s.code, code_or_name) || same_word(s.latin_name, code_or_name);
        })) {
        return species;
    }
    const std::string letters = letters_of_name(code_or_name);
    if (letters.empty()) {
        return nullptr;
    }
    return first([&](const Species& s) {
        return letters_of_name(s.latin_name) == letters ||
               std::find(s.names.begin(), s.names.end(), letters) != s.names.end();
    });
}

std::string SpeciesTable::nearest(std::string_view code_or_name) const {
    constexpr std::size_t shortest_name = 4;  // short forms are near to anything
    std::vector<std::string> words;
    for (const Species& species : species_) {
        words.push_back(species.code);
        words.push_back(species.latin_name);
        std::copy_if(species.written_names.begin(), species.written_names.end(), std::back_inserter(words),
                     [](const std::string& name) { return name.size() >= shortest_name; });
    }
    if (std::string near = config::nearest_word(code_or_name, words); !near.empty()) {
        return near;
    }
    const std::vector<std::string> readings = botanical_readings(code_or_name);
    for (const std::string& reading : readings) {
        if (std::string near = config::nearest_word(reading, words); !near.empty()) {
            return near;
        }
    }
    // A species that no table knows, of a genus that they know.
    std::string of_genus;
    const std::string_view genus =
        genus_of(readings.empty() ? code_or_name : std::string_view{readings.back()});
    for (const Species& species : species_) {
        const bool is_of_it = species.latin_name.find(' ') != std::string::npos &&
                              same_word(genus_of(species.latin_name), genus);
        of_genus += is_of_it ? config::joined(of_genus.empty() ? "" : ", ", species.latin_name) : "";
    }
    return of_genus;
}

}  // namespace coupling
