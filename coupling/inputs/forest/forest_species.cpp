#include "coupling/inputs/forest/forest_species.hpp"

#include <sstream>

#include "config/text/joined.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"
#include "forest/saplings/saplings.hpp"

namespace coupling {
namespace {

using config::ExitCode;
using config::joined;

/// The species that a name stands for, in any language; null for none.
const Species* species_named(const std::string& name) {
    static const SpeciesTable known = SpeciesTable::shipped();
    return known.find(name);
}

ForestSpecies read_table(Reading& reading) {
    const std::string& file = reading.forest().species;
    ForestSpecies species{file.empty()
                              ? forest::SpeciesTable::shipped()
                              : forest::SpeciesTable::read(reading.table("forest.species", "species", file)),
                          {},
                          {}};
    if (reading.forest().rockfall_every == 0) {
        return species;
    }
    const SpeciesTable known = SpeciesTable::shipped();
    config::Problems problems;
    for (const forest::Species& kind : species.table.all()) {
        const Species* strength = known.find(kind.code);
        if (strength == nullptr) {
            problems.add(
                ExitCode::data, {reading.shown(file)},
                joined("species ", config::in_quotes(kind.code), " without a known strength against rocks"),
                "codes of `bannwald info species`, or run.rockfall_every = 0");
        } else {
            species.fracture_energy.push_back(strength->fracture_energy);
        }
    }
    problems.throw_if_any();
    return species;
}

/// "ABAL 1.5": a species by code or Latin name, and its factor; refuses anything else.
void add_browsing(const std::string& text, ForestSpecies& species, Reading& reading) {
    constexpr double most = 100.0;
    const auto refuse = [&](const std::string& expected) {
        reading.problems().add(ExitCode::settings,
                               reading.settings().options->place_of("forest.browsing_by_species"),
                               joined("forest.browsing_by_species ", config::in_quotes(text)), expected);
    };
    const std::size_t blank = text.find_last_of(" \t");
    const std::string name{config::trimmed(text.substr(0, blank))};
    const auto factor =
        blank == std::string::npos ? std::nullopt : config::parse_number(text.substr(blank + 1));
    const SpeciesLookup lookup = species.lookup();
    const auto place = lookup.find(name);
    if (!factor || *factor < 0.0 || *factor > most) {
        refuse("a species and its factor from 0 to 100, such as ABAL 1.5, and commas between them");
    } else if (!place) {
        refuse(lookup.expected(name));
    } else if (const forest::SpeciesId id{static_cast<std::uint16_t>(*place)};
               !species.browsing.emplace(id, *factor).second) {
        refuse("each species once");
    }
}

/// Browsing of the species of forest.browsing_by_species: at pressure 1 as the others at their factor.
void read_browsing(ForestSpecies& species, Reading& reading) {
    const std::string& text = reading.forest().browsing_by_species;
    if (text.empty()) {
        return;
    }
    std::istringstream items{text};
    for (std::string item; std::getline(items, item, ',');) {
        add_browsing(std::string{config::trimmed(item)}, species, reading);
    }
    for (const auto& [id, factor] : species.browsing) {
        forest::Species changed = species.table[id];
        changed.saplings.browsing_probability = forest::browsing_chance(changed.saplings, factor);
        species.table.replace(id, std::move(changed));
    }
}

}  // namespace

SpeciesLookup ForestSpecies::lookup() const {
    const auto place = [this](const std::string& name) -> std::optional<std::size_t> {
        auto id = table.find(name);
        const Species* species = id ? nullptr : species_named(name);
        if (species != nullptr) {
            id = table.find(species->code);
            id = id ? id : table.find(species->stand_in);
        }
        return id ? std::optional{forest::index_of(*id)} : std::nullopt;
    };
    const auto nearest = [this](const std::string& name) {
        std::vector<std::string> words;
        for (const forest::Species& kind : table.all()) {
            words.push_back(kind.code);
            words.push_back(kind.latin_name);
        }
        const std::string word = config::nearest_word(name, words);
        return word.empty() ? SpeciesTable::shipped().nearest(name) : word;
    };
    std::string codes;
    for (const forest::Species& kind : table.all()) {
        codes += joined(codes.empty() ? "" : ", ", kind.code);
    }
    return {place, nearest, codes, [this](std::size_t at) { return table.all()[at].conifer; }};
}

std::optional<ForestSpecies> read_forest_species(Reading& reading) {
    return reading.attempt([&] {
        ForestSpecies species = read_table(reading);
        read_browsing(species, reading);
        return species;
    });
}

std::optional<forest::Parameters> read_forest_parameters(const ForestSpecies& species, Reading& reading) {
    const ForestSettings& s = reading.forest();
    forest::Parameters parameters = s.parameters;
    const SpeciesLookup lookup = species.lookup();
    std::string text = s.region_species;
    for (char& letter : text) {
        letter = letter == ';' || letter == ' ' || letter == '\t' ? ',' : letter;
    }
    std::istringstream words{text};
    bool is_complete = true;
    for (std::string word; std::getline(words, word, ',');) {
        if (word.empty()) {
            continue;
        }
        if (const auto place = lookup.find(word)) {
            parameters.regeneration.outside.species.push_back(
                forest::SpeciesId{static_cast<std::uint16_t>(*place)});
        } else {
            is_complete = false;
            reading.problems().add(ExitCode::settings,
                                   reading.settings().options->place_of("forest.region_species"),
                                   joined("species ", config::in_quotes(word)), lookup.expected(word));
        }
    }
    return is_complete ? std::optional{std::move(parameters)} : std::nullopt;
}

void warn_of_stand_ins(const SpeciesColumn& column, const ForestSpecies& species, const std::string& file,
                       Reading& reading) {
    const SpeciesLookup lookup = species.lookup();
    for (const auto& [name, count] : column.counts_by_name()) {
        const Species* named = species_named(name);
        if (!species.table.find(name) && (named == nullptr || !species.table.find(named->code))) {
            const std::size_t place = *lookup.find(name);
            reading.note(joined(file, ": ", counted(count, "row"), " of ", name, " grow as ",
                                species.table.all()[place].latin_name, ", which stands in for it"));
        }
    }
}

}  // namespace coupling
