#include "coupling/assessments/today/unreached_today.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/coupling/inputs/opened.hpp"

namespace coupling::unreached_today_test {
namespace {

/// The sample with a net, and tallies of a hundred rocks that reached nothing.
struct Unreached {
    Unreached() {
        project.write("nets.csv", "name,height_m,class,wkt\nlow,3,1,\"LINESTRING (1090 2010, 1090 2030)\"\n");
        project.replace("scenario.ini", "[targets]", "[nets]\nfile = nets.csv\n[targets]");
        opened = open(project);
    }
    [[nodiscard]] rockfall::EnsembleTally tally() const {
        rockfall::EnsembleTally total{opened.site->map_frame_on_terrain(), opened.site->targets.size(), 0, 0};
        total.runs[static_cast<std::size_t>(rockfall::Cover::bare)].rocks = 100;
        return total;
    }
    [[nodiscard]] config::Warnings warned(const rockfall::EnsembleTally& total,
                                          const std::vector<NetRow>& crossings) const {
        config::Warnings warnings;
        warn_of_unreached(*opened.site, total, crossings, warnings);
        expect_translated(warnings.all());
        return warnings;
    }

    SampleProject project;
    Opened opened;
};

TEST(UnreachedToday, PutsTheAnswerInQuestionWhereNoTargetIsReached) {
    const Unreached site;
    ASSERT_TRUE(site.opened.site) << site.opened.errors;
    const config::Warnings warnings = site.warned(site.tally(), {});
    ASSERT_EQ(warnings.warnings().size(), site.opened.site->targets.size() + 1);
    EXPECT_EQ(warnings.effects().front(), config::Effect::answer);
    EXPECT_EQ(warnings.warnings().front().find("no rock reaches the target "), 0U);
    EXPECT_EQ(warnings.warnings().back().find("no rock reaches the net 'low': "), 0U);
    EXPECT_NE(warnings.effects().back(), config::Effect::answer);
}

TEST(UnreachedToday, NotesSingleTargetsBesideOthers) {
    const Unreached site;
    ASSERT_TRUE(site.opened.site) << site.opened.errors;
    rockfall::EnsembleTally total = site.tally();
    total.targets[0].by_cover[1].reached = 3;
    NetRow crossing;
    crossing.crossing.net = 0;
    const config::Warnings one = site.warned(total, {crossing});
    EXPECT_TRUE(one.warnings().empty());
    ASSERT_EQ(one.notes().size(), 1U);
    EXPECT_EQ(one.notes()[0].find("no rock reaches the target "), 0U);
    total.targets[1].by_cover[0].reached = 1;
    EXPECT_TRUE(site.warned(total, {crossing}).all().empty());
}

}  // namespace
}  // namespace coupling::unreached_today_test
