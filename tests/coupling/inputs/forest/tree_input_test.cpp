#include "coupling/inputs/forest/tree_input.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "coupling/inputs/forest/species_table.hpp"
#include "coupling/inputs/site_draws.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::tree_input_test {
namespace {

constexpr const char* header = "tree_id,x_m,y_m,species,dbh_cm,height_m\n";

/// What comes of the sample project with this tree list.
Opened with_trees(const std::string& rows, const std::vector<std::string>& overrides = {}) {
    const SampleProject project;
    project.write("trees.csv", header + rows);
    return open(project, overrides);
}

TEST(Trees, ThatBorrowParametersAreTold) {
    const Opened opened =
        with_trees("1,1060,2050,taba,30,25\n2,1061,2050,TABA,30,25\n3,1062,2050,Salix caprea,9,9\n");
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.warnings,
              (std::vector<std::string>{
                  "trees.csv: 1 tree of SACA (Salix caprea) taken like BEPE, but with their own fracture "
                  "energy of 1.1; write another code if another species comes nearer",
                  "trees.csv: 2 trees of TABA (Taxus baccata) taken like ABAL, but with their own fracture "
                  "energy of 1.2; write another code if another species comes nearer"}));
    EXPECT_EQ(opened.site->trees[0].species, "TABA");
    EXPECT_EQ(opened.site->trees[0].stem.fracture_energy, 1.2);
}

/// Heights on a curve of Petterson's law: ABAL of 10, 20, ... cm.
std::string measured(int trees) {
    std::string rows;
    for (int i = 1; i <= trees; ++i) {
        const double dbh_cm = 10.0 * i;
        const double height_m = 1.3 + std::pow(dbh_cm / (2.0 + 0.28 * dbh_cm), 3.0);
        rows += std::to_string(i) + ",10" + std::to_string(50 + i) + ",2050,ABAL," + std::to_string(dbh_cm) +
                "," + std::to_string(height_m) + "\n";
    }
    return rows;
}

TEST(Trees, WithoutHeightGetThatOfTheCurveThroughTheOthers) {
    const Opened opened = with_trees(measured(6) + "7,1070,2050,ABAL,35,\n8,1071,2050,PIAB,35,\n");
    ASSERT_TRUE(opened.site) << opened.errors;
    const double of_law_m = 1.3 + std::pow(35.0 / (2.0 + 0.28 * 35.0), 3.0);
    EXPECT_NEAR(opened.site->trees[6].stem.height_m, of_law_m, 1e-3);
    EXPECT_NEAR(opened.site->trees[7].stem.height_m, of_law_m, 1e-3);
    EXPECT_EQ(opened.warnings,
              (std::vector<std::string>{"trees.csv: 1 height of ABAL filled in from a height curve through 6 "
                                        "measured trees (standard error 0.0 m)",
                                        "trees.csv: 1 height of PIAB filled in from a height curve through 6 "
                                        "measured trees of all species (standard error 0.0 m)"}));
}

TEST(Trees, WithoutDiameterGetOneByTheirHeightAndAWiderInterval) {
    const SampleProject project;
    std::string rows = "x_m,y_m,height_m\n";
    for (int i = 0; i < 40; ++i) {
        rows += std::to_string(1050 + i % 8) + "," + std::to_string(2040 + i / 8) + ",20\n";
    }
    project.write("trees.csv", rows);
    const Opened conifers = open(project, {"trees.species=PIAB"});
    const Opened broadleaves = open(project, {"trees.species=Buche"});
    ASSERT_TRUE(conifers.site && broadleaves.site) << conifers.errors << broadleaves.errors;
    // 40 draws of deviation 0.24: the mean of their logarithms is known to 0.038, the whole to three times
    // that.
    const auto mean_log = [](const Site& site) {
        double sum = 0.0;
        for (const TreeRecord& tree : site.trees) {
            EXPECT_TRUE(tree.has_derived_dbh);
            sum += std::log(tree.stem.dbh_cm) / static_cast<double>(site.trees.size());
        }
        return sum;
    };
    EXPECT_NEAR(mean_log(*conifers.site), std::log(33.0), 0.12);
    EXPECT_NEAR(mean_log(*broadleaves.site), std::log(24.4), 0.12);
    const auto width_of_energy = [](const Opened& opened) {
        for (const ParameterDraws::Component& component :
             components_on(*opened.site->knowledge, drawn_site(*opened.site))) {
            if (component.parameter == "tree_energy") {
                return component.width;
            }
        }
        return 0.0;
    };
    EXPECT_NEAR(width_of_energy(conifers), std::hypot(0.30, 2.31 * 0.22), 1e-12);
    EXPECT_NEAR(width_of_energy(open(SampleProject{})), 0.30, 1e-12);
    // Where its energy is taken as known, it stays so.
    project.write("known.csv", "parameter,width\ntree_energy,0\n");
    EXPECT_EQ(width_of_energy(open(project, {"trees.species=PIAB", "run.parameters=known.csv"})), 0.0);
}

TEST(Trees, WithSwappedAxesAreRefusedUntilTheSettingSwapsThem) {
    const std::string rows = "1,2050,1060,ABAL,30,25\n2,2042,1070,ABAL,30,25\n";
    const Opened right = with_trees(rows, {"trees.swap_xy=yes"});
    ASSERT_TRUE(right.site) << right.errors;
    ASSERT_EQ(right.site->trees.size(), 2U);
    EXPECT_EQ(right.site->trees[0].stem.x_m, 1060.0);
    EXPECT_EQ(right.site->trees[0].stem.y_m, 2050.0);
}

TEST(Trees, MayComeWithoutIdentity) {
    const SampleProject project;
    project.write("trees.csv", "species,dbh_cm,x_m,height_m,note,y_m\nabal,30,1060,25,x,2050\n");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->trees[0].id, "1");
}

TEST(Trees, MayBeSnagsAndStumps) {
    const SampleProject project;
    const std::string head = "x_m,y_m,species,dbh_cm,height_m,state,strength,broken_at_m\n";
    project.write("trees.csv", head +
                                   "1060,2050,ABAL,30,25,living,,\n1061,2050,ABAL,30,28,snag,0.6,4.5\n"
                                   "1062,2050,ABAL,40,1.3,stump,0.9,\n1063,2050,ABAL,30,20,,,\n");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    const auto& trees = opened.site->trees;
    EXPECT_EQ(trees[0].stem.strength, 1.0);
    EXPECT_EQ(trees[1].stem.strength, 0.6);
    EXPECT_EQ(trees[1].stem.broken_at_m, 4.5);
    EXPECT_EQ(trees[1].stem.height_m, 28.0);
    EXPECT_EQ(trees[2].stem.height_m, 1.3);
    EXPECT_EQ(trees[3].stem.strength, 1.0);
}

TEST(Trees, AreNotNeeded) {
    const SampleProject project;
    const Opened opened = open(project, {"trees.file="});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_TRUE(opened.site->trees.empty());
}

TEST(SpeciesTable, FindsCodesAndLatinNamesInAnyCase) {
    const SpeciesTable table = SpeciesTable::shipped();
    for (const char* name : {"FASY", "fasy", "Fagus sylvatica", "FAGUS SYLVATICA"}) {
        ASSERT_NE(table.find(name), nullptr) << name;
        EXPECT_EQ(table.find(name)->code, "FASY");
        EXPECT_EQ(table.find(name)->fracture_energy, 1.70);
    }
    EXPECT_EQ(table.find("Fagopyrum"), nullptr);
}

TEST(SpeciesTable, KnowsNamesInFourLanguagesAndShortForms) {
    const SpeciesTable table = SpeciesTable::shipped();
    const std::vector<std::pair<std::string, std::string>> meant{
        {"Fichte", "PIAB"},      {"FICHTE", "PIAB"},
        {"Fi", "PIAB"},          {"épicéa", "PIAB"},
        {"Abete rosso", "PIAB"}, {"Weißtanne", "ABAL"},
        {"Weisstanne", "ABAL"},  {"Ta.", "ABAL"},
        {"sapin", "ABAL"},       {"LÄRCHE", "LADE"},
        {"Laerche", "LADE"},     {"mélèze", "LADE"},
        {"hêtre", "FASY"},       {"faggio", "FASY"},
        {"RBu", "FASY"},         {"Berg-Ahorn", "ACPS"},
        {"Föhre", "PISY"},       {"Foehre", "PISY"},
        {"Arve", "PICE"},        {"Picea abies (L.) H. Karst.", "PIAB"},
        {"Vogelbeere", "SOAU"},  {"frassino", "FREX"},
        {"Laubholz", "OTBR"},    {"Picea", "PIAB"}};
    for (const auto& [name, code] : meant) {
        ASSERT_NE(table.find(name), nullptr) << name;
        EXPECT_EQ(table.find(name)->code, code) << name;
    }
    for (const char* name : {"Fi?", "Fichtel", "Picea abiess", "", "?"}) {
        EXPECT_EQ(table.find(name), nullptr) << name;
    }
}

TEST(SpeciesTable, PassesOverWhatInventoriesWriteAroundALatinName) {
    const SpeciesTable table = SpeciesTable::shipped();
    const std::vector<std::pair<std::string, std::string>> meant{
        {"Picea abies (L.) H.Karst.", "PIAB"},
        {"Picea abies (L.)H.Karst.", "PIAB"},
        {"Picea_abies", "PIAB"},
        {"PICEA ABIES (L.) KARST.", "PIAB"},
        {"Picea\u00a0abies", "PIAB"},
        {"Fagus sylvatica 'Atropunicea'", "FASY"},
        {"Fagus sylvatica \u2018Dawyck Gold\u2019", "FASY"},
        {"Fagus sylvatica f. purpurea (Aiton) C.K.Schneid.", "FASY"},
        {"Acer pseudoplatanus L.", "ACPS"},
        {"Acer pseudo-platanus", "ACPS"},
        {"Quercus sp.", "QURO"},
        {"Quercus spp", "QURO"},
        {"Quercus L.", "QURO"},
        {"Quercus cf. petraea", "QUPE"},
        {"Abies alba Mill.", "ABAL"},
        {"Pinus mugo subsp. uncinata (Ramond) Domin", "PIUN"},
        {"Pinus mugo subsp. mugo", "PIMU"},
        {"Pinus nigra var. laricio L'H\u00e9r.", "PINI"},
        {"L\u00e4rche sp.", "LADE"}};
    for (const auto& [name, code] : meant) {
        ASSERT_NE(table.find(name), nullptr) << name;
        EXPECT_EQ(table.find(name)->code, code) << name;
    }
}

TEST(SpeciesTable, TakesNoOtherSpeciesForOneOfAKnownGenus) {
    const SpeciesTable table = SpeciesTable::shipped();
    for (const char* name :
         {"Quercus frainetto Ten.", "Tilia x europaea", "Populus \u00d7 canadensis Moench",
          "Quercus Frainetto", "Aesculus hippocastanum L.", "Aesculus sp.", "Tanne L.", "", "sp."}) {
        EXPECT_EQ(table.find(name), nullptr) << name;
    }
    EXPECT_EQ(table.nearest("Tilia x europaea 'Pallida'"), "Tilia cordata, Tilia platyphyllos");
    EXPECT_EQ(table.nearest("Aesculus sp."), "");
    EXPECT_EQ(table.nearest("Piceea abies (L.) H.Karst."), "Picea abies");
}

TEST(SpeciesTable, HasNoNameForTwoSpecies) {
    const SpeciesTable table = SpeciesTable::shipped();
    std::map<std::string, std::string> code_of;
    for (const Species& species : table.all()) {
        EXPECT_FALSE(species.names.empty()) << species.code;
        for (const std::string& name : species.names) {
            EXPECT_FALSE(name.empty()) << species.code;
            const auto [entry, is_new] = code_of.emplace(name, species.code);
            EXPECT_TRUE(is_new || entry->second == species.code) << name;
        }
    }
}

TEST(SpeciesTable, GivesEachSpeciesAStrengthOfItsOwn) {
    const SpeciesTable table = SpeciesTable::shipped();
    EXPECT_GE(table.all().size(), 30U);
    for (const Species& species : table.all()) {
        EXPECT_GE(species.fracture_energy, 0.5) << species.code;
        EXPECT_LE(species.fracture_energy, 2.5) << species.code;
        EXPECT_EQ(species.code.size(), 4U) << species.code;
    }
}

TEST(SpeciesTable, LetsOnlySpeciesWithParametersStandIn) {
    const SpeciesTable table = SpeciesTable::shipped();
    int borrowers = 0;
    for (const Species& species : table.all()) {
        if (!species.stand_in.empty()) {
            ++borrowers;
            ASSERT_NE(table.find(species.stand_in), nullptr) << species.code;
            EXPECT_TRUE(table.find(species.stand_in)->stand_in.empty()) << species.code;
        }
    }
    EXPECT_GT(borrowers, 3);
}

}  // namespace
}  // namespace coupling::tree_input_test
