#include "coupling/results/report/map/map_sheet.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/results/report/map/blocks.hpp"
#include "coupling/results/report/map/map_key.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/writing_language.hpp"
#include "tests/coupling/results/markup_checks.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::report::map_sheet_test {
namespace {

TEST(InBlocks, ShowsTheValueFarthestFromZero) {
    config::Raster<float> raster{{3, 2, 0.0, 0.0, 1.0, 1.0}, std::nanf("")};
    raster.values = {1.0F, -5.0F, std::nanf(""), 2.0F, std::nanf(""), std::nanf("")};
    const config::Raster<float> blocks = in_blocks(raster, 2);
    EXPECT_EQ(blocks.frame.columns, 2);
    EXPECT_EQ(blocks.frame.rows, 1);
    EXPECT_EQ(blocks.values[0], -5.0F);
    EXPECT_TRUE(std::isnan(blocks.values[1]));
}

TEST(MapSheet, DrawsSmallGridsCellByCellAndLargeOnesInBlocks) {
    small_runs::SmallRun run;
    EXPECT_EQ(MapSheet{run.site}.block(), 1);
    run.site.map_frame.columns = 1401;
    EXPECT_EQ(MapSheet{run.site}.block(), 3);
}

TEST(MapSheet, DefinesHillshadeSourcesAndTargetsOnce) {
    const small_runs::SmallRun run;
    const std::string definitions = MapSheet{run.site}.definitions();
    for (const char* name :
         {"id=\"shade\"", "id=\"sources\"", "id=\"targets\"", "data:image/png;base64,iVBORw0KGgo"}) {
        EXPECT_NE(definitions.find(name), std::string::npos) << name;
    }
    // The source cell 30-40 m east, 70-80 m north of the corner lies in the fourth column of the first row.
    EXPECT_NE(definitions.find("M375 0l125 0"), std::string::npos) << definitions;
    EXPECT_EQ(text_checks::markup_fault(definitions), "");
}

TEST(MapSheet, FigureHasTitleNorthScaleCoordinatesAndNames) {
    const small_runs::SmallRun run;
    const std::string figure =
        MapSheet{run.site}.figure({"Title", "Label", "<g></g>", "", "Caption"}, MapSize::half);
    for (const char* text :
         {">Title<", ">N<", ">20 m<", "177\u202f020", "Road &amp; &lt;bridge&gt;", ">House<", "Caption"}) {
        EXPECT_NE(figure.find(text), std::string::npos) << text;
    }
    EXPECT_EQ(text_checks::markup_fault(figure), "");
}

/// On each map that has names, and not on others.
TEST(MapSheet, CountsTheNamesThatHaveNoRoomInTheCaption) {
    small_runs::SmallRun run;
    const std::size_t before = run.site.targets.size();
    const rockfall::Target house = run.site.targets.back();
    for (int i = 0; i < 20; ++i) {
        run.site.targets.push_back(house);
    }
    const MapContent content{"Title", "Label", "", "", "Caption."};
    const MapSheet sheet{run.site};
    const std::string large = sheet.figure(content, MapSize::half);
    std::size_t written = 0;
    for (std::size_t at = large.find("class=\"name\""); at != std::string::npos;
         at = large.find("class=\"name\"", at + 1)) {
        ++written;
    }
    const std::size_t left_out = before + 20 - written;
    EXPECT_GT(left_out, 1U);
    EXPECT_NE(
        large.find("Caption. " + std::to_string(left_out) + " targets have no name on this map: no room."),
        std::string::npos)
        << large;
    EXPECT_EQ(sheet.figure(content, MapSize::third).find("no room"), std::string::npos);
    const small_runs::SmallRun few;
    EXPECT_EQ(MapSheet{few.site}.figure(content, MapSize::half).find("no room"), std::string::npos);
}

TEST(MapSheet, PathsRunInTheColourOfTheirEnergy) {
    small_runs::SmallRun run;
    run.fall(1);
    const MapSheet sheet{run.site};
    const std::string paths =
        sheet.paths(std::array{static_cast<const rockfall::PathRecord*>(&run.paths[0])});
    // 1 to 50 kJ on the first stretch (30 to 100 kJ), up to 400 kJ on the second (300 to 1000 kJ).
    EXPECT_NE(paths.find("class=\"class1\" d=\"M438 63"), std::string::npos) << paths;
    EXPECT_NE(paths.find("class=\"class3\" d=\"M450 500"), std::string::npos) << paths;
}

TEST(MapSheet, ShowsAPartOfTheMapAtTheSameScaleOfMetres) {
    const small_runs::SmallRun run;
    const MapSheet part{run.site, {2, 1, 4, 6}};
    // Stems at 25, 35 and 45 m east, 45 m north: 5, 15 and 25 of 40 m from the western edge of the part, 25
    // of 60 m from its northern one.
    const std::string definitions = part.definitions();
    for (const char* dot : {"M125 625h0", "M375 625h0", "M625 625h0"}) {
        EXPECT_NE(definitions.find(dot), std::string::npos) << dot << definitions;
    }
    EXPECT_NE(part.figure({"Title", "Label", "", "", ""}, MapSize::half).find("height=\"1500\""),
              std::string::npos);
    EXPECT_EQ(text_checks::markup_fault(definitions), "");
}

TEST(MapSheet, DrawsContoursAtRoundHeights) {
    const small_runs::SmallRun run;
    const MapSheet sheet{run.site};
    // The slope rises evenly by 0.75 to the north: a contour every 5 m of height lies 6.67 m from the next.
    EXPECT_EQ(sheet.contour_step_m(), 5.0);
    EXPECT_NE(sheet.definitions().find("class=\"contour\" d=\"M"), std::string::npos);
}

/// In each language caption and key name all that is drawn, and nothing else.
TEST(MapKey, NamesWhatIsDrawn) {
    const auto count_of = [](const std::string& text, const std::string& part) {
        std::size_t count = 0;
        for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
            ++count;
        }
        return count;
    };
    for (const config::Language language :
         {config::Language::en, config::Language::de, config::Language::fr, config::Language::it}) {
        const WritingLanguage writing{language};
        for (int flags = 0; flags < 16; ++flags) {
            const OnMaps drawn{(flags & 1) != 0, (flags & 2) != 0, (flags & 4) != 0, (flags & 8) != 0};
            const std::size_t shown = static_cast<std::size_t>(drawn.sources) + (drawn.targets ? 1 : 0) +
                                      (drawn.nets ? 1 : 0) + (drawn.works ? 1 : 0);
            EXPECT_EQ(count_of(map_key(drawn), "<li>"), shown);
            for (const bool more : {false, true}) {
                const std::string lines = lines_in_words(drawn, {more, more});
                EXPECT_EQ(count_of(lines, "."), shown) << lines;
                EXPECT_EQ(lines.find(page_text("Blue broken lines: nets.")) != std::string::npos, drawn.nets);
                EXPECT_EQ(lines.find(page_text("Blue unbroken lines: dams, ditches, walls and galleries.")) !=
                              std::string::npos,
                          drawn.works);
            }
        }
    }
}

}  // namespace
}  // namespace coupling::report::map_sheet_test
