#include "coupling/inputs/parameters/parameter_draws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "config/math/elementary.hpp"
#include "config/random/distributions.hpp"
#include "config/random/latin_hypercube.hpp"
#include "config/random/stream.hpp"
#include "config/text/joined.hpp"
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
                                 LawFactor{"tree_energy", &rockfall::FallFactors::tree_energy, true}};

/// A component and what it changes: a law, or the losses of one ground type.
struct Drawn {
    ParameterDraws::Component component;
    double rockfall::FallFactors::*factor = nullptr;
    std::size_t type = 0;
};

/// By its code, then by the shipped type that it is like, then that of any ground; more where it was guessed.
double own_width(const std::vector<ParameterWidth>& widths, const rockfall::SurfaceType& type) {
    const auto named = [&](const std::string& name) {
        return std::find_if(widths.begin(), widths.end(), [&](const ParameterWidth& one) {
            return one.parameter == joined("losses_on.", name);
        });
    };
    auto own = named(std::to_string(type.code));
    if (own == widths.end()) {
        own = named(type.like);
    }
    const double width = own == widths.end() ? width_of(widths, "losses_on") : own->width;
    const double of_guess = width_of(widths, "ground_guess");
    return std::sqrt(width * width + of_guess * of_guess);
}

/// The shipped type that a ground type is like; its code where others are like that too.
std::string name_of(const rockfall::SurfaceType& type, const std::vector<rockfall::SurfaceType>& types) {
    const bool is_one = std::count_if(types.begin(), types.end(), [&](const rockfall::SurfaceType& other) {
                            return other.like == type.like;
                        }) == 1;
    return type.like.empty() || !is_one ? std::to_string(type.code) : type.like;
}

std::vector<Drawn> drawn_parameters(const std::vector<ParameterWidth>& widths, const DrawnSite& site) {
    std::vector<Drawn> drawn;
    const auto add_laws = [&](bool of_obstacles) {
        for (const LawFactor& law : law_factors) {
            const double width = width_of(widths, std::string{law.parameter});
            if (width > 0.0 && law.of_obstacles == of_obstacles) {
                drawn.push_back({{std::string{law.parameter}, "", width, of_obstacles}, law.factor});
            }
        }
    };
    add_laws(false);
    for (std::size_t i = 0; i < site.types.size(); ++i) {
        const rockfall::SurfaceType& type = site.types[i];
        const double width = own_width(widths, type);
        if (site.occurs[i] && width > 0.0) {
            drawn.push_back(
                {{joined("losses_on.", name_of(type, site.types)), type.label, width}, nullptr, i});
        }
    }
    // Last, so that all else is the same without a forest.
    if (site.has_obstacles) {
        add_laws(true);
    }
    return drawn;
}

/// 48 bits of a name (FNV-1a), so that a parameter keeps its numbers whatever else is drawn.
std::uint64_t id_of(std::string_view name) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char letter : name) {
        hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211ULL;
    }
    return (hash ^ (hash >> 48)) & 0xFFFF'FFFF'FFFFULL;
}

/// Components, and for each stratum the factors and laws that uniform numbers [0, 1) of components lead to.
class Drawing {
public:
    Drawing(const std::vector<ParameterWidth>& widths, const DrawnSite& site, const rockfall::FallLaw& law)
        : site_{site}, law_{law}, drawn_{drawn_parameters(widths, site)} {
        for (const Drawn& one : drawn_) {
            draws_.components.push_back(one.component);
            ids_.push_back(id_of(one.component.parameter));
        }
    }

    [[nodiscard]] const std::vector<std::uint64_t>& ids() const { return ids_; }

    ParameterDraws with(std::vector<std::vector<double>> uniforms) && {
        static const config::TruncatedNormal within_three_deviations{3.0};
        for (std::vector<double>& of_stratum : uniforms) {
            rockfall::FallFactors factors;
            std::vector<double> own_losses(site_.types.size(), 1.0);
            for (std::size_t i = 0; i < drawn_.size(); ++i) {
                of_stratum[i] =
                    config::exp_of(drawn_[i].component.width * within_three_deviations(of_stratum[i]));
                (drawn_[i].factor != nullptr ? factors.*drawn_[i].factor : own_losses[drawn_[i].type]) =
                    of_stratum[i];
            }
            draws_.falls.push_back(rockfall::draw_of(law_, site_.types, factors, own_losses));
        }
        draws_.factors = std::move(uniforms);
        return std::move(draws_);
    }

private:
    const DrawnSite& site_;
    const rockfall::FallLaw& law_;
    std::vector<Drawn> drawn_;
    std::vector<std::uint64_t> ids_;
    ParameterDraws draws_;
};

}  // namespace

ParameterDraws draw_parameters(const std::vector<ParameterWidth>& widths, const DrawnSite& site,
                               const rockfall::FallLaw& law, std::uint64_t seed, std::uint64_t rocks) {
    Drawing drawing{widths, site, law};
    if (drawing.ids().empty() || rocks == 0) {
        return {};
    }
    const std::vector<std::uint64_t> ids = drawing.ids();
    return std::move(drawing).with(config::latin_hypercube({.seed = seed}, config::Purpose::parameter, ids,
                                                           rockfall::strata_for(rocks)));
}

ParameterDraws draw_of_replicate(const std::vector<ParameterWidth>& widths, const DrawnSite& site,
                                 const rockfall::FallLaw& law, std::uint64_t seed, std::uint32_t replicate) {
    Drawing drawing{widths, site, law};
    if (drawing.ids().empty() || replicate == 0) {
        return {};
    }
    std::vector<double> uniforms;
    for (const std::uint64_t id : drawing.ids()) {
        // Strata have the numbers of replicate 0.
        uniforms.push_back(
            config::RandomStream{{seed, replicate, 0, id}, config::Purpose::parameter}.uniform());
    }
    return std::move(drawing).with({std::move(uniforms)});
}

}  // namespace coupling
