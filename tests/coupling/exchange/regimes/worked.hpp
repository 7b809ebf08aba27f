#pragma once

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "coupling/exchange/regimes/apply.hpp"
#include "tests/coupling/exchange/regimes/regime_forest.hpp"

namespace coupling {

/// A regime of one row at work in one year.
struct Worked {
    explicit Worked(const std::string& table, forest::Stand stand_in = spruce_stand(6), int year = 0)
        : before_m3{volume_m3(stand_in)}, before_trees{stand_in.trees().size()}, stand{std::move(stand_in)} {
        for (const forest::Tree& tree : stand.trees()) {
            patch_of[tree.id] = tree.patch;
        }
        report = apply(regime_of(table, stand.grid()), year, stand, species_table(), state, {1, 0});
    }

    /// What the report says of a cut is what the stand lost.
    void expect_cut_is_accounted_for() const {
        ASSERT_EQ(report.entries.size(), 1U);
        const Entry& entry = report.entries[0];
        EXPECT_FALSE(entry.found_nothing());
        EXPECT_NEAR(entry.taken_m3 + entry.left_m3, before_m3 - volume_m3(stand), 1e-6);
        EXPECT_EQ(entry.stems, static_cast<double>(before_trees - stand.trees().size()));
        EXPECT_EQ(entry.stems,
                  static_cast<double>(stand.balance().stems_out[forest::index_of(forest::Cause::felled)]));
        EXPECT_EQ(report.timber.total().taken_m3, entry.taken_m3);
        EXPECT_TRUE(books_close(stand));
        std::map<forest::TreeId, forest::PatchId> gone = patch_of;
        for (const forest::Tree& tree : stand.trees()) {
            gone.erase(tree.id);
        }
        std::set<forest::PatchId> patches;
        for (const auto& [tree, patch] : gone) {
            patches.insert(patch);
        }
        EXPECT_EQ(entry.cut_patches, (std::vector<forest::PatchId>{patches.begin(), patches.end()}))
            << "patches that lost a tree, rising";
    }

    std::map<forest::TreeId, forest::PatchId> patch_of;  ///< before the work
    double before_m3;
    std::size_t before_trees;
    forest::Stand stand;
    RegimeState state;
    RegimeReport report;
};

}  // namespace coupling
