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
        row.crossing.first = true;
    }
    return net_figures(std::vector<NetRecord>(1), rows, rockfall::Cover::bare, 1000, 0.95)[0];
}

NetRecord lower() {
    NetRecord net;
    net.name = "lower";
    return net;
}

TEST(NeedInWords, NamesClassAndHeightOrWhyThereIsNone) {
    EXPECT_EQ(need_in_words(held(100, 2.0F), 0.95), "class 0 (100 kJ), 2.0 m high");
    EXPECT_EQ(need_in_words(held(19, 2.0F), 0.95),
              "too few rocks reach it for an estimate: 19 of at least 20");
    EXPECT_EQ(need_in_words(held(0, 2.0F), 0.95), "–");
    EXPECT_NE(need_in_words(held(100, 20.0F), 0.95).find("no usual net is that high"), std::string::npos);
}

TEST(NetInWords, TellsOfRocksThatAreNotKnown) {
    NetFigures figures = held(0, 0.0F);
    EXPECT_EQ(in_words(lower(), figures, 0.95), "lower, bare slope: 0 of 1000 rocks reach it");
    figures.inexact = 800;
    EXPECT_EQ(in_words(lower(), figures, 0.95),
              "lower, bare slope: at least 0 of 1000 rocks reach it (800 rocks that break through "
              "another net are not counted here: run the scenario to include them)");
    EXPECT_NE(in_words(lower(), held(5, 1.0F), 0.95).find("5 of 1000 rocks reach it; it holds 100.0"),
              std::string::npos);
}

}  // namespace
}  // namespace coupling::net_words_test
