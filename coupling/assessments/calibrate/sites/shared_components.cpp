#include "coupling/assessments/calibrate/sites/shared_components.hpp"

#include <algorithm>
#include <map>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::calibrate {
namespace {

using config::joined;

/// By what a component is the same at several sites; "" where it belongs to one.
std::string key_of(const ParameterDraws::Component& component, const SiteParameters& site) {
    if (!component.ground.empty()) {
        return site.ground_is_guessed ? "" : joined("ground ", component.ground);
    }
    return component.parameter == "block_size" ? "" : component.parameter;
}

/// Grounds of one name are one ground.
void compare_grounds(std::span<const SiteParameters> sites) {
    struct Found {
        const SiteParameters* site;
        const rockfall::SurfaceType* type;
    };
    std::map<std::string, Found> first;
    for (const SiteParameters& site : sites) {
        std::map<std::string, int> codes;
        for (std::size_t i = 0; i < site.types->size(); ++i) {
            const rockfall::SurfaceType& type = (*site.types)[i];
            if (!site.occurs[i]) {
                continue;
            }
            if (const auto [code, is_new] = codes.emplace(type.label, type.code); !is_new) {
                config::fail(
                    config::ExitCode::data, {site.scenario},
                    joined("ground types ", std::to_string(code->second), " and ", std::to_string(type.code),
                           " with one name: ", config::in_quotes(type.label)),
                    "a name for each: sites share grounds by their names", "change a label");
            }
            const auto [found, is_first] = first.emplace(type.label, Found{&site, &type});
            if (is_first) {
                continue;
            }
            if (const std::string difference = difference_of(*found->second.type, type);
                !difference.empty()) {
                config::fail(config::ExitCode::data, {site.scenario},
                             joined("ground type ", config::in_quotes(type.label), " with other values than ",
                                    found->second.site->scenario, " has for it: ", difference),
                             "one ground by one name: sites share grounds by their names",
                             "give both the same values, or one of them another label");
            }
        }
    }
}

/// Both sites know the same of what they share.
void compare_widths(const ParameterDraws::Component& one, const ParameterDraws::Component& other,
                    const SiteParameters& first, const SiteParameters& second) {
    const auto in_words = [](const ParameterDraws::Component& component) {
        return joined(config::to_text(component.width),
                      component.goes_with.empty() ? ""
                                                  : joined(" (", config::to_text(component.correlation),
                                                           " with ", component.goes_with, ")"));
    };
    const bool is_same =
        one.width == other.width && one.goes_with == other.goes_with && one.correlation == other.correlation;
    if (!is_same) {
        config::fail(config::ExitCode::settings, {second.scenario},
                     joined("a width of ", in_words(other), " for ", other.parameter, ", but ", in_words(one),
                            " in ", first.scenario),
                     "the same width at all sites: they share what is fitted",
                     "name the same table in run.parameters of all of them, or of none");
    }
}

}  // namespace

SharedComponents share(std::span<const SiteParameters> sites) {
    SharedComponents shared;
    if (sites.size() > 1) {
        compare_grounds(sites);
    }
    // Diameters of stems may be derived at one site alone: then its trees are known less.
    bool shares_trees = true;
    for (const SiteParameters& site : sites) {
        for (const SiteParameters& other : sites) {
            for (const ParameterDraws::Component& one : site.components) {
                for (const ParameterDraws::Component& two : other.components) {
                    shares_trees =
                        shares_trees &&
                        !(one.parameter == "tree_energy" && two.parameter == "tree_energy" &&
                          site.tree_energy_width == other.tree_energy_width && one.width != two.width);
                }
            }
        }
    }
    std::map<std::string, std::size_t> place_of_key;
    for (std::size_t s = 0; s < sites.size(); ++s) {
        const SiteParameters& site = sites[s];
        std::vector<std::size_t>& places = shared.places.emplace_back();
        std::vector<std::size_t> going_with_others;
        for (const ParameterDraws::Component& component : site.components) {
            const std::string key = component.parameter == "tree_energy" && !shares_trees
                                        ? std::string{}
                                        : key_of(component, site);
            const auto known = key.empty() ? place_of_key.end() : place_of_key.find(key);
            if (known != place_of_key.end()) {
                const std::size_t place = known->second;
                const SiteParameters& first = sites[shared.users[place].front()];
                compare_widths(shared.components[place], component, first, site);
                shared.users[place].push_back(s);
                places.push_back(place);
                continue;
            }
            ParameterDraws::Component own = component;
            const bool is_taken = shared.find(own.parameter) < shared.components.size();
            if (sites.size() > 1 && (key.empty() || is_taken)) {
                own.parameter += joined(":", site.name);
            }
            const std::size_t place = shared.components.size();
            if (!own.goes_with.empty()) {
                going_with_others.push_back(place);
            }
            if (!key.empty()) {
                place_of_key.emplace(key, place);
            }
            shared.components.push_back(std::move(own));
            shared.users.push_back({s});
            places.push_back(place);
        }
        // Names of partners, which may stand before or behind what goes with them.
        for (const std::size_t place : going_with_others) {
            std::string& name = shared.components[place].goes_with;
            const auto partner =
                std::find_if(site.components.begin(), site.components.end(),
                             [&](const ParameterDraws::Component& each) { return each.parameter == name; });
            if (partner != site.components.end()) {
                name = shared.components[places[static_cast<std::size_t>(partner - site.components.begin())]]
                           .parameter;
            }
        }
    }
    return shared;
}

SharedComponents SharedComponents::of(std::span<const std::size_t> sites) const {
    SharedComponents some;
    std::vector<std::size_t> new_place(components.size(), components.size());
    for (std::size_t i = 0; i < components.size(); ++i) {
        std::vector<std::size_t> of_component;
        for (std::size_t s = 0; s < sites.size(); ++s) {
            if (std::find(users[i].begin(), users[i].end(), sites[s]) != users[i].end()) {
                of_component.push_back(s);
            }
        }
        if (!of_component.empty()) {
            new_place[i] = some.components.size();
            some.components.push_back(components[i]);
            some.users.push_back(std::move(of_component));
        }
    }
    for (const std::size_t site : sites) {
        std::vector<std::size_t>& of_site = some.places.emplace_back();
        for (const std::size_t place : places[site]) {
            of_site.push_back(new_place[place]);
        }
    }
    return some;
}

std::size_t SharedComponents::find(const std::string& parameter) const {
    return static_cast<std::size_t>(
        std::find_if(components.begin(), components.end(),
                     [&](const ParameterDraws::Component& one) { return one.parameter == parameter; }) -
        components.begin());
}

}  // namespace coupling::calibrate
