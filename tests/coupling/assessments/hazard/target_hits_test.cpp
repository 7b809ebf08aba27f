#include "coupling/assessments/hazard/target_hits.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "coupling/results/figures/figures.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::hazard::target_hits_test {
namespace {

/// A return period with a row of 200 rocks and one of 10, of which 20 and 2 hit the road with 10 kJ, and one
/// more of each with 500 kJ.
struct Period {
    Period() {
        opened = open(project);
        rockfall::StartLaw small;
        small.diameter = rockfall::DiameterLaw::fixed(0.3);
        rockfall::StartLaw large;
        large.diameter = rockfall::DiameterLaw::fixed(1.2);
        std::vector<rockfall::ReleaseSource>& sources = opened.site->sources;
        sources.resize(2, sources.front());
        sources[0].first_rock = 0;
        sources[0].rocks = 200;
        sources[0].own_start = std::make_shared<const rockfall::StartLaw>(small);
        sources[1].first_rock = 200;
        sources[1].rocks = 10;
        sources[1].own_start = std::make_shared<const rockfall::StartLaw>(large);
        std::filesystem::create_directories(project.folder() / "run" / "tables");
        project.write("run/tables/targets.csv",
                      "target_id,cover,rocks,reached,energy_95_kj,energy_max_kj,above_30_kj_rocks,"
                      "above_300_kj_rocks\nroad,bare,210,24,400,500,2,2\nhouse,bare,210,0,,,0,0\n");
    }
    void add_arrivals() const {
        std::string rows = "rock,target_id,cover,energy_kj\n";
        for (int i = 0; i < 21; ++i) {
            rows += std::to_string(i) + ",road,bare," + (i < 20 ? "10" : "500") + "\n";
        }
        for (int i = 200; i < 203; ++i) {
            rows += std::to_string(i) + ",road,bare," + (i < 202 ? "10" : "500") + "\n";
        }
        project.write("run/tables/arrivals.csv", rows);
    }
    [[nodiscard]] TargetHits at(std::size_t target) const {
        const hits::BlockRows blocks{opened.site->sources, {}};
        return hits_of(project.folder() / "run", *opened.site, blocks, Matrix::shipped(),
                       HazardEnergy::p95)[target][index_of(Cover::bare)];
    }

    SampleProject project;
    Opened opened;
};

/// Rocks of a row with few of them weigh more, so that a frequency rests on fewer than hit.
TEST(TargetHits, CountsRocksOfOneWeight) {
    const Period period;
    period.add_arrivals();
    const TargetHits road = period.at(0);
    ASSERT_EQ(road.rocks_above, (std::vector<std::uint64_t>{24, 2, 2}));
    EXPECT_DOUBLE_EQ(road.at_place.per_release_above[0], 21.0 / 200.0 + 3.0 / 10.0);
    // (21/200 + 3/10)² / (21/200² + 3/10²) = 5.4; (1/200 + 1/10)² / (1/200² + 1/10²) = 1.1
    EXPECT_EQ(road.even_rocks_above, (std::vector<std::uint64_t>{5, 1, 1}));
    EXPECT_EQ(period.at(1).even_rocks_above, (std::vector<std::uint64_t>{0, 0, 0}));
}

/// Without arrivals.csv all hits are of one row.
TEST(TargetHits, WeighsAllAlikeWhereRowsAreNotKnown) {
    const Period period;
    const TargetHits road = period.at(0);
    EXPECT_EQ(road.rocks_above, (std::vector<std::uint64_t>{24, 2, 2}));
    EXPECT_EQ(road.even_rocks_above, road.rocks_above);
    EXPECT_EQ(period.at(1).even_rocks_above, (std::vector<std::uint64_t>{0, 0, 0}));
}

}  // namespace
}  // namespace coupling::hazard::target_hits_test
