#include "coupling/inputs/forest/species_table.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <sstream>

#include "config/data/shipped_tables.hpp"
#include "config/table/table.hpp"
#include "config/text/plain_letters.hpp"
#include "config/text/reading.hpp"
#include "config/text/words_of_list.hpp"

namespace coupling {

namespace {

bool same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// Without the words by which botanists leave a name open: "Quercus sp." is "Quercus".
std::string without_open_names(std::string_view name) {
    constexpr std::array<std::string_view, 6> open{"sp", "spp", "cf", "aff", "spec", "indet"};
    std::string kept;
    for (const std::string& word : config::words_between_blanks(name)) {
        std::string plain = config::in_lower_case(word);
        std::erase(plain, '.');
        if (kept.empty() || std::find(open.begin(), open.end(), plain) == open.end()) {
            kept += (kept.empty() ? "" : " ") + word;
        }
    }
    return kept;
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
    const std::string plain = without_open_names(code_or_name);
    return plain == code_or_name ? nullptr : find_as_written(plain);
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
    if (const Species* species = first([&](const Species& s) {
            return std::find(s.names.begin(), s.names.end(), letters) != s.names.end();
        })) {
        return species;
    }
    // "Picea abies (L.) H. Karst."
    return first([&](const Species& s) {
        return s.latin_name.find(' ') != std::string::npos && code_or_name.size() > s.latin_name.size() &&
               code_or_name[s.latin_name.size()] == ' ' &&
               same_word(s.latin_name, code_or_name.substr(0, s.latin_name.size()));
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
    const std::string plain = without_open_names(code_or_name);
    if (std::string near = config::nearest_word(plain, words); !near.empty()) {
        return near;
    }
    // Without the author: "Pseudtsuga menziesii (Mirb.) Franco".
    const std::size_t genus_end = plain.find(' ');
    const std::size_t end = genus_end == std::string::npos ? genus_end : plain.find(' ', genus_end + 1);
    return end == std::string::npos ? "" : config::nearest_word(plain.substr(0, end), words);
}

}  // namespace coupling
