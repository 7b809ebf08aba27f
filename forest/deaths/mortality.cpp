#include "forest/deaths/mortality.hpp"

#include <algorithm>
#include <cassert>

#include "config/math/elementary.hpp"
#include "config/random/stream.hpp"

namespace forest {

double background_death(const Species& species, double dbh_cm, double age_years, const CanopyPlace& place,
                        const MortalityLaw& law, bool storms) {
    if (law.age == AgeLaw::gap_model) {
        return 1.0 - config::pow_of(species.mortality.lucky_share, 1.0 / species.mortality.max_age_years);
    }
    return canopy_death(species, dbh_cm, age_years, place, law.canopy, storms);
}

double stress_death(const Light& species, const MortalityLaw& law) {
    return std::min(1.0, law.stress_death + law.stress_death_by_class * (species.response_class - 1.0));
}

std::vector<std::uint16_t> stress_years_after(const Stand& stand, const SpeciesTable& species,
                                              const MortalityLaw& law,
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
        const double least_share =
            law.least_relative_growth +
            law.least_relative_growth_by_class * (species[trees[i].species].light.response_class - 1.0);
        const bool bad =
            growth_cm < law.least_growth_cm || growth_cm < least_share * sum.growth_cm / sum.stems;
        constexpr int most = 60'000;
        years[i] =
            bad ? static_cast<std::uint16_t>(std::min(trees[i].stress_years + 1, most)) : std::uint16_t{0};
    }
    return years;
}

std::vector<Removal> natural_deaths(const Stand& stand, const SpeciesTable& species, const MortalityLaw& law,
                                    bool storms, std::span<const CanopyPlace> places,
                                    std::span<const double> of_drought, std::uint64_t seed,
                                    std::uint32_t replicate) {
    assert(of_drought.empty() || of_drought.size() == stand.trees().size());
    assert(places.empty() || places.size() == stand.trees().size());
    std::vector<Removal> deaths;
    std::vector<std::size_t> thick_dead;
    for (std::size_t i = 0; i < stand.trees().size(); ++i) {
        const Tree& tree = stand.trees()[i];
        const Species& kind = species[tree.species];
        const double of_age =
            law.background
                ? law.all * background_death(kind, tree.dbh_cm, tree.age_years,
                                             places.empty() ? CanopyPlace{} : places[i], law, storms)
                : 0.0;
        const double of_stress =
            law.stress
                ? law.all * ((tree.stress_years >= law.bad_years ? stress_death(kind.light, law) : 0.0) +
                             suppression_death(kind.light, tree.dbh_cm, tree.light_ratio, law.suppression))
                : 0.0;
        config::RandomStream stream{
            {seed, replicate, static_cast<std::uint16_t>(stand.year()), number_of(tree.id)},
            config::Purpose::tree_death};
        std::uint32_t die_of_age = 0;
        std::uint32_t die_of_stress = 0;
        std::uint32_t die_of_drought = 0;
        const double dry = of_drought.empty() ? 0.0 : of_drought[i];
        for (std::uint32_t stem = 0; stem < tree.stems; ++stem) {
            const double u = stream.uniform();
            die_of_age += u < of_age ? 1 : 0;
            die_of_stress += u >= of_age && u < of_age + of_stress ? 1 : 0;
            die_of_drought += u >= of_age + of_stress && u < of_age + of_stress + dry ? 1 : 0;
        }
        if (die_of_age > 0) {
            deaths.push_back({tree.id, Cause::background, die_of_age});
            if (tree.dbh_cm > falls_with_others_cm) {
                thick_dead.push_back(i);
            }
        }
        if (die_of_stress > 0) {
            deaths.push_back({tree.id, Cause::stress, die_of_stress});
        }
        if (die_of_drought > 0) {
            deaths.push_back({tree.id, Cause::drought, die_of_drought});
        }
    }
    const std::vector<Removal> taken = taken_along(stand, thick_dead, seed, replicate);
    deaths.insert(deaths.end(), taken.begin(), taken.end());
    return deaths;
}

}  // namespace forest
