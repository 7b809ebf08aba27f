#include "coupling/inputs/works/work_places.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/coupling/inputs/opened.hpp"

namespace coupling::work_places_test {
namespace {

constexpr const char* work_header =
    "name,kind,height_m,width_m,uphill_face_deg,downhill_face_deg,capacity_kj,wkt\n";

Opened open_with_works(const std::string& rows) {
    const SampleProject project;
    project.write("works.csv", work_header + rows);
    project.replace("scenario.ini", "[targets]", "[works]\nfile = works.csv\n[targets]");
    return open(project);
}

constexpr const char* across = "\"LINESTRING (1080 2030, 1080 2070)\"\n";

TEST(Works, BecomeAPartOfTheGround) {
    const Opened without = open_with_works(std::string{"a,wall,3,,,,500,"} + across);
    const Opened with = open_with_works(std::string{"a,dam,4,2,60,56,,"} + across);
    ASSERT_TRUE(without.site) << without.errors;
    ASSERT_TRUE(with.site) << with.errors;
    const Eigen::Vector2d origin_m = with.site->origin_m();
    const auto height_m = [&](const Opened& opened, double x, double y) {
        return opened.site->slope.terrain.height_m(x - origin_m.x(), y - origin_m.y()).value();
    };
    EXPECT_NEAR(height_m(with, 1080.0, 2050.0) - height_m(without, 1080.0, 2050.0), 4.0, 1e-9);
    EXPECT_NEAR(height_m(with, 1080.9, 2050.0), height_m(with, 1079.1, 2050.0), 1e-9) << "a level crown";
    EXPECT_NEAR(height_m(with, 1060.0, 2050.0), height_m(without, 1060.0, 2050.0), 1e-9);
    EXPECT_NEAR(height_m(with, 1080.0, 2080.0), height_m(without, 1080.0, 2080.0), 1e-9);
    EXPECT_EQ(with.site->sources.size(), without.site->sources.size());
    const WorkRecord& dam = with.site->works.at(0);
    EXPECT_GT(dam.volume_m3, 40.0 * 2.0 * 4.0);
    const std::vector<rockfall::Net> standing = with.site->standing_nets();
    ASSERT_EQ(standing.size(), 1U);
    EXPECT_EQ(standing[0].line_m, dam.counted_m);
    EXPECT_EQ(standing[0].height_m, 0.0) << "it counts and holds nothing";
    EXPECT_EQ(without.site->standing_nets()[0].capacity_j, 500e3);
}

TEST(Works, OfAnyKindTellWhatTheyNeedAndWhatMeansNothing) {
    const auto errors = [](const std::string& rows) { return open_with_works(rows).errors; };
    EXPECT_NE(errors(std::string{"a,dam,4,,60,56,,"} + across).find("dam without width_m"),
              std::string::npos);
    EXPECT_NE(errors(std::string{"a,dam,4,2,60,56,100,"} + across).find("capacity_kj of a dam"),
              std::string::npos);
    EXPECT_NE(errors(std::string{"a,wall,3,1,,,,"} + across).find("width_m of a wall"), std::string::npos);
    EXPECT_NE(errors(std::string{"a,gallery,,,,,,"} + across).find("a line of a gallery"), std::string::npos);
    EXPECT_NE(errors(std::string{"a,damm,4,2,60,56,,"} + across).find("dam"), std::string::npos);
    EXPECT_NE(errors(std::string{"a,dam,-4,2,60,56,,"} + across).find("height_m"), std::string::npos);
    EXPECT_NE(errors(std::string{"a,dam,4,2,60,30,,"} + across).find("meets no ground"), std::string::npos);
    EXPECT_NE(errors(std::string{"a,dam,4,2,60,56,,"} + across + "b,dam,4,2,60,56,," + across)
                  .find("overlaps dam 'a'"),
              std::string::npos);
    EXPECT_NE(errors("a,wall,3,,,,,\"LINESTRING (1080 2030, 1080 2170)\"\n").find("leaves the terrain"),
              std::string::npos);
}

TEST(Works, CoverLinesWithRoofs) {
    const Opened opened = open_with_works(
        "g,gallery,,,,,300,\"POLYGON ((1095 2005, 1114 2005, 1114 2050, 1095 2050, 1095 2005))\"\n");
    ASSERT_TRUE(opened.site) << opened.errors;
    std::size_t covered = 0;
    for (const rockfall::Target& target : opened.site->targets) {
        EXPECT_TRUE(!target.is_area || target.roofs.empty());
        covered += target.roofs.size();
        for (const rockfall::Roof& roof : target.roofs) {
            EXPECT_EQ(roof.capacity_j, 300e3);
        }
    }
    EXPECT_EQ(covered, 1U);
}

}  // namespace
}  // namespace coupling::work_places_test
