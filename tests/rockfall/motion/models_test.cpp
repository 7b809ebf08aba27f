#include "rockfall/motion/models.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "tests/rockfall/slopes.hpp"

namespace rockfall::models_test {
namespace {

TEST(MotionModels, EachIsFullyDescribed) {
    std::set<std::string_view> names;
    std::set<std::string_view> titles;
    for (const MotionModel model : all_models()) {
        const ModelDescription& description = description_of(model);
        ASSERT_FALSE(description.name.empty());
        EXPECT_TRUE(names.insert(description.name).second) << description.name << " a second time";
        EXPECT_TRUE(titles.insert(description.title).second) << description.title << " a second time";
        for (const std::string_view text : {description.title, description.rocks, description.law,
                                            description.source, description.energy}) {
            EXPECT_FALSE(text.empty()) << description.name;
        }
        EXPECT_GT(description.path_bytes_per_m, 0.0) << description.name;
        EXPECT_EQ(description.spins, description.energy.find("rotation") != std::string_view::npos)
            << description.name;
        EXPECT_FALSE(ground_columns_of(model).empty()) << description.name;
    }
}

TEST(MotionModels, AreChosenByTheirPlaceInTheList) {
    ASSERT_EQ(all_models().size(), std::tuple_size_v<MotionModels>);
    for (const MotionModel model : all_models()) {
        const MotionLaws laws{.model = model, .laws = {}};
        EXPECT_EQ(with_model(laws, []<class Model>(std::type_identity<Model>,
                                                   const auto&) { return motion_model<Model>; }),
                  model);
    }
    EXPECT_EQ(MotionLaws{}.model, motion_model<picus::Model>);
}

TEST(MotionModels, GiveTheFigureOfEachGroundColumn) {
    SurfaceType type;
    type.restitution = {0.3, 0.75};
    type.stopping = StopCurve{{{1.0, 0.02}}};
    type.rolling_stops_per_m = StopCurve{{{1.0, 0.004}}};
    type.soil = testing::test_soil();
    MotionLaws laws;
    for (const MotionModel model : all_models()) {
        laws.model = model;
        const std::vector<GroundColumnText> columns = ground_columns_of(model);
        const std::vector<double> figures = ground_figures(type, laws, 1.0);
        ASSERT_EQ(figures.size(), columns.size()) << description_of(model).name;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            EXPECT_FALSE(columns[i].from.empty()) << columns[i].name;
            EXPECT_EQ(std::isnan(figures[i]), columns[i].name == "soil") << columns[i].name;
        }
    }
    laws.model = motion_model<picus::Model>;
    EXPECT_EQ(ground_figures(type, laws, 1.0), (std::vector<double>{0.3, 0.75, 1.0, 0.02, 0.004}));
}

TEST(MotionModels, SayWhatEnergiesCountInOneText) {
    EXPECT_EQ(what_energies_count(), "translation and rotation; pir3d, classical: translation alone");
}

}  // namespace
}  // namespace rockfall::models_test
