#include "coupling/results/figures/model_verdicts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "config/data/shipped_tables.hpp"
#include "config/table/table.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::model_verdicts_test {
namespace {

TEST(ModelVerdicts, OfTheShippedTableAreOfModelsAndQuantitiesThatThereAre) {
    const config::Table table = config::read_shipped_table("model_verdicts.csv");
    std::set<std::string> models;
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        models.emplace(rockfall::description_of(model).name);
    }
    for (std::size_t row = 0; row < table.rows(); ++row) {
        EXPECT_TRUE(models.contains(table.text(row, "model"))) << table.text(row, "model");
        EXPECT_TRUE(
            std::count(judged_quantities.begin(), judged_quantities.end(), table.text(row, "quantity")))
            << table.text(row, "quantity");
        for (const char* side : {"met", "missed"}) {
            EXPECT_LE(std::stoi(table.text(row, std::string{"independent_"} + side)),
                      std::stoi(table.text(row, side)))
                << "row " << row;
        }
    }
}

TEST(ModelVerdicts, AreAddedUpOverTheCases) {
    const config::Table table = config::read_shipped_table("model_verdicts.csv");
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        const std::string name{rockfall::description_of(model).name};
        const std::vector<QuantityVerdict> verdicts = verdicts_on(name);
        ASSERT_EQ(verdicts.size(), judged_quantities.size());
        std::uint64_t all = 0;
        for (const QuantityVerdict& one : verdicts) {
            all += one.criteria();
            EXPECT_LE(one.independent(), one.criteria());
        }
        std::uint64_t in_table = 0;
        for (std::size_t row = 0; row < table.rows(); ++row) {
            if (table.text(row, "model") == name) {
                in_table += std::stoul(table.text(row, "met")) + std::stoul(table.text(row, "missed"));
            }
        }
        EXPECT_EQ(all, in_table) << name;
        EXPECT_GT(all, 0U) << name << ": each model is held against some field case";
    }
}

TEST(ModelVerdicts, SayWhatNothingJudges) {
    for (const QuantityVerdict& one : verdicts_on("picus")) {
        const std::string words = verdicts_in_words("picus");
        const std::size_t place = words.find(one.quantity);
        ASSERT_NE(place, std::string::npos) << words;
        EXPECT_EQ(place > words.find("not judged: "), one.independent() == 0) << words;
    }
    EXPECT_TRUE(verdicts_in_words("no such model").starts_with("not judged: stops, spread"));
}

}  // namespace
}  // namespace coupling::model_verdicts_test
