#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "coupling/assessments/calibrate/search/judgement.hpp"
#include "coupling/assessments/calibrate/search/self_distance.hpp"
#include "coupling/assessments/calibrate/sites/open_sites.hpp"
#include "coupling/assessments/calibrate/sites/shared_components.hpp"
#include "rockfall/slope/slope.hpp"
#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling::calibrate::sites_test {
namespace {

/// Soil and rock, with codes of the site.
std::vector<rockfall::SurfaceType> grounds(int first_code) {
    rockfall::SurfaceType soil;
    soil.code = first_code;
    soil.label = "soil";
    soil.restitution = {0.3, 0.8};
    rockfall::SurfaceType rock;
    rock.code = first_code + 1;
    rock.label = "rock";
    rock.restitution = {0.4, 0.9};
    return {soil, rock};
}

/// A site with losses, friction, and losses on its two grounds; on soil they go with the friction.
struct Known {
    explicit Known(std::string name, int first_code) : types{grounds(first_code)} {
        const std::string soil = "losses_on." + std::to_string(first_code);
        const std::string rock = "losses_on." + std::to_string(first_code + 1);
        parameters = {.name = name,
                      .scenario = name + "/scenario.ini",
                      .components = {{"losses", "", 0.2},
                                     {"friction", "", 0.3},
                                     {"block_size", "", 0.35},
                                     {soil, "soil", 0.4, false, "friction", -0.7},
                                     {rock, "rock", 0.4}},
                      .types = &types,
                      .occurs = {true, true}};
    }
    Known(const Known&) = delete;

    std::vector<rockfall::SurfaceType> types;
    SiteParameters parameters;
};

std::string refusal_of(const std::vector<SiteParameters>& sites, config::ExitCode code) {
    try {
        (void)share(sites);
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.code(), code);
        return error.what();
    }
    return "";
}

std::vector<std::string> names_of(const SharedComponents& shared) {
    std::vector<std::string> names;
    for (const auto& component : shared.components) {
        names.push_back(component.parameter);
    }
    return names;
}

TEST(SharedComponents, AreThoseOfMotionAndOfGroundsOfTheSameName) {
    const Known north{"north", 1};
    Known south{"south", 2};  // its soil has the code of the rock in the north
    const SharedComponents shared = share(std::vector{north.parameters, south.parameters});
    EXPECT_EQ(names_of(shared), (std::vector<std::string>{"losses", "friction", "block_size:north",
                                                          "losses_on.1", "losses_on.2", "block_size:south"}));
    EXPECT_EQ(shared.places[0], (std::vector<std::size_t>{0, 1, 2, 3, 4}));
    EXPECT_EQ(shared.places[1], (std::vector<std::size_t>{0, 1, 5, 3, 4}));
    EXPECT_EQ(shared.users[3], (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(shared.users[5], (std::vector<std::size_t>{1}));
    EXPECT_EQ(shared.components[3].goes_with, "friction");

    // A ground that only one of them has.
    south.types[0].label = "gravel";
    south.parameters.components[3].ground = "gravel";
    EXPECT_EQ(names_of(share(std::vector{north.parameters, south.parameters})),
              (std::vector<std::string>{"losses", "friction", "block_size:north", "losses_on.1",
                                        "losses_on.2", "block_size:south", "losses_on.2:south"}));
    EXPECT_EQ(names_of(share(std::vector{north.parameters})),
              (std::vector<std::string>{"losses", "friction", "block_size", "losses_on.1", "losses_on.2"}));
}

TEST(SharedComponents, OfAGuessedMapOfGroundsBelongToItsSite) {
    const Known north{"north", 1};
    Known south{"south", 1};
    south.parameters.ground_is_guessed = true;
    south.parameters.components[3].width = 0.5;
    south.parameters.components[4].width = 0.5;
    const SharedComponents shared = share(std::vector{north.parameters, south.parameters});
    EXPECT_EQ(shared.components.size(), 8U);
    EXPECT_LT(shared.find("losses_on.1:south"), shared.components.size());
    EXPECT_EQ(shared.components[shared.find("losses_on.1:south")].goes_with, "friction");
}

TEST(SharedComponents, OfSomeSitesKeepTheirNames) {
    const Known north{"north", 1};
    const Known south{"south", 2};
    const SharedComponents shared = share(std::vector{north.parameters, south.parameters});
    const std::vector<std::size_t> one{1};
    const SharedComponents south_alone = shared.of(one);
    EXPECT_EQ(names_of(south_alone), (std::vector<std::string>{"losses", "friction", "losses_on.1",
                                                               "losses_on.2", "block_size:south"}));
    EXPECT_EQ(south_alone.places, (std::vector<std::vector<std::size_t>>{{0, 1, 4, 2, 3}}));
    EXPECT_EQ(south_alone.users[4], (std::vector<std::size_t>{0}));
}

TEST(SharedComponents, AreKnownTheSameEverywhereBefore) {
    const Known north{"north", 1};
    Known south{"south", 1};
    south.parameters.components[1].width = 0.1;
    const std::string widths = refusal_of({north.parameters, south.parameters}, config::ExitCode::settings);
    EXPECT_NE(widths.find("south/scenario.ini"), std::string::npos) << widths;
    EXPECT_NE(widths.find("a width of 0.1 for friction, but 0.3 in north/scenario.ini"), std::string::npos)
        << widths;
    Known other{"south", 1};
    other.parameters.components[3].correlation = 0.2;
    EXPECT_NE(
        refusal_of({north.parameters, other.parameters}, config::ExitCode::settings).find("losses_on.1"),
        std::string::npos);
}

TEST(SharedComponents, RefuseOneNameForTwoGrounds) {
    const Known north{"north", 1};
    Known south{"south", 1};
    south.types[0].restitution.tangential = 0.85;
    EXPECT_NE(refusal_of({north.parameters, south.parameters}, config::ExitCode::data)
                  .find("ground type 'soil' with other values than north/scenario.ini has for it: r_t 0.85 "
                        "for 0.8"),
              std::string::npos);
    south.parameters.occurs[0] = false;  // it is on no cell: nothing falls on it
    south.parameters.components.erase(south.parameters.components.begin() + 3);
    EXPECT_EQ(share(std::vector{north.parameters, south.parameters}).components.size(), 6U);
    Known twice{"south", 1};
    twice.types[1].label = "soil";
    EXPECT_NE(refusal_of({north.parameters, twice.parameters}, config::ExitCode::data)
                  .find("ground types 1 and 2 with one name"),
              std::string::npos);
}

TEST(GroundDifferences, AreThoseOfAnyFigure) {
    const rockfall::SurfaceType one = grounds(1).front();
    rockfall::SurfaceType other = one;
    other.code = 7;
    EXPECT_EQ(difference_of(one, other), "") << "codes are of the map";
    other.stopping = rockfall::StopCurve{{{1.0, 0.1}}};
    EXPECT_NE(difference_of(one, other).find("probability to stop"), std::string::npos);
    other = one;
    other.roughness_m = 0.3;
    EXPECT_EQ(difference_of(one, other), "roughness_m 0.3 for 0");
    other = one;
    other.soil.emplace().name = "loose";
    EXPECT_EQ(difference_of(one, other), "soil loose for none");
    other = one;
    other.block.friction_max = 3.0;
    EXPECT_NE(difference_of(one, other), "");
}

TEST(Sites, HaveNamesForFiles) {
    EXPECT_EQ(names_of_sites({"/a/any/scenario.ini", "/a/north/scenario.ini", "/a/Süd hang.ini",
                              "/b/north/scenario.ini"}),
              (std::vector<std::string>{"any", "north", "S__d_hang", "north_2"}));
    EXPECT_EQ(names_of_sites({"/a/any/scenario.ini"}), std::vector<std::string>{"scenario"});
    EXPECT_EQ(names_of_sites({"/a/any/slope.ini", "/a/any/scenario.ini"}),
              (std::vector<std::string>{"slope", "any"}));
}

// Each of several sites may be further away by chance: 5 % are shared among them.
TEST(Transfers, AreJudgedTogether) {
    Transfer transfer{.sides = {}, .as_far = 0.02, .sites = 2};
    EXPECT_EQ(transfer.least_as_far(), 0.025);
    EXPECT_EQ(transfer.verdict(), TransferVerdict::too_far);
    transfer.sites = 3;
    EXPECT_EQ(transfer.verdict(), TransferVerdict::holds);
    transfer.shows_too_few = true;
    EXPECT_EQ(transfer.verdict(), TransferVerdict::too_few);
    transfer.end = SearchEnd::budget;
    EXPECT_EQ(transfer.verdict(), TransferVerdict::not_close);
}

TEST(Sites, HaveRocksOfTheirOwn) {
    EXPECT_EQ(seed_of_site(7, 0), 7U);
    EXPECT_NE(seed_of_site(7, 1), seed_of_site(7, 2));
    EXPECT_NE(seed_of_site(7, 1), seed_of_site(8, 1));
}

// Ten observations of one site and one of another: a set that is far off at the one is far off, however near
// it is at all others.
TEST(SelfDistances, OfSeveralSitesAreThatOfTheFarthestOne) {
    std::mt19937 engine{11};
    std::normal_distribution<double> normal;
    std::vector<std::vector<Sample>> sets(20);
    std::vector<Witnessed> observed;
    for (std::uint32_t i = 0; i < 11; ++i) {
        observed.push_back({40, i, 0.0, i < 10 ? 0U : 1U});
    }
    for (std::vector<Sample>& set : sets) {
        for (std::size_t i = 0; i < observed.size(); ++i) {
            std::vector<double> values(300);
            std::generate(values.begin(), values.end(), [&] { return normal(engine); });
            set.push_back(sample_of_values(values));
        }
    }
    const SelfDistance scale = self_distance(sets, observed, 1, 3);
    ASSERT_EQ(scale.of_sites.size(), 2U);
    EXPECT_GT(scale.of_sites[1], scale.of_sites[0]) << "one observation scatters more than the mean of ten";
    std::vector<double> near(observed.size(), 0.0);
    EXPECT_EQ(scale.together(near), 0.0);
    near.back() = 2.0 * scale.of_sites[1] * scale.medians.back();
    EXPECT_DOUBLE_EQ(scale.together(near), 2.0);
    EXPECT_GT(scale.together(near), scale.at_95) << "ten other observations do not hide it";
    // Both within their own 90 % points is rarer than one of them: the goal lies above 1.
    EXPECT_GT(scale.at_90, 1.0);
    EXPECT_LT(scale.at_90, 1.6);
    // A share of 0.9 of each alone.
    std::vector<Witnessed> one_site = observed;
    for (Witnessed& each : one_site) {
        each.site = 0;
    }
    EXPECT_TRUE(self_distance(sets, one_site, 1, 3).of_sites.empty());
}

}  // namespace
}  // namespace coupling::calibrate::sites_test
