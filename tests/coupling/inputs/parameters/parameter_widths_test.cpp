#include "coupling/inputs/parameters/parameter_widths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coupling/inputs/parameters/correlated_draws.hpp"
#include "coupling/inputs/parameters/parameter_draws.hpp"
#include "coupling/inputs/scenario/release_settings.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site_draws.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::parameter_widths_test {
namespace {

Opened open_with(const std::string& rows, const std::string& columns = "parameter,width") {
    const SampleProject project;
    project.write("parameters.csv", columns + "\n" + rows);
    project.replace("scenario.ini", "[terrain]",
                    "[run]\nparameter_draws = yes\nparameters = parameters.csv\n[terrain]");
    return open(project);
}

ParameterDraws draws_of(const Opened& opened, bool has_obstacles = true) {
    return draw_parameters(
        *opened.site->knowledge,
        {opened.site->slope.types, std::vector<bool>(opened.site->slope.types.size(), true), has_obstacles},
        opened.scenario->rockfall.fall, opened.scenario->run.seed, 20'000);
}

TEST(ShippedWidths, SayWhereTheyComeFrom) {
    const std::vector<ParameterWidth> widths = shipped_parameter_widths();
    EXPECT_GE(widths.size(), 7U);
    for (const ParameterWidth& width : widths) {
        EXPECT_TRUE(width.source.starts_with("[fit]") || width.source.starts_with("[lit]") ||
                    width.source.starts_with("[choice]"))
            << width.parameter << ": " << width.source;
    }
}

TEST(Widths, AreTheShippedOnesUnlessAFileChangesThem) {
    const Opened plain = open(SampleProject{}, {"run.parameter_draws=yes"});
    ASSERT_TRUE(plain.site) << plain.errors;
    EXPECT_EQ(width_of(plain.site->knowledge->widths, "losses"),
              width_of(shipped_parameter_widths(), "losses"));
    const Opened changed = open_with("losses,0.05\nlosses_on.3,0.6\n");
    ASSERT_TRUE(changed.site) << changed.errors;
    EXPECT_EQ(width_of(changed.site->knowledge->widths, "losses"), 0.05);
    EXPECT_EQ(width_of(changed.site->knowledge->widths, "losses_on.3"), 0.6);
    EXPECT_EQ(width_of(changed.site->knowledge->widths, "friction"),
              width_of(shipped_parameter_widths(), "friction"));
}

TEST(Widths, RefuseAnUnknownParameterWithTheNearestWord) {
    const Opened opened = open_with("loses,0.05\nlosses_on.7,0.1\nfriction,-1\n");
    EXPECT_EQ(opened.code, config::ExitCode::data);
    EXPECT_NE(opened.errors.find("parameters.csv:2"), std::string::npos) << opened.errors;
    EXPECT_NE(opened.errors.find("losses?"), std::string::npos) << opened.errors;
    EXPECT_NE(opened.errors.find("losses_on.7"), std::string::npos) << opened.errors;
    EXPECT_NE(opened.errors.find("-1"), std::string::npos) << opened.errors;
}

TEST(Draws, AreNoneWhereAllIsKnownAndUnderStrictSettings) {
    std::string known;
    for (const ParameterWidth& width : shipped_parameter_widths()) {
        known += width.parameter + ",0\n";
    }
    const Opened all_known = open_with(known);
    ASSERT_TRUE(all_known.site) << all_known.errors;
    EXPECT_TRUE(draws_of(all_known).empty());
    EXPECT_FALSE(open(SampleProject{}, {"rockfall.preset=strict"}).site->knowledge->has_spread());
    EXPECT_FALSE(open(SampleProject{}, {"run.parameter_draws=no"}).site->knowledge->has_spread());
}

TEST(Draws, OfBlockSizesAreInTheRocksAndInWhatIsIndexedForThem) {
    const Opened known = open(SampleProject{});
    const Opened guessed = open_with("block_size,0.35\n");
    ASSERT_TRUE(known.site && guessed.site) << known.errors << guessed.errors;
    const ParameterDraws without = draws_of(known);
    for (const rockfall::FallDraw& draw : without.falls) {
        EXPECT_EQ(draw.block_size, 1.0);
    }
    const ParameterDraws draws = draws_of(guessed);
    double sum = 0.0;
    double squares = 0.0;
    double largest = 0.0;
    for (const rockfall::FallDraw& draw : draws.falls) {
        const double log_size = std::log(draw.block_size);
        sum += log_size;
        squares += log_size * log_size;
        largest = std::max(largest, draw.block_size);
    }
    const auto count = static_cast<double>(draws.falls.size());
    EXPECT_NEAR(sum / count, 0.0, 0.01);  // a Latin hypercube
    EXPECT_NEAR(std::sqrt(squares / count), 0.35, 0.02);
    const rockfall::StartLaw start = start_law(guessed.scenario->release);
    EXPECT_DOUBLE_EQ(largest_radius_m(start, guessed.site->sources, draws),
                     largest * rockfall::largest_radius_m(start, guessed.site->sources));
    // What is drawn before them stays as it was; later ones keep clear of them in the hypercube.
    for (std::size_t i = 0; draws.components[i].parameter != "block_size"; ++i) {
        EXPECT_EQ(draws.components[i].parameter, without.components[i].parameter);
        EXPECT_EQ(draws.factors[5][i], without.factors[5][i]) << without.components[i].parameter;
    }
}

TEST(Draws, AreTheSameWithAndWithoutForest) {
    const Opened opened = open(SampleProject{}, {"run.parameter_draws=yes"});
    ASSERT_TRUE(opened.site) << opened.errors;
    const ParameterDraws forest = draws_of(opened);
    const ParameterDraws bare = draws_of(opened, false);
    ASSERT_EQ(forest.falls.size(), 64U);
    EXPECT_EQ(forest.components.size(), bare.components.size() + 1);
    for (std::size_t k = 0; k < 64; ++k) {
        EXPECT_TRUE(std::equal(bare.factors[k].begin(), bare.factors[k].end(), forest.factors[k].begin()));
    }
}

TEST(DrawsOfReplicates, HaveTheWidthsAndNoneForTheFirst) {
    const Opened opened = open(SampleProject{}, {"run.parameter_draws=yes"});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_TRUE(draw_of_replicate_on(*opened.scenario, *opened.site, 0).empty());
    constexpr std::uint32_t replicates = 4000;
    std::vector<double> sums;
    std::vector<double> squares;
    ParameterDraws draws;
    for (std::uint32_t replicate = 1; replicate <= replicates; ++replicate) {
        draws = draw_of_replicate_on(*opened.scenario, *opened.site, replicate);
        ASSERT_EQ(draws.falls.size(), 1U);
        sums.resize(draws.components.size());
        squares.resize(draws.components.size());
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const double standard = std::log(draws.factors.front()[i]) / draws.components[i].width;
            sums[i] += standard;
            squares[i] += standard * standard;
        }
    }
    // Four standard errors; cut off at three deviations, a standard normal number has a variance of 0.973.
    for (std::size_t i = 0; i < sums.size(); ++i) {
        EXPECT_NEAR(sums[i] / replicates, 0.0, 4.0 / std::sqrt(replicates)) << draws.components[i].parameter;
        EXPECT_NEAR(squares[i] / replicates, 0.973, 4.0 * std::sqrt(2.0 / replicates))
            << draws.components[i].parameter;
    }
}

TEST(Draws, HaveGroundTypesWithLossesOfTheirOwn) {
    const Opened opened = open(SampleProject{}, {"run.parameter_draws=yes"});
    const ParameterDraws draws = draws_of(opened);
    bool rock_and_soil_differ = false;
    for (const rockfall::FallDraw& draw : draws.falls) {
        ASSERT_EQ(draw.types.size(), 2U);
        const double rock = (1.0 - draw.types[0].restitution.tangential) / 0.10;
        const double soil = (1.0 - draw.types[1].restitution.tangential) / 0.20;
        rock_and_soil_differ = rock_and_soil_differ || std::abs(rock - soil) > 0.1;
    }
    EXPECT_TRUE(rock_and_soil_differ);
}

std::size_t place_of(const ParameterDraws& draws, const std::string& parameter) {
    const auto found =
        std::find_if(draws.components.begin(), draws.components.end(),
                     [&](const ParameterDraws::Component& one) { return one.parameter == parameter; });
    EXPECT_NE(found, draws.components.end()) << parameter;
    return static_cast<std::size_t>(found - draws.components.begin());
}

constexpr const char* with_links = "parameter,width,goes_with,correlation";

/// Correlation of two components over all draws.
double correlation_of(const std::vector<std::vector<double>>& factors, std::size_t one, std::size_t other) {
    double sums[5]{};
    for (const std::vector<double>& each : factors) {
        const double x = std::log(each[one]);
        const double y = std::log(each[other]);
        const double added[5]{x, y, x * x, y * y, x * y};
        for (int i = 0; i < 5; ++i) {
            sums[i] += added[i] / static_cast<double>(factors.size());
        }
    }
    return (sums[4] - sums[0] * sums[1]) /
           std::sqrt((sums[2] - sums[0] * sums[0]) * (sums[3] - sums[1] * sums[1]));
}

TEST(JointDraws, CorrelateAsTheTableSaysAndKeepTheirWidths) {
    const Opened opened = open_with("losses_on.3,0.54,friction,-0.78\n", with_links);
    ASSERT_TRUE(opened.site) << opened.errors;
    constexpr std::uint32_t replicates = 4000;
    std::vector<std::vector<double>> factors;
    ParameterDraws draws;
    for (std::uint32_t replicate = 1; replicate <= replicates; ++replicate) {
        draws = draw_of_replicate_on(*opened.scenario, *opened.site, replicate);
        factors.push_back(draws.factors.front());
    }
    const std::size_t losses = place_of(draws, "losses_on.3");
    const std::size_t friction = place_of(draws, "friction");
    // Four standard errors of a correlation.
    EXPECT_NEAR(correlation_of(factors, losses, friction), -0.78,
                4.0 * (1.0 - 0.78 * 0.78) / std::sqrt(replicates));
    EXPECT_NEAR(correlation_of(factors, losses, place_of(draws, "stopping")), 0.0,
                4.0 / std::sqrt(replicates));
    EXPECT_EQ(draws.components[losses].width, 0.54);
    double squares = 0.0;
    for (const std::vector<double>& each : factors) {
        const double standard = std::log(each[losses]) / 0.54;
        EXPECT_LE(std::abs(standard), 3.0 + 1e-12);
        squares += standard * standard / replicates;
    }
    EXPECT_NEAR(squares, 0.973, 4.0 * std::sqrt(2.0 / replicates));
}

TEST(JointDraws, CorrelateOverTheStrataOfToday) {
    const Opened opened = open_with("losses_on.3,0.54,friction,-0.78\n", with_links);
    ASSERT_TRUE(opened.site) << opened.errors;
    const ParameterDraws draws = draws_of(opened);
    ASSERT_EQ(draws.factors.size(), 64U);
    EXPECT_NEAR(correlation_of(draws.factors, place_of(draws, "losses_on.3"), place_of(draws, "friction")),
                -0.78, 4.0 * (1.0 - 0.78 * 0.78) / std::sqrt(64.0));
}

TEST(JointDraws, ChangeNothingButTheParameterOfTheirRow) {
    const Opened apart = open_with("losses_on.3,0.54\n");
    const Opened joint = open_with("losses_on.3,0.54,friction,-0.78\n", with_links);
    ASSERT_TRUE(apart.site && joint.site) << apart.errors << joint.errors;
    const ParameterDraws before = draws_of(apart);
    const ParameterDraws after = draws_of(joint);
    ASSERT_EQ(before.components.size(), after.components.size());
    for (std::size_t i = 0; i < before.components.size(); ++i) {
        int changed = 0;
        for (std::size_t k = 0; k < before.factors.size(); ++k) {
            changed += before.factors[k][i] == after.factors[k][i] ? 0 : 1;
        }
        EXPECT_EQ(changed > 0, before.components[i].parameter == "losses_on.3")
            << before.components[i].parameter;
    }
}

TEST(JointDraws, AreMadeOfIndependentNumbersThatComeOutAgain) {
    const Opened opened = open_with("losses_on.3,0.54,friction,-0.78\n", with_links);
    ASSERT_TRUE(opened.site) << opened.errors;
    const ParameterDraws draws = draws_of(opened);
    std::vector<double> numbers(draws.components.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        numbers[i] = 0.3 * static_cast<double>(i % 5) - 0.6;
    }
    const std::vector<double> again = independent_of(draws.components, correlated(draws.components, numbers));
    ASSERT_NE(correlated(draws.components, numbers), numbers);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        EXPECT_NEAR(again[i], numbers[i], 1e-12);
    }
}

TEST(JointDraws, ScatterLessWhereTheOtherParameterIsKnown) {
    const Opened opened = open_with("losses_on.3,0.5,friction,-0.8\nfriction,0,,\n", with_links);
    ASSERT_TRUE(opened.site) << opened.errors;
    const ParameterDraws draws = draws_of(opened);
    EXPECT_NEAR(draws.components[place_of(draws, "losses_on.3")].width, 0.5 * 0.6, 1e-12);
}

TEST(JointDraws, ShareOnlyWhatTheGroundWasNotGuessedBy) {
    const Opened opened = open_with("losses_on.3,0.3,friction,-0.8\nground_guess,0.4,,\n", with_links);
    ASSERT_TRUE(opened.site) << opened.errors;
    const ParameterDraws draws = draws_of(opened);
    const ParameterDraws::Component& losses = draws.components[place_of(draws, "losses_on.3")];
    EXPECT_NEAR(losses.width, 0.5, 1e-12);
    EXPECT_NEAR(losses.correlation, -0.8 * 0.3 / 0.5, 1e-12);
}

TEST(JointDraws, RefuseWhatCannotGoTogether) {
    const Opened opened = open_with(
        "losses_on.3,0.3,tree_energy,-0.8\nfriction,0.3,losses,\nstopping,0.7,,0.5\n"
        "jump_angle,0.2,jump_angle,0.5\nlosses_on.1,0.3,sideways,0.5\nsideways,0.2,losses,0.5\n"
        "losses,0.2,friction,1\n",
        with_links);
    EXPECT_EQ(opened.code, config::ExitCode::data);
    for (const char* found :
         {"parameters.csv:2:", "'tree_energy'", "parameters.csv:3:", "goes_with without a correlation",
          "parameters.csv:4:", "a correlation with nothing",
          "parameters.csv:5:", "'jump_angle', which goes with another one",
          "parameters.csv:6:", "'sideways', which goes with another one", "parameters.csv:8:"}) {
        EXPECT_NE(opened.errors.find(found), std::string::npos) << found << "\n" << opened.errors;
    }
}

/// Two sets; stopping is not in it and keeps its width.
Opened with_sample(const std::string& columns = "set,weight,losses,losses_on.3",
                   std::vector<std::string> overrides = {}) {
    const SampleProject project;
    project.write("posterior.csv", columns + "\n1,0.25,0.8,2\n2,0.75,1.25,0.5\n");
    overrides.push_back("run.parameters=posterior.csv");
    return open(project, overrides);
}

TEST(JointSamples, AreDrawnSetBySetByTheirWeights) {
    const Opened opened = with_sample();
    ASSERT_TRUE(opened.site) << opened.errors;
    const ParameterDraws draws = draws_of(opened);
    const std::size_t losses = place_of(draws, "losses");
    const std::size_t on_soil = place_of(draws, "losses_on.3");
    const std::size_t stopping = place_of(draws, "stopping");
    int first = 0;
    bool stopping_varies = false;
    for (const std::vector<double>& factors : draws.factors) {
        EXPECT_EQ(factors[on_soil], factors[losses] == 0.8 ? 2.0 : 0.5);
        first += factors[losses] == 0.8 ? 1 : 0;
        stopping_varies = stopping_varies || factors[stopping] != draws.factors[0][stopping];
    }
    EXPECT_EQ(first, 16);  // a quarter of 64: strata share the weights evenly
    EXPECT_TRUE(stopping_varies);
}

TEST(JointSamples, FallByTheirCentreWhereNothingIsDrawn) {
    const Opened opened = with_sample("set,weight,losses,losses_on.3", {"run.parameter_draws=no"});
    ASSERT_TRUE(opened.site) << opened.errors;
    const ParameterDraws draws = draws_on(*opened.scenario, *opened.site);
    ASSERT_EQ(draws.falls.size(), 1U);
    EXPECT_FALSE(draws.has_spread());
    EXPECT_NEAR(draws.factors[0][place_of(draws, "losses")],
                std::exp(0.25 * std::log(0.8) + 0.75 * std::log(1.25)), 1e-12);
    EXPECT_EQ(draws.factors[0][place_of(draws, "stopping")], 1.0);
    const ParameterDraws first =
        draw_of_replicate_on(*opened.scenario, *opened.site, 0);  // has a forest, too
    EXPECT_TRUE(std::equal(draws.factors[0].begin(), draws.factors[0].end(), first.factors[0].begin()));
}

TEST(JointSamples, OfReplicatesFollowTheWeights) {
    const Opened opened = with_sample();
    ASSERT_TRUE(opened.site) << opened.errors;
    constexpr std::uint32_t replicates = 2000;
    int first = 0;
    for (std::uint32_t replicate = 1; replicate <= replicates; ++replicate) {
        const ParameterDraws draws = draw_of_replicate_on(*opened.scenario, *opened.site, replicate);
        first += draws.factors[0][place_of(draws, "losses")] == 0.8 ? 1 : 0;
    }
    EXPECT_NEAR(first, 0.25 * replicates, 4.0 * std::sqrt(0.25 * 0.75 * replicates));
}

TEST(JointSamples, OfAnotherSiteAreRefused) {
    const Opened opened = with_sample("set,weight,losses,losses_on.scree_x");
    EXPECT_EQ(opened.code, config::ExitCode::data);
    EXPECT_NE(opened.errors.find("column 'losses_on.scree_x'"), std::string::npos) << opened.errors;
    EXPECT_NE(opened.errors.find("calibrate here, or delete the column"), std::string::npos) << opened.errors;
    EXPECT_EQ(with_sample("set,weight,losses,losses_on.3", {"run.strict_inputs=yes"}).errors, "");
}

}  // namespace
}  // namespace coupling::parameter_widths_test
