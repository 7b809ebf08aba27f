#include "coupling/inputs/species_table.hpp"

#include <algorithm>
#include <array>
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

std::string letters_of_name(std::string_view name) {
    struct Letter {
        std::string_view written;
        std::string_view plain;
    };
    constexpr std::array letters{Letter{"ä", "ae"}, Letter{"Ä", "ae"}, Letter{"ö", "oe"}, Letter{"Ö", "oe"},
                                 Letter{"ü", "ue"}, Letter{"Ü", "ue"}, Letter{"ß", "ss"}, Letter{"é", "e"},
                                 Letter{"É", "e"},  Letter{"è", "e"},  Letter{"È", "e"},  Letter{"ê", "e"},
                                 Letter{"Ê", "e"},  Letter{"à", "a"},  Letter{"â", "a"},  Letter{"ç", "c"},
                                 Letter{"î", "i"},  Letter{"ï", "i"},  Letter{"ô", "o"},  Letter{"ò", "o"},
                                 Letter{"ù", "u"},  Letter{"û", "u"},  Letter{"œ", "oe"}, Letter{"’", ""}};
    std::string result;
    while (!name.empty()) {
        const auto found = std::find_if(letters.begin(), letters.end(), [&](const Letter& letter) {
            return name.starts_with(letter.written);
        });
        if (found != letters.end()) {
            result += found->plain;
            name.remove_prefix(found->written.size());
            continue;
        }
        const auto byte = static_cast<unsigned char>(name.front());
        constexpr std::string_view passed_over = " \t.-_'";
        if (passed_over.find(name.front()) == std::string_view::npos) {
            result += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
        }
        name.remove_prefix(1);
    }
    return result;
}

SpeciesTable SpeciesTable::shipped() {
    config::Problems problems;
    SpeciesTable result;
    const config::Table resistance = shipped_table("tree_resistance.csv");
    for (std::size_t row = 0; row < resistance.rows(); ++row) {
        const auto energy =
            resistance.number(row, "fracture_energy", {.low = 0.0, .low_excluded = true}, problems);
        result.species_.push_back(
            {resistance.text(row, "code"), resistance.text(row, "latin_name"), energy.value_or(0.0), "", {}});
    }
    const config::Table names = shipped_table("species_names.csv");
    for (std::size_t row = 0; row < names.rows(); ++row) {
        for (Species& species : result.species_) {
            if (species.code != names.text(row, "code")) {
                continue;
            }
            for (const char* column : {"german", "french", "italian", "english", "short"}) {
                std::istringstream words{names.text(row, column)};
                for (std::string word; std::getline(words, word, '/');) {
                    species.names.push_back(letters_of_name(word));
                }
            }
        }
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

const Species* SpeciesTable::find(std::string_view code_or_name) const {
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

std::string SpeciesTable::nearest(std::string_view code_or_latin_name) const {
    std::vector<std::string> words;
    for (const Species& species : species_) {
        words.push_back(species.code);
        words.push_back(species.latin_name);
    }
    return config::nearest_word(code_or_latin_name, words);
}

}  // namespace coupling
