#include "tests/runs/nets.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "tests/runs/motion_models.hpp"
#include "tests/runs/years.hpp"

namespace coupling::nets_test {
namespace {

class NetsUnderModel : public ::testing::TestWithParam<std::string> {
protected:
    [[nodiscard]] static std::string motion() { return motion_settings(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Motion, NetsUnderModel, ::testing::ValuesIn(motion_model_names()),
                         [](const auto& model) { return model.param; });

TEST_P(NetsUnderModel, GiveTheSameBytesOnAnyNumberOfThreads) {
    const SampleProject project;
    add_nets(project);
    const std::string rocks = "run scenario.ini --quiet " + rocks_for(GetParam(), 3000) + motion();
    ASSERT_EQ(call(project, rocks + "--threads 1 --out first").code, 0);
    const Outcome outcome =
        shell(project, "\"$bannwald\" " + rocks + "--threads 5 --out second && diff -r first second\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST_P(NetsUnderModel, AreCountedAlikeInAllTables) {
    const SampleProject project;
    add_nets(project);
    const Outcome outcome =
        call(project, "run scenario.ini --quiet --out out " +
                          rocks_for(GetParam(), GetParam() == "rigid" ? 40000 : 5000) + motion());
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table nets = table(project, "out/tables/nets.csv");
    const config::Table crossings = table(project, "out/tables/net_crossings.csv");
    const config::Table rocks = table(project, "out/tables/rocks.csv");
    ASSERT_EQ(nets.rows(), 4U);  // two nets, with forest and without
    for (const std::string cover : {"forest", "bare"}) {
        std::size_t held = 0;
        for (std::size_t row = 0; row < crossings.rows(); ++row) {
            held +=
                crossings.text(row, "cover") == cover && crossings.text(row, "outcome") == "held" ? 1U : 0U;
        }
        std::size_t ended = 0;
        for (std::size_t row = 0; row < rocks.rows(); ++row) {
            ended += rocks.text(row, "cover") == cover && rocks.text(row, "stop_reason") == "net" ? 1U : 0U;
        }
        EXPECT_EQ(held, ended);
        EXPECT_GT(held, GetParam() == "rigid" ? 5U : 100U);
    }
    for (std::size_t row = 0; row < nets.rows(); ++row) {
        const auto whole = [&](const char* column) { return std::stoul(nets.text(row, column)); };
        EXPECT_EQ(whole("reached"), whole("held") + whole("over") + whole("below") + whole("broke"));
        if (GetParam() != "rigid") {  // of whose slow blocks too few fall here for a class
            EXPECT_FALSE(nets.text(row, "design_class").empty());
        }
    }
    EXPECT_NE(project.read("out/report.html").find("Held by a net"), std::string::npos);
    EXPECT_NE(project.read("out/report.html").find("<h2>Nets</h2>"), std::string::npos);
}

TEST(Nets, KeepRocksFromTheTargetBehindThem) {
    const SampleProject project;
    add_nets(project);
    project.replace("nets.csv", "lower,3,,1", "lower,50,9000,");
    const Outcome outcome = call(project, "run scenario.ini --quiet --set release.rocks=2000 --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table targets = table(project, "out/tables/targets.csv");
    for (std::size_t row = 0; row < targets.rows(); ++row) {
        if (targets.text(row, "target_id") == "road") {
            EXPECT_EQ(targets.text(row, "reached"), "0");
        }
    }
}

TEST(Nets, HoldRocksInRunsOverYearsTooAndThePageSaysWhere) {
    const ForestProject project;
    project.write("nets.csv",
                  "name,height_m,capacity_kj,wkt\nlower,3,250,\"LINESTRING (1098 2005, 1098 2095)\"\n");
    const Outcome outcome =
        call(project, std::string{four_members} + "--set nets.file=nets.csv --set run.years=2 --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table causes = table(project, "out/tables/causes.csv");
    double held = 0.0;
    for (std::size_t row = 0; row < causes.rows(); ++row) {
        held += causes.text(row, "cause") == "net" && causes.text(row, "cover") == "bare"
                    ? number(causes, row, "stopped")
                    : 0.0;
    }
    EXPECT_GT(held, 0.0);
    EXPECT_NE(project.read("out/report.html").find("The nets stand on the bare slope too"),
              std::string::npos);
    const Outcome share =
        call(project,
             "check scenario.ini --set run.years=2 --set nets.file=nets.csv "
             "--set nets.wanted_share=0.9 --set trees.file= --set stands.records=records.csv");
    EXPECT_NE(share.err.find("nets.wanted_share has no effect: run.years is 2"), std::string::npos)
        << share.err;
}

/// Rows of a table of crossings as text.
std::string without_head(const std::string& csv) {
    return csv.substr(csv.find('\n') + 1);
}

TEST_P(NetsUnderModel, TriedOnStoredPathsGiveTheRowsOfARunWithThem) {
    const SampleProject project;
    add_nets(project);
    project.replace("nets.csv", "upper,1.2,5,,0.1", "upper,0.8,9000,,0.55");
    project.replace("nets.csv", "lower,3,,1", "lower,3,9000,");
    const std::string rocks = "run scenario.ini --quiet " + rocks_for(GetParam(), 2000) + motion();
    ASSERT_EQ(call(project, rocks + "--out with_nets").code, 0);
    const Outcome kept =
        call(project, rocks + "--set nets.file= --set nets.keep_paths=yes --threads 3 --out without_nets");
    ASSERT_EQ(kept.code, 0) << kept.err;
    const Outcome tried = call(project, "net try without_nets --nets nets.csv --out tried");
    ASSERT_EQ(tried.code, 0) << tried.err;
    const std::string crossings = project.read("tried/net_crossings.csv");
    // Under pir3d no rock is above the upper net.
    for (const std::string outcome : {",held,", ",below,", GetParam() == "picus" ? ",over," : ",held,"}) {
        EXPECT_NE(crossings.find(outcome), std::string::npos) << outcome;
    }
    EXPECT_EQ(crossings, project.read("with_nets/tables/net_crossings.csv"));
    EXPECT_EQ(project.read("tried/nets.csv"), project.read("with_nets/tables/nets.csv"));
    EXPECT_EQ(project.read("tried/net_needs.csv"), project.read("with_nets/tables/net_needs.csv"));
    EXPECT_EQ(without_head(project.read("tried/net_inexact.csv")), "");
}

TEST(Nets, AreToldAtTheEndOfARunAndOnItsPage) {
    const SampleProject project;
    add_nets(project);
    const Outcome run =
        call(project, "run scenario.ini --set release.rocks=2000 --set trees.file= --out out");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.out.find("  net lower, bare slope: "), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("; design: class "), std::string::npos) << run.out;
    const std::string page = project.read("out/report.html");
    EXPECT_NE(page.find("its centre plus its radius, here up to 0.250"), std::string::npos);
    // Without trees nothing is said of what a forest protects.
    EXPECT_EQ(page.find("Nets are works, not forest"), std::string::npos);
}

/// A net that holds all, along the very line of the target: nothing arrives there, not even by rounding.
TEST_P(NetsUnderModel, KeepEveryRockFromATargetOnTheirLine) {
    const SampleProject project;
    project.write(
        "nets.csv",
        "name,height_m,capacity_kj,wkt\nwall,50,30000,\"LINESTRING (1098 2005, 1098 2010, 1098 2090, "
        "1098 2095)\"\n");
    project.replace("targets.csv", "1105 2010, 1105 2090", "1098 2010, 1098 2090");
    project.replace("scenario.ini", "[targets]", "[nets]\nfile = nets.csv\n[targets]");
    const Outcome run = call(project, "run scenario.ini --quiet " + rocks_for(GetParam(), 2000) + motion());
    ASSERT_EQ(run.code, 0) << run.err;
    const config::Table nets = table(project, "out/tables/nets.csv");
    double held = 0.0;
    for (std::size_t row = 0; row < nets.rows(); ++row) {
        held += number(nets, row, "held");
    }
    EXPECT_GT(held, GetParam() == "rigid" ? 1.0 : 20.0);
    // A rock that comes to rest before the net may touch the line with its side; none that the net holds
    // does.
    std::map<std::string, std::string> ends;
    const config::Table rocks = table(project, "out/tables/rocks.csv");
    for (std::size_t row = 0; row < rocks.rows(); ++row) {
        ends[rocks.text(row, "rock") + rocks.text(row, "cover")] = rocks.text(row, "stop_reason");
    }
    const config::Table arrivals = table(project, "out/tables/arrivals.csv");
    for (std::size_t row = 0; row < arrivals.rows(); ++row) {
        if (arrivals.text(row, "target_id") == "road") {
            EXPECT_EQ(arrivals.text(row, "by_side"), "yes");
            EXPECT_NE(ends.at(arrivals.text(row, "rock") + arrivals.text(row, "cover")), "net");
        }
    }
}

TEST(Nets, InOnePlaceAreRefusedByEveryCommandThatLetsRocksMeetThem) {
    const SampleProject project;
    add_nets(project);
    const std::string rocks = "run scenario.ini --quiet --set release.rocks=100 ";
    ASSERT_EQ(call(project, rocks + "--set nets.keep_paths=yes --out out").code, 0);
    project.write("twice.csv",
                  "name,height_m,capacity_kj,wkt\n"
                  "a,3,50,\"LINESTRING (1098 2005, 1098 2095)\"\n"
                  "b,5,900,\"LINESTRING (1098 2020, 1098 2060)\"\n");
    for (const std::string command :
         {"check scenario.ini --set nets.file=twice.csv", "run scenario.ini --set nets.file=twice.csv",
          "net try out --nets twice.csv"}) {
        const Outcome outcome = call(project, command);
        EXPECT_EQ(outcome.code, 4) << command;
        EXPECT_NE(outcome.err.find("net 'b' in the place of net 'a' of line 2 over 40 m"), std::string::npos)
            << outcome.err;
    }
    EXPECT_EQ(call(project, "net place out --nets twice.csv --distances 10").code, 0);
}

}  // namespace
}  // namespace coupling::nets_test
