#include "coupling/inputs/parameters/parameter_draws.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "config/math/elementary.hpp"
#include "config/random/distributions.hpp"
#include "config/random/latin_hypercube.hpp"
#include "config/random/stream.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/parameters/correlated_draws.hpp"
#include "rockfall/draws/strata.hpp"

namespace coupling {
namespace {

using config::joined;

/// The factor of the laws that a parameter is.
struct LawFactor {
    std::string_view parameter;
    double rockfall::FallFactors::*factor;
    bool of_obstacles = false;  ///< of stems and logs
};

constexpr std::array law_factors{LawFactor{"losses", &rockfall::FallFactors::losses},
                                 LawFactor{"friction", &rockfall::FallFactors::friction},
                                 LawFactor{"stopping", &rockfall::FallFactors::stopping},
                                 LawFactor{"jump_angle", &rockfall::FallFactors::jump_angle},
                                 LawFactor{"sideways", &rockfall::FallFactors::sideways},
                                 LawFactor{"block_size", &rockfall::FallFactors::block_size},
                                 LawFactor{"tree_energy", &rockfall::FallFactors::tree_energy, true}};

/// The factor of a forest that a parameter is.
struct ForestFactor {
    std::string_view parameter;
    double forest::ForestFactors::*factor;
};

constexpr std::array forest_factors{ForestFactor{"growth", &forest::ForestFactors::growth},
                                    ForestFactor{"deaths", &forest::ForestFactors::deaths},
                                    ForestFactor{"regeneration", &forest::ForestFactors::regeneration}};

/// A component and what it changes: a law of the fall, one of the forest, or the losses of one ground type.
struct Drawn {
    ParameterDraws::Component component;
    double rockfall::FallFactors::*factor = nullptr;
    std::size_t type = 0;
    double forest::ForestFactors::*of_forest = nullptr;
};

/// Of the losses on a ground: by its code, then by the shipped type that it is like, then that of any ground.
const ParameterWidth* row_of_ground(const std::vector<ParameterWidth>& widths,
                                    const rockfall::SurfaceType& type) {
    for (const std::string& name : {std::to_string(type.code), type.like}) {
        if (const ParameterWidth* own = find_width(widths, joined("losses_on.", name))) {
            return own;
        }
    }
    return find_width(widths, "losses_on");
}

/// Wider where the ground was guessed.
double own_width(const std::vector<ParameterWidth>& widths, const ParameterWidth* row) {
    const double width = row == nullptr ? 0.0 : row->width;
    const double of_guess = width_of(widths, "ground_guess");
    return std::sqrt(width * width + of_guess * of_guess);
}

/// Lets a component go with another one as its row says. What was added to the width of the row goes with
/// nothing. Where the other one is taken as known, the component scatters less. It goes with a sampled one as
/// with a drawn one; a sampled component goes with the sample.
void link(ParameterDraws::Component& component, const ParameterWidth* row,
          const ParameterKnowledge& knowledge) {
    if (row == nullptr || row->goes_with.empty() || !(component.width > 0.0) ||
        (knowledge.sample && knowledge.sample->find(component.parameter))) {
        return;
    }
    const double shared = row->correlation * row->width;  // of the width, what goes with the other one
    if (width_of(knowledge.widths, row->goes_with) > 0.0) {
        component.goes_with = row->goes_with;
        component.correlation = shared / component.width;
    } else {
        component.width = std::sqrt(component.width * component.width - shared * shared);
    }
}

/// The shipped type that a ground type is like; its code where others that occur are like that too. What lies
/// on works alone does not occur on the map: it changes no name, and so no draw of the slope.
std::string name_of(const rockfall::SurfaceType& type, const DrawnSite& site) {
    int alike = 0;
    for (std::size_t i = 0; i < site.types.size(); ++i) {
        alike += site.occurs[i] && site.types[i].like == type.like ? 1 : 0;
    }
    return type.like.empty() || alike != 1 ? std::to_string(type.code) : type.like;
}

/// Energy goes with a power of the diameter (Rammer et al. 2010, Eq. 1): where diameters are derived they
/// make it wider. Where it is taken as known (0), it stays so.
double with_stem_diameters(const std::vector<ParameterWidth>& widths, std::string_view parameter,
                           const DrawnSite& site) {
    constexpr double power_of_diameter = 2.31;
    const double width = width_of(widths, std::string{parameter});
    const double of_diameters = power_of_diameter * site.stem_diameter_width;
    return width > 0.0 ? std::sqrt(width * width + of_diameters * of_diameters) : 0.0;
}

std::vector<Drawn> drawn_parameters(const ParameterKnowledge& knowledge, const DrawnSite& site) {
    std::vector<Drawn> drawn;
    const std::vector<ParameterWidth>& widths = knowledge.widths;
    const auto is_sampled = [&](const std::string& parameter) {
        return knowledge.sample && knowledge.sample->find(parameter);
    };
    const auto add_laws = [&](bool of_obstacles) {
        for (const LawFactor& law : law_factors) {
            const double width = law.of_obstacles ? with_stem_diameters(widths, law.parameter, site)
                                                  : width_of(widths, std::string{law.parameter});
            if ((width > 0.0 || is_sampled(std::string{law.parameter})) && law.of_obstacles == of_obstacles) {
                drawn.push_back({{std::string{law.parameter}, "", width, of_obstacles}, law.factor});
                link(drawn.back().component, find_width(widths, std::string{law.parameter}), knowledge);
            }
        }
    };
    add_laws(false);
    for (std::size_t i = 0; i < site.types.size(); ++i) {
        const rockfall::SurfaceType& type = site.types[i];
        const ParameterWidth* row = row_of_ground(widths, type);
        const double width = own_width(widths, row);
        const std::string parameter = joined("losses_on.", name_of(type, site));
        if (site.occurs[i] && (width > 0.0 || is_sampled(parameter))) {
            drawn.push_back({{parameter, type.label, width}, nullptr, i});
            link(drawn.back().component, row, knowledge);
        }
    }
    // Last, so that all else is the same without a forest.
    if (site.has_obstacles) {
        add_laws(true);
    }
    if (site.grows) {
        for (const ForestFactor& law : forest_factors) {
            const double width = width_of(widths, std::string{law.parameter});
            if (width > 0.0) {
                drawn.push_back({{std::string{law.parameter}, "", width, true}, nullptr, 0, law.factor});
                link(drawn.back().component, find_width(widths, std::string{law.parameter}), knowledge);
            }
        }
    }
    return drawn;
}

/// 48 bits of a name (FNV-1a), so that a parameter keeps its numbers whatever else is drawn.
std::uint64_t id_of(std::string_view name) {
    const std::uint64_t hash = fnv1a(name);
    return (hash ^ (hash >> 48)) & 0xFFFF'FFFF'FFFFULL;
}

/// The number by which the sets of a joint sample are drawn.
constexpr std::string_view id_of_sample = "joint sample";

/// Components, and for each stratum the factors and laws that uniform numbers [0, 1) lead to.
class FactorDraws {
public:
    FactorDraws(const ParameterKnowledge& knowledge, const DrawnSite& site, const rockfall::FallLaw& law)
        : knowledge_{knowledge}, site_{site}, law_{law}, drawn_{drawn_parameters(knowledge, site)} {
        for (const Drawn& one : drawn_) {
            draws_.components.push_back(one.component);
            ids_.push_back(id_of(one.component.parameter));
        }
        if (knowledge.sample) {
            ids_.push_back(id_of(id_of_sample));
        }
    }

    /// Of each component, then, with a joint sample, of the sample.
    [[nodiscard]] const std::vector<std::uint64_t>& ids() const { return ids_; }
    [[nodiscard]] const std::vector<Drawn>& drawn() const { return drawn_; }

    /// Factors that uniform numbers, one for each of `ids`, stand for.
    [[nodiscard]] std::vector<double> factors_of(const std::vector<double>& uniforms) const {
        static const config::TruncatedNormal within_cut_off{most_deviations};
        const std::vector<double>* set = nullptr;
        if (knowledge_.sample) {
            set = &knowledge_.sample->factors[knowledge_.sample->set_at(uniforms.back())];
        }
        std::vector<double> numbers;
        for (std::size_t i = 0; i < drawn_.size(); ++i) {
            const double width = drawn_[i].component.width;
            const std::optional<double> factor = sampled(set, i);
            numbers.push_back(!factor       ? within_cut_off(uniforms[i])
                              : width > 0.0 ? config::ln_of(*factor) / width
                                            : 0.0);
        }
        numbers = correlated(draws_.components, std::move(numbers));
        std::vector<double> factors;
        for (std::size_t i = 0; i < drawn_.size(); ++i) {
            factors.push_back(
                sampled(set, i).value_or(config::exp_of(drawn_[i].component.width * numbers[i])));
        }
        return factors;
    }

    /// `all_factors`: by stratum, by component.
    ParameterDraws with(std::vector<std::vector<double>> all_factors) && {
        for (const std::vector<double>& of_stratum : all_factors) {
            rockfall::FallFactors factors;
            forest::ForestFactors of_forest;
            std::vector<double> own_losses(site_.types.size(), 1.0);
            for (std::size_t i = 0; i < drawn_.size(); ++i) {
                const Drawn& one = drawn_[i];
                (one.factor != nullptr      ? factors.*one.factor
                 : one.of_forest != nullptr ? of_forest.*one.of_forest
                                            : own_losses[one.type]) = of_stratum[i];
            }
            draws_.falls.push_back(rockfall::draw_of(law_, site_.types, factors, own_losses));
            draws_.forests.push_back(of_forest);
        }
        draws_.factors = std::move(all_factors);
        return std::move(draws_);
    }

private:
    /// By the set of the joint sample, where it has this component.
    [[nodiscard]] std::optional<double> sampled(const std::vector<double>* set, std::size_t i) const {
        if (set == nullptr) {
            return std::nullopt;
        }
        const auto column = knowledge_.sample->find(drawn_[i].component.parameter);
        return column ? std::optional{(*set)[*column]} : std::nullopt;
    }

    const ParameterKnowledge& knowledge_;
    const DrawnSite& site_;
    const rockfall::FallLaw& law_;
    std::vector<Drawn> drawn_;
    std::vector<std::uint64_t> ids_;
    ParameterDraws draws_;
};

/// Where the component is that this one goes with.
std::size_t place_of_partner(std::span<const ParameterDraws::Component> components, std::size_t i) {
    const auto other = std::find_if(components.begin(), components.end(), [&](const auto& one) {
        return one.parameter == components[i].goes_with;
    });
    assert(other != components.end() && other->goes_with.empty());
    return static_cast<std::size_t>(other - components.begin());
}

}  // namespace

ParameterDraws draw_parameters(const ParameterKnowledge& knowledge, const DrawnSite& site,
                               const rockfall::FallLaw& law, std::uint64_t seed, std::uint64_t rocks) {
    FactorDraws drawing{knowledge, site, law};
    if (drawing.drawn().empty() || rocks == 0) {
        return {};
    }
    std::vector<std::vector<double>> factors = config::latin_hypercube(
        {.seed = seed}, config::Purpose::parameter, drawing.ids(), rockfall::strata_for(rocks));
    for (std::vector<double>& of_stratum : factors) {
        of_stratum = drawing.factors_of(of_stratum);
    }
    return std::move(drawing).with(std::move(factors));
}

ParameterDraws draw_of_replicate(const ParameterKnowledge& knowledge, const DrawnSite& site,
                                 const rockfall::FallLaw& law, std::uint64_t seed, std::uint32_t replicate) {
    if (replicate == 0) {
        return central_draw(knowledge, site, law);
    }
    FactorDraws drawing{knowledge, site, law};
    if (drawing.drawn().empty()) {
        return {};
    }
    std::vector<double> uniforms;
    for (const std::uint64_t id : drawing.ids()) {
        // Strata have the numbers of replicate 0.
        uniforms.push_back(
            config::RandomStream{{seed, replicate, 0, id}, config::Purpose::parameter}.uniform());
    }
    std::vector<double> factors = drawing.factors_of(uniforms);
    return std::move(drawing).with({std::move(factors)});
}

ParameterDraws central_draw(const ParameterKnowledge& knowledge, const DrawnSite& site,
                            const rockfall::FallLaw& law) {
    if (!knowledge.sample) {
        return {};
    }
    FactorDraws drawing{knowledge, site, law};
    const std::vector<double> centre = knowledge.sample->centre();
    std::vector<double> factors;
    for (const Drawn& one : drawing.drawn()) {
        const auto sampled = knowledge.sample->find(one.component.parameter);
        factors.push_back(sampled ? centre[*sampled] : 1.0);
    }
    return std::move(drawing).with({std::move(factors)});
}

std::vector<double> correlated(std::span<const ParameterDraws::Component> components,
                               std::vector<double> independent) {
    assert(components.size() == independent.size());
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (components[i].goes_with.empty()) {
            continue;
        }
        const double shared = components[i].correlation;
        const double of_other = independent[place_of_partner(components, i)];
        independent[i] = std::clamp(shared * of_other + std::sqrt(1.0 - shared * shared) * independent[i],
                                    -most_deviations, most_deviations);
    }
    return independent;
}

std::vector<double> independent_of(std::span<const ParameterDraws::Component> components,
                                   const std::vector<double>& numbers) {
    std::vector<double> independent = numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (!components[i].goes_with.empty()) {
            const double shared = components[i].correlation;
            const double of_other = numbers[place_of_partner(components, i)];
            independent[i] = (numbers[i] - shared * of_other) / std::sqrt(1.0 - shared * shared);
        }
    }
    return independent;
}

ParameterDraws draw_of_sets(const ParameterKnowledge& knowledge, const DrawnSite& site,
                            const rockfall::FallLaw& law, std::vector<std::vector<double>> factors) {
    return FactorDraws{knowledge, site, law}.with(std::move(factors));
}

std::vector<ParameterDraws::Component> components_on(const ParameterKnowledge& knowledge,
                                                     const DrawnSite& site) {
    std::vector<ParameterDraws::Component> components;
    for (const Drawn& one : drawn_parameters(knowledge, site)) {
        components.push_back(one.component);
    }
    return components;
}

}  // namespace coupling
