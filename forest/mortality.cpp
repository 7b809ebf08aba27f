#include "forest/mortality.hpp"

#include <algorithm>
#include <cassert>

#include "config/math/elementary.hpp"
#include "config/random/stream.hpp"

namespace forest {

double background_death(const Mortality& species, double age_years, AgeLaw law) {
    if (law == AgeLaw::gap_model) {
        return 1.0 - config::pow_of(species.lucky_share, 1.0 / species.max_age_years);
    }
    constexpr double without_cause = 0.0015;
    constexpr double old_age = 0.75;  // of the greatest age
    const double scale_years = old_age * species.max_age_years;
    const double share = age_years / scale_years;
    return std::min(1.0, without_cause + 4.0 / scale_years * share * share * share);
}

double stress_death(const Light& species, const MortalityLaw& law) {
    return std::min(1.0, law.stress_death + law.stress_death_by_class * (species.response_class - 1.0));
}

std::vector<std::uint16_t> stress_years_after(const Stand& stand, const MortalityLaw& law,
                                              std::span<const std::uint32_t> production_unit,
                                              std::size_t units) {
    struct Sum {
        double stems = 0.0;
        double growth_cm = 0.0;
    };
    const std::span<const Tree> trees = stand.trees();
    assert(production_unit.size() == trees.size());
    std::vector<Sum> sums(units * stand.species_count());
    const auto place_of = [&](std::size_t i) {
        return production_unit[i] * stand.species_count() + index_of(trees[i].species);
    };
    for (std::size_t i = 0; i < trees.size(); ++i) {
        Sum& sum = sums[place_of(i)];
        sum.stems += trees[i].stems;
        sum.growth_cm += trees[i].stems * trees[i].increments_cm[0];
    }

    std::vector<std::uint16_t> years(trees.size());
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const Sum& sum = sums[place_of(i)];
        const double growth_cm = trees[i].increments_cm[0];
        const bool bad = growth_cm < law.least_growth_cm ||
                         growth_cm < law.least_relative_growth * sum.growth_cm / sum.stems;
        constexpr int most = 60'000;
        years[i] =
            bad ? static_cast<std::uint16_t>(std::min(trees[i].stress_years + 1, most)) : std::uint16_t{0};
    }
    return years;
}

std::vector<Removal> natural_deaths(const Stand& stand, const SpeciesTable& species, const MortalityLaw& law,
                                    std::uint64_t seed, std::uint32_t replicate) {
    std::vector<Removal> deaths;
    for (const Tree& tree : stand.trees()) {
        const Species& kind = species[tree.species];
        const double of_age =
            law.background ? background_death(kind.mortality, tree.age_years, law.age) : 0.0;
        const double of_stress =
            law.stress && tree.stress_years >= law.bad_years ? stress_death(kind.light, law) : 0.0;
        config::RandomStream stream{
            {seed, replicate, static_cast<std::uint16_t>(stand.year()), number_of(tree.id)},
            config::Purpose::tree_death};
        std::uint32_t die_of_age = 0;
        std::uint32_t die_of_stress = 0;
        for (std::uint32_t stem = 0; stem < tree.stems; ++stem) {
            const double u = stream.uniform();
            die_of_age += u < of_age ? 1 : 0;
            die_of_stress += u >= of_age && u < of_age + of_stress ? 1 : 0;
        }
        if (die_of_age > 0) {
            deaths.push_back({tree.id, Cause::background, die_of_age});
        }
        if (die_of_stress > 0) {
            deaths.push_back({tree.id, Cause::stress, die_of_stress});
        }
    }
    return deaths;
}

}  // namespace forest
