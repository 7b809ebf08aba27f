#include "coupling/inputs/parameters/parameter_widths.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/inputs/parameters/parameter_draws.hpp"
#include "coupling/inputs/site_draws.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::parameter_widths_test {
namespace {

Opened open_with(const std::string& rows) {
    const SampleProject project;
    project.write("parameters.csv", "parameter,width\n" + rows);
    project.replace("scenario.ini", "[terrain]",
                    "[run]\nparameter_draws = yes\nparameters = parameters.csv\n[terrain]");
    return open(project);
}

ParameterDraws draws_of(const Opened& opened, bool has_obstacles = true) {
    return draw_parameters(
        opened.site->parameter_widths,
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
    EXPECT_EQ(width_of(plain.site->parameter_widths, "losses"),
              width_of(shipped_parameter_widths(), "losses"));
    const Opened changed = open_with("losses,0.05\nlosses_on.3,0.6\n");
    ASSERT_TRUE(changed.site) << changed.errors;
    EXPECT_EQ(width_of(changed.site->parameter_widths, "losses"), 0.05);
    EXPECT_EQ(width_of(changed.site->parameter_widths, "losses_on.3"), 0.6);
    EXPECT_EQ(width_of(changed.site->parameter_widths, "friction"),
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
    EXPECT_TRUE(open(SampleProject{}, {"rockfall.preset=strict"}).site->parameter_widths.empty());
    EXPECT_TRUE(open(SampleProject{}, {"run.parameter_draws=no"}).site->parameter_widths.empty());
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

}  // namespace
}  // namespace coupling::parameter_widths_test
