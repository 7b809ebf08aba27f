#include "coupling/results/report/map/labels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "config/random/stream.hpp"
#include "coupling/results/report/map/map_furniture.hpp"

namespace coupling::report::labels_test {
namespace {

const NamedShape road{"road", {{{0.0, 500.0}, {500.0, 500.0}, {1000.0, 500.0}}}};

TEST(PlaceNames, WritesTheNameOfALineAboveItsMiddle) {
    const NamePlace place = place_names({road}, {}, 20.0, 1000.0, 1000.0).front();
    EXPECT_DOUBLE_EQ(place.x, 500.0);
    EXPECT_LT(place.y, 500.0);
    EXPECT_GT(place.y, 450.0);
}

TEST(PlaceNames, GoesBelowWhereThereIsNoRoomAbove) {
    const NamedShape high{"road", {{{0.0, 5.0}, {1000.0, 5.0}}}};
    EXPECT_GT(place_names({high}, {}, 20.0, 1000.0, 1000.0).front().y, 15.0);
}

TEST(PlaceNames, KeepsANameOffAnotherShape) {
    const NamedShape house{
        "house", {{{495.0, 502.0}, {505.0, 502.0}, {505.0, 512.0}, {495.0, 512.0}, {495.0, 502.0}}}};
    const NamePlace place = place_names({road, house}, {}, 20.0, 1000.0, 1000.0).back();
    EXPECT_GT(place.y - 0.85 * 20.0, 500.0) << "above it runs the road";
}

TEST(PlaceNames, KeepsNamesApart) {
    const NamedShape path{"path", {{{0.0, 530.0}, {500.0, 530.0}, {1000.0, 530.0}}}};
    const std::vector<NamePlace> places = place_names({road, path}, {}, 20.0, 1000.0, 1000.0);
    EXPECT_TRUE(std::abs(places[0].y - places[1].y) > 20.0 || std::abs(places[0].x - places[1].x) > 44.0);
}

TEST(PlaceNames, KeepsANameOffWhatIsTaken) {
    // Distance marks above the road, every tenth of it: a name above stands over them or below.
    std::vector<LetteredBox> marks;
    for (double x = 0.0; x < 1000.0; x += 100.0) {
        marks.push_back(box_of("1200", x + 8.0, 493.0, 15.0));
    }
    for (const char* name : {"road", "a long name of a road", "Straße über die Brücke"}) {
        const NamedShape named{name, road.parts};
        const NamePlace place = place_names({named}, marks, 20.0, 1000.0, 1000.0).front();
        const double half = 0.5 * (box_of(name, 0.0, 0.0, 20.0).east);
        const LetteredBox box = box_of(name, place.x - half, place.y, 20.0);
        for (const LetteredBox& mark : marks) {
            EXPECT_FALSE(box.west < mark.east && mark.west < box.east && box.north < mark.south &&
                         mark.north < box.south)
                << name << " at " << place.x << " " << place.y;
        }
    }
}

/// Of few names, too: those that would cover another one are left out, however many others have room.
TEST(PlaceNames, HidesNamesThatWouldCoverAnother) {
    std::vector<NamedShape> houses;
    for (int i = 0; i < 9; ++i) {
        const double x = 460.0 + 9.0 * i;
        const double y = 500.0 - 5.0 * (i % 3);
        houses.push_back({"Haus am Hang " + std::to_string(i),
                          {{{x, y}, {x + 8.0, y}, {x + 8.0, y + 8.0}, {x, y + 8.0}, {x, y}}}});
    }
    const std::vector<NamePlace> places = place_names(houses, {}, 20.0, 1000.0, 1000.0);
    std::vector<LetteredBox> written;
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_FALSE(places[i].is_free && places[i].is_hidden);
        if (!places[i].is_hidden) {
            const double half = 0.5 * box_of(houses[i].name, 0.0, 0.0, 20.0).east;
            written.push_back(box_of(houses[i].name, places[i].x - half, places[i].y, 20.0));
        }
    }
    EXPECT_GT(written.size(), 2U);
    EXPECT_LT(written.size(), places.size());
    for (std::size_t i = 0; i < written.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_FALSE(written[i].west < written[k].east && written[k].west < written[i].east &&
                         written[i].north < written[k].south && written[k].north < written[i].south)
                << i << ' ' << k;
        }
    }
}

TEST(PlaceNames, SaysOfEachNameWhetherItHasRoom) {
    // Houses side by side: a name is wider than ten of them, so that few have room.
    std::vector<NamedShape> houses;
    for (int i = 0; i < 100; ++i) {
        const double x = 10.0 * i;
        houses.push_back(
            {"House 100", {{{x, 500.0}, {x + 8.0, 500.0}, {x + 8.0, 508.0}, {x, 508.0}, {x, 500.0}}}});
    }
    const std::vector<NamePlace> places = place_names(houses, {}, 20.0, 1000.0, 1000.0);
    std::vector<LetteredBox> free;
    for (const NamePlace& place : places) {
        if (place.is_free) {
            const double half = 0.5 * box_of("House 100", 0.0, 0.0, 20.0).east;
            free.push_back(box_of("House 100", place.x - half, place.y, 20.0));
        }
    }
    EXPECT_GT(free.size(), 8U);
    EXPECT_LT(free.size(), 60U);
    for (std::size_t i = 0; i < free.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_FALSE(free[i].west < free[j].east && free[j].west < free[i].east &&
                         free[i].north < free[j].south && free[j].north < free[i].south);
        }
    }
}

std::size_t texts_in(const std::string& svg) {
    std::size_t count = 0;
    for (std::size_t at = svg.find("<text"); at != std::string::npos; at = svg.find("<text", at + 1)) {
        ++count;
    }
    return count;
}

/// Houses in rows of ten, `gap` apart.
std::vector<NamedShape> village(int houses, double west, double gap) {
    std::vector<NamedShape> shapes;
    for (int i = 0; i < houses; ++i) {
        const double x = west + gap * (i % 10);
        const double y = 50.0 + gap * (i / 10);
        shapes.push_back({"House 100", {{{x, y}, {x + 8.0, y}, {x + 8.0, y + 8.0}, {x, y + 8.0}, {x, y}}}});
    }
    return shapes;
}

TEST(WriteNames, WritesOrCountsEachNameOnTheSheet) {
    for (const int houses : {1, 2, 7, 10, 11, 30, 100}) {
        for (const double gap : {0.0, 10.0, 45.0, 90.0}) {
            const WrittenNames written = write_names(village(houses, 20.0, gap), {}, 20.0, 1000.0, 1000.0);
            EXPECT_EQ(texts_in(written.svg) + written.left_out, static_cast<std::size_t>(houses))
                << houses << " houses, " << gap;
        }
    }
    EXPECT_EQ(write_names(village(5, 20.0, 190.0), {}, 20.0, 1000.0, 1000.0).left_out, 0U);
    EXPECT_GT(write_names(village(100, 20.0, 10.0), {}, 20.0, 1000.0, 1000.0).left_out, 40U);
}

/// What the map does not show misses no name.
TEST(WriteNames, DoesNotCountWhatLiesOffTheSheet) {
    EXPECT_EQ(write_names(village(100, 5000.0, 10.0), {}, 20.0, 1000.0, 1000.0).left_out, 0U);
}

TEST(PlaceNames, HidesWhatIsTooLongForTheSheet) {
    const std::vector<NamePlace> places = place_names({road}, {}, 500.0, 1000.0, 1000.0);
    ASSERT_EQ(places.size(), 1U);
    EXPECT_TRUE(places.front().is_hidden);
    EXPECT_EQ(write_names({road}, {}, 500.0, 1000.0, 1000.0).left_out, 1U);
}

/// Houses anywhere on and around sheets of several shapes: what is written lies within the sheet, apart from
/// the furniture, and what is not written is counted.
TEST(PlaceNames, NeverLeaveTheSheetNorCoverTheFurniture) {
    config::RandomStream stream{{.seed = 8}, config::Purpose::release};
    constexpr double lettering = 20.0;
    constexpr double width = 1000.0;
    std::size_t written = 0;
    std::size_t at_the_rim = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const double height = 150.0 + 1000.0 * stream.uniform();
        const SheetSize sheet{width, height, 1.0, lettering};
        std::vector<NamedShape> shapes;
        const int houses = 1 + static_cast<int>(12.0 * stream.uniform());
        for (int i = 0; i < houses; ++i) {
            const double x = 1.2 * width * stream.uniform() - 0.1 * width;
            const double y = 1.2 * height * stream.uniform() - 0.1 * height;
            std::string name = "Mühleweg " + std::to_string(i);
            name.resize(name.size() + static_cast<std::size_t>(40.0 * stream.uniform()), 'm');
            shapes.push_back({name, {{{x, y}, {x + 12.0, y}, {x + 12.0, y + 9.0}, {x, y + 9.0}, {x, y}}}});
        }
        const std::vector<LetteredBox> furniture = furniture_boxes(sheet);
        const std::vector<NamePlace> places = place_names(shapes, furniture, lettering, width, height);
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            if (places[i].is_hidden) {
                continue;
            }
            const double half = 0.5 * box_of(shapes[i].name, 0.0, 0.0, lettering).east;
            const LetteredBox box = box_of(shapes[i].name, places[i].x - half, places[i].y, lettering);
            EXPECT_TRUE(box.west >= -1e-9 && box.east <= width + 1e-9 && box.north >= -1e-9 &&
                        box.south <= height + 1e-9)
                << shapes[i].name << " at " << places[i].x << " " << places[i].y << " of " << height;
            for (const LetteredBox& of : furniture) {
                EXPECT_FALSE(box.west < of.east && of.west < box.east && box.north < of.south &&
                             of.north < box.south)
                    << shapes[i].name << " over the scale bar or the arrow";
            }
            ++written;
            at_the_rim += box.west < 1.0 || box.east > width - 1.0 ? 1U : 0U;
        }
    }
    EXPECT_GT(written, 500U);
    EXPECT_GT(at_the_rim, 20U) << "houses at the rim keep their names";
}

}  // namespace
}  // namespace coupling::report::labels_test
