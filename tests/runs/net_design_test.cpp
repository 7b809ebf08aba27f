// One design for a net, wherever it is shown, and the same again from the tables.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "tests/runs/nets.hpp"
#include "tests/runs/years.hpp"

namespace coupling::net_design_runs_test {
namespace {

constexpr const char* rocks = "run scenario.ini --quiet --set release.rocks=2000 ";
constexpr const char* own_rule =
    "--set design.rule=own --set design.energy_factor=1.2 --set design.height_factor=1.1 "
    "--set design.freeboard_m=0.5 ";

/// The 95th percentile as an order statistic.
double percentile_95(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto rank = static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(values.size()) - 1e-9));
    return values.at(rank - 1);
}

struct Crossings {
    std::vector<double> energies_kj;
    std::vector<double> centres_m;
    std::vector<double> tops_m;
};

/// What first crosses a net on a slope, by "net cover".
std::map<std::string, Crossings> crossings_in(const config::Table& table) {
    std::map<std::string, Crossings> all;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "first") == "yes") {
            Crossings& of = all[table.text(row, "net") + " " + table.text(row, "cover")];
            of.energies_kj.push_back(number(table, row, "energy_kj"));
            of.centres_m.push_back(number(table, row, "height_m"));
            of.tops_m.push_back(number(table, row, "height_m") + number(table, row, "radius_m"));
        }
    }
    return all;
}

TEST(NetDesign, FollowsFromTheTableOfCrossings) {
    const SampleProject project;
    add_nets(project);
    for (const bool own : {false, true}) {
        const std::string out = own ? "own" : "none";
        ASSERT_EQ(call(project, rocks + std::string{own ? own_rule : ""} + "--out " + out).code, 0);
        const config::Table nets = table(project, out + "/tables/nets.csv");
        const auto crossings = crossings_in(table(project, out + "/tables/net_crossings.csv"));
        std::size_t designs = 0;
        for (std::size_t row = 0; row < nets.rows(); ++row) {
            const Crossings& of = crossings.at(nets.text(row, "net") + " " + nets.text(row, "cover"));
            if (of.energies_kj.size() < 20) {
                EXPECT_EQ(nets.text(row, "sold_height_m"), "");
                continue;
            }
            ++designs;
            const double energy_kj = percentile_95(of.energies_kj);
            const double height_m = percentile_95(of.tops_m);
            EXPECT_NEAR(number(nets, row, "percentile_energy_kj"), energy_kj, 0.002);
            EXPECT_NEAR(number(nets, row, "percentile_height_m"), height_m, 0.002);
            EXPECT_NEAR(number(nets, row, "height_95_m"), height_m, 0.002);
            EXPECT_NEAR(number(nets, row, "design_energy_kj"), (own ? 1.2 : 1.0) * energy_kj, 0.003);
            EXPECT_NEAR(number(nets, row, "design_height_m"), own ? 1.1 * height_m + 0.5 : height_m, 0.003);
            // All rocks have a radius of 0.25 m.
            EXPECT_GE(number(nets, row, "design_height_m"), percentile_95(of.centres_m) + 0.25 - 0.002);
            EXPECT_GE(number(nets, row, "sold_height_m"), number(nets, row, "design_height_m"));
            EXPECT_GE(number(nets, row, "design_capacity_kj"), number(nets, row, "design_energy_kj"));
            EXPECT_EQ(number(nets, row, "design_held") + number(nets, row, "design_over") +
                          number(nets, row, "design_through"),
                      static_cast<double>(of.energies_kj.size()));
        }
        EXPECT_GE(designs, 2U);
        const config::Table needs = table(project, out + "/tables/net_needs.csv");
        for (std::size_t row = 0; row < needs.rows(); ++row) {
            for (std::size_t net = 0; net < nets.rows(); ++net) {
                if (needs.text(row, "recommended") == "yes" &&
                    needs.text(row, "net") == nets.text(net, "net") &&
                    needs.text(row, "cover") == nets.text(net, "cover")) {
                    EXPECT_EQ(needs.text(row, "class"), nets.text(net, "design_class"));
                    EXPECT_EQ(number(needs, row, "height_m"), number(nets, net, "sold_height_m"));
                    EXPECT_EQ(needs.text(row, "held_percent"), nets.text(net, "design_held_percent"));
                }
            }
        }
    }
}

/// The net that `net place` finds is the one that a run with it and `net try` ask for.
TEST(NetDesign, IsTheSameWhereANetIsPlacedRunAndTried) {
    const SampleProject project;
    ASSERT_EQ(call(project, rocks + std::string{own_rule} + "--set nets.keep_paths=yes --out out").code, 0);
    const Outcome placed = call(project, "net place out --nets targets.csv --distances 10,20");
    ASSERT_EQ(placed.code, 0) << placed.err;
    const std::string nets_file = "out/net_place/nets.csv";
    ASSERT_EQ(
        call(project, rocks + std::string{own_rule} + "--set nets.file=" + nets_file + " --out with").code,
        0);
    ASSERT_EQ(call(project, "net try out --nets " + nets_file + " --out tried").code, 0);

    const config::Table given = table(project, nets_file);
    ASSERT_EQ(given.rows(), 1U);
    const config::Table candidates = table(project, "out/net_place/net_candidates.csv");
    const config::Table with = table(project, "with/tables/nets.csv");
    const config::Table tried = table(project, "tried/nets.csv");
    ASSERT_EQ(with.rows(), 2U);
    ASSERT_EQ(tried.rows(), 2U);
    for (std::size_t row = 0; row < 2; ++row) {
        const std::string& cover = with.text(row, "cover");
        std::size_t best = candidates.rows();
        for (std::size_t i = 0; i < candidates.rows(); ++i) {
            best = candidates.text(i, "best") == "yes" && candidates.text(i, "cover") == cover ? i : best;
        }
        ASSERT_LT(best, candidates.rows());
        EXPECT_EQ(candidates.text(best, "reached"), with.text(row, "reached"));
        for (const char* column : {"design_class", "design_capacity_kj", "sold_height_m", "design_held",
                                   "design_over", "design_through"}) {
            EXPECT_EQ(tried.text(row, column), with.text(row, column)) << cover << ' ' << column;
            EXPECT_EQ(candidates.text(best, column), with.text(row, column)) << cover << ' ' << column;
        }
        // nets.csv has corners to the millimetre: its line lies that much beside that of the candidate.
        for (const char* column :
             {"percentile_energy_kj", "design_energy_kj", "percentile_height_m", "design_height_m"}) {
            EXPECT_EQ(tried.text(row, column), with.text(row, column)) << cover << ' ' << column;
            EXPECT_NEAR(number(candidates, best, column), number(with, row, column),
                        2e-3 * number(with, row, column))
                << cover << ' ' << column;
        }
        if (cover == "forest") {  // the slope by which it was placed
            EXPECT_EQ(with.text(row, "design_class"), given.text(0, "class"));
            EXPECT_EQ(with.text(row, "class"), given.text(0, "class"));
            EXPECT_EQ(number(with, row, "sold_height_m"), number(given, 0, "height_m"));
            EXPECT_EQ(with.text(row, "held"), with.text(row, "design_held"));
            const std::string height = config::to_text(number(given, 0, "height_m"));
            const std::string in_words = "), " + height + " m high";
            for (const char* page : {"out/net_place/report.html", "with/report.html"}) {
                EXPECT_NE(project.read(page).find(in_words), std::string::npos) << page << in_words;
                EXPECT_NE(project.read(page).find("energy × 1.2, height × 1.1 plus 0.5 m of freeboard"),
                          std::string::npos)
                    << page;
            }
        }
    }
}

/// Without a rule the page says that nothing was added.
TEST(NetDesign, SaysThatNoFactorsAreAdded) {
    const SampleProject project;
    add_nets(project);
    const Outcome run = call(project, "run scenario.ini --set release.rocks=500 --out out");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.out.find("freeboard are added: give those of your guideline"), std::string::npos)
        << run.out;
    EXPECT_NE(project.read("out/report.html").find("Neither partial factors nor a freeboard are added"),
              std::string::npos);
}

}  // namespace
}  // namespace coupling::net_design_runs_test
