#include "rockfall/tally/cell_releases.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <memory>

namespace rockfall::cell_releases_test {
namespace {

ReleaseSource source_of(std::uint32_t rocks, const std::shared_ptr<const StartLaw>& start) {
    ReleaseSource source;
    source.rocks = rocks;
    source.own_start = start;
    return source;
}

TEST(CellReleases, CountRocksFromEachEnergyOn) {
    CellReleases cell;
    cell.add(CellReleases::one_release / 4, 30e3F);
    cell.add(CellReleases::one_release / 4, 29.9e3F);
    cell.add(CellReleases::one_release / 2, 2e6F);
    EXPECT_EQ(cell.per_release(0), 1.0);
    EXPECT_EQ(cell.per_release(1), 0.75);
    EXPECT_EQ(cell.per_release(2), 0.5);
    EXPECT_EQ(cell.per_release(4), 0.5);
}

/// However many rocks are simulated of each start: if all of them pass, each start counts as one rock.
RC_GTEST_PROP(CellReleases, AddUpToTheNumberOfStarts, ()) {
    const auto rocks = *rc::gen::container<std::vector<std::uint32_t>>(6, rc::gen::inRange(1U, 5000U));
    const auto first = std::make_shared<const StartLaw>();
    const auto second = std::make_shared<const StartLaw>();
    std::vector<ReleaseSource> sources;
    for (std::size_t i = 0; i < rocks.size(); ++i) {
        sources.push_back(source_of(rocks[i], i % 3 == 0 ? nullptr : i % 3 == 1 ? first : second));
    }
    const std::vector<std::uint64_t> weights = release_weights(sources);
    CellReleases some;
    CellReleases others;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        for (std::uint32_t k = 0; k < sources[i].rocks; ++k) {
            (k % 2 == 0 ? some : others).add(weights[i], 50e3F);
        }
    }
    some.add(others);
    RC_ASSERT(std::abs(some.per_release(0) - 3.0) < 1e-9);
    RC_ASSERT(some.per_release(1) == some.per_release(0));
    RC_ASSERT(some.weights[2] == 0U);
}

TEST(CellReleases, OfSourcesWithoutRocksWeighNothing) {
    EXPECT_EQ(release_weights(std::vector{source_of(0, nullptr)}), std::vector<std::uint64_t>{0});
}

}  // namespace
}  // namespace rockfall::cell_releases_test
