#include "coupling/assessments/nets/figures/net_words.hpp"

#include <gtest/gtest.h>

namespace coupling::net_words_test {
namespace {

/// The figures of a net that holds `reached` rocks of 10 kJ at some height.
NetFigures held(std::uint64_t reached, float height_m) {
    std::vector<NetRow> rows(reached);
    for (NetRow& row : rows) {
        row.cover = rockfall::Cover::bare;
        row.crossing.energy_j = 1e4F;
        row.crossing.height_m = height_m;
        row.crossing.radius_m = 0.3F;
        row.crossing.first = true;
    }
    return net_figures(std::vector<NetRecord>(1), rows, rockfall::Cover::bare, 1000, {})[0];
}

NetRecord lower() {
    NetRecord net;
    net.name = "lower";
    return net;
}

TEST(NeedInWords, NamesClassAndHeightOrWhyThereIsNone) {
    EXPECT_EQ(need_in_words(held(100, 2.0F), {}), "class 0 (100 kJ), 2.5 m high");
    EXPECT_EQ(need_in_words(held(19, 2.0F), {}), "too few rocks reach it for an estimate: 19 of at least 20");
    EXPECT_EQ(need_in_words(held(0, 2.0F), {}), "–");
    EXPECT_NE(need_in_words(held(100, 20.0F), {}).find("no net on offer is that high"), std::string::npos);
}

TEST(NetInWords, TellsOfRocksThatAreNotKnown) {
    NetFigures figures = held(0, 0.0F);
    EXPECT_EQ(in_words(lower(), figures, {}), "lower, bare slope: 0 of 1\u202f000 rocks reach it");
    figures.inexact = 800;
    EXPECT_EQ(in_words(lower(), figures, {}),
              "lower, bare slope: at least 0 of 1\u202f000 rocks reach it (800 rocks that break through "
              "another net are not counted here: run the scenario to include them)");
    EXPECT_NE(in_words(lower(), held(5, 1.0F), {}).find("5 of 1\u202f000 rocks reach it; it holds 100.0"),
              std::string::npos);
    const std::string line = in_words(lower(), held(100, 2.0F), {});
    EXPECT_NE(line.find("95 % of energies up to 10.0 kJ, of heights of passage up to 2.30 m; design: class 0 "
                        "(100 kJ), 2.5 m high, which would hold 100.0"),
              std::string::npos)
        << line;
}

TEST(DesignRuleInWords, SaysWhatIsAddedAndThatNothingIs) {
    EXPECT_NE(design_rule_in_words({}).find("Neither partial factors nor a freeboard are added"),
              std::string::npos);
    DesignSettings own;
    own.rule = DesignRule::own;
    own.energy_factor = 1.2;
    own.freeboard_m = 0.5;
    own.percentile = 99.0;
    const std::string text = design_rule_in_words(own);
    EXPECT_NE(text.find("99 % of the rocks at a net"), std::string::npos) << text;
    EXPECT_NE(text.find("energy × 1.2, height × 1 plus 0.5 m of freeboard"), std::string::npos) << text;
}

TEST(AsksForMore, ComparesWhatIsOrdered) {
    BarrierDesign with_forest;
    BarrierDesign bare;
    with_forest.capacity_kj = bare.capacity_kj = 500.0;
    with_forest.height_m = bare.height_m = 3.0;
    with_forest.design_energy_kj = 400.0;
    EXPECT_FALSE(asks_for_more(with_forest, bare));
    with_forest.height_m = 3.5;
    EXPECT_TRUE(asks_for_more(with_forest, bare));
    EXPECT_FALSE(asks_for_more(bare, with_forest));
}

}  // namespace
}  // namespace coupling::net_words_test
