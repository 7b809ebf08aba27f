#include "coupling/inputs/forest/browsing_note.hpp"

#include <cmath>
#include <map>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"
#include "forest/saplings/saplings.hpp"

namespace coupling {
namespace {

using config::joined;

/// Stems of a species whose browsing the inventory has.
struct Browsed {
    double stems = 0.0;
    double browsed = 0.0;
    double in_reach = 0.0;
};

std::map<forest::SpeciesId, Browsed> browsed_by_species(
    const std::vector<forest::OnPatches<forest::SaplingRecord>>& saplings) {
    std::map<forest::SpeciesId, Browsed> species;
    for (const auto& stand : saplings) {
        for (const forest::SaplingRecord& record : stand.records) {
            if (record.browsed_percent) {
                const double stems = record.stems_pha * static_cast<double>(stand.patches.size());
                Browsed& here = species[record.species];
                here.stems += stems;
                here.browsed += stems * *record.browsed_percent / 100.0;
                here.in_reach += stems * forest::share_in_reach(record.height_m);
            }
        }
    }
    return species;
}

std::string percent(double share) {
    return joined(config::to_text(std::round(1000.0 * share) / 10.0), " %");
}

std::string in_hundredths(double value) {
    return config::to_text(std::round(100.0 * value) / 100.0);
}

}  // namespace

void note_browsing(const std::vector<forest::OnPatches<forest::SaplingRecord>>& saplings,
                   const ForestSpecies& species, Reading& reading) {
    const double pressure = reading.forest().parameters.regeneration.browsing_pressure;
    for (const auto& [id, found] : browsed_by_species(saplings)) {
        const forest::Saplings& law = species.table[id].saplings;
        const double factor = species.browsing_factor(id);
        const double model = forest::browsing_chance(law, pressure) * found.in_reach / found.stems;
        const auto same = found.browsed < found.in_reach && pressure > 0.0
                              ? forest::pressure_of_browsing(law, found.browsed / found.in_reach)
                              : std::nullopt;
        reading.note(joined(
            "stands.saplings: the inventory found ", percent(found.browsed / found.stems), " of ",
            species.table[id].latin_name, " browsed; the model browses ", percent(model),
            " of these stems in a year at a browsing pressure of ", in_hundredths(pressure * factor),
            same ? joined("; forest.browsing_by_species = ", species.table[id].code, " ",
                          in_hundredths(*same * factor / pressure), " would give the inventory's share")
                 : std::string{"; no pressure gives the inventory's share"}));
    }
}

}  // namespace coupling
