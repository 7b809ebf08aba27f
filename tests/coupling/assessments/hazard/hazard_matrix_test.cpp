#include "coupling/assessments/hazard/hazard_matrix.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <vector>

#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::hazard::hazard_matrix_test {
namespace {

Matrix matrix_of(const std::string& rows) {
    std::istringstream in{"energy_from_kj,return_period_to_years,level\n" + rows};
    return Matrix::read(config::Table::read(in, "matrix.csv"));
}

/// A name as a German page says it.
std::string in_german(const std::string& name) {
    const report::WritingLanguage german{config::Language::de};
    return report::translated(name).value_or("(none)");
}

TEST(HazardMatrix, HasNamesThatPagesTranslate) {
    const Matrix matrix = Matrix::shipped();
    for (std::size_t i = 0; i < matrix.intensities(); ++i) {
        EXPECT_NE(in_german(matrix.intensity_name(i)), "(none)") << matrix.intensity_name(i);
    }
    for (std::size_t k = 0; k < matrix.frequencies(); ++k) {
        EXPECT_NE(in_german(matrix.frequency_name(k)), "(none)") << matrix.frequency_name(k);
    }
    for (const char* level : level_names) {
        EXPECT_NE(in_german(level), "(none)") << level;
    }
    EXPECT_EQ(in_german("30 to 300 kJ"), "30 bis 300 kJ");
    EXPECT_EQ(in_german("any return period"), "jede Wiederkehrdauer");
}

TEST(HazardMatrix, HasTheClassesOfTheSwissRecommendation) {
    const Matrix matrix = Matrix::shipped();
    ASSERT_EQ(matrix.intensities(), 3U);
    ASSERT_EQ(matrix.frequencies(), 4U);
    EXPECT_EQ(matrix.intensity_name(0), "below 30 kJ");
    EXPECT_EQ(matrix.intensity_name(1), "30 to 300 kJ");
    EXPECT_EQ(matrix.intensity_name(2), "from 300 kJ");
    EXPECT_EQ(matrix.frequency_name(0), "up to 30 years");
    EXPECT_EQ(matrix.frequency_name(2), "100 to 300 years");
    EXPECT_EQ(matrix.frequency_name(3), "over 300 years");
    EXPECT_EQ(matrix.at(2, 0), Level::high);
    EXPECT_EQ(matrix.at(2, 2), Level::high);
    EXPECT_EQ(matrix.at(1, 0), Level::high);
    EXPECT_EQ(matrix.at(1, 1), Level::moderate);
    EXPECT_EQ(matrix.at(0, 0), Level::moderate);
    EXPECT_EQ(matrix.at(0, 2), Level::low);
    EXPECT_EQ(matrix.at(2, 3), Level::residual);
}

Level level_of(const Matrix& matrix, double energy_kj, double return_period_years) {
    return matrix.at(matrix.intensity_of(energy_kj), matrix.frequency_of(return_period_years));
}

/// Canton of Geneva, danger map of falling rocks (GESDEC 2012; geocat.ch, record GOL_DANGERS_CPB): frequent
/// (30 years) or rare (100 years), below or above 30 kJ. Its matrix read as one of a user's own gives what
/// the canton publishes. The shipped one gives the same but in the field that cantons divide, and there more.
TEST(HazardMatrix, GivesTheLevelsThatTheCantonOfGenevaPublishes) {
    struct Field {
        double energy_kj;
        double years;
        Level level;
    };
    const std::vector<Field> published{{29.0, 30.0, Level::moderate},
                                       {31.0, 30.0, Level::moderate},
                                       {29.0, 100.0, Level::low},
                                       {31.0, 100.0, Level::moderate}};
    const Matrix geneva =
        matrix_of("0,30,moderate\n0,100,low\n0,,none\n30,30,moderate\n30,100,moderate\n30,,none\n");
    const Matrix shipped = Matrix::shipped();
    int agree = 0;
    for (const Field& field : published) {
        EXPECT_EQ(level_of(geneva, field.energy_kj, field.years), field.level)
            << field.energy_kj << " kJ, " << field.years << " years";
        const Level here = level_of(shipped, field.energy_kj, field.years);
        EXPECT_GE(here, field.level);
        agree += here == field.level ? 1 : 0;
    }
    EXPECT_EQ(agree, 3);
    EXPECT_EQ(level_of(shipped, 31.0, 30.0), Level::high);
}

/// Pilot zone plan for Lunz am See (geo-unterweissacher.at): light brown where the energies are not above 100
/// kJ, dark brown where those of the design block are. A class of this program holds its lower end, so that
/// exactly 100 kJ is dark brown here.
TEST(HazardMatrix, GivesTheTwoZonesOfTheAustrianPilotPlan) {
    const Matrix lunz = matrix_of("0,,low\n100,,high\n");
    for (const double years : {1.0, 30.0, 150.0, 1e6}) {
        EXPECT_EQ(level_of(lunz, 1.0, years), Level::low);
        EXPECT_EQ(level_of(lunz, std::nextafter(100.0, 0.0), years), Level::low);
        EXPECT_EQ(level_of(lunz, std::nextafter(100.0, 200.0), years), Level::high);
        EXPECT_EQ(level_of(lunz, 5000.0, years), Level::high);
    }
}

TEST(HazardMatrix, NeverSinksWithEnergyNorWithFrequency) {
    const Matrix matrix = Matrix::shipped();
    for (std::size_t i = 0; i < matrix.intensities(); ++i) {
        for (std::size_t k = 0; k < matrix.frequencies(); ++k) {
            EXPECT_TRUE(i == 0 || matrix.at(i, k) >= matrix.at(i - 1, k));
            EXPECT_TRUE(k == 0 || matrix.at(i, k) <= matrix.at(i, k - 1));
        }
    }
}

TEST(HazardMatrix, PutsTheEndsOfClassesWhereTheyBelong) {
    const Matrix matrix = Matrix::shipped();
    EXPECT_EQ(matrix.intensity_of(0.0), 0U);
    EXPECT_EQ(matrix.intensity_of(std::nextafter(30.0, 0.0)), 0U);
    EXPECT_EQ(matrix.intensity_of(30.0), 1U);
    EXPECT_EQ(matrix.intensity_of(std::nextafter(300.0, 0.0)), 1U);
    EXPECT_EQ(matrix.intensity_of(300.0), 2U);
    EXPECT_EQ(matrix.intensity_of(1e9), 2U);
    EXPECT_EQ(matrix.frequency_of(1.0), 0U);
    EXPECT_EQ(matrix.frequency_of(30.0), 0U);
    EXPECT_EQ(matrix.frequency_of(std::nextafter(30.0, 31.0)), 1U);
    EXPECT_EQ(matrix.frequency_of(300.0), 2U);
    EXPECT_EQ(matrix.frequency_of(1000.0), 3U);
}

TEST(HazardMatrix, ReadsOneOfYourOwnInAnyOrder) {
    const Matrix matrix = matrix_of("100,,moderate\n0,50,low\n0,,none\n100,50,high\n");
    EXPECT_EQ(matrix.at(matrix.intensity_of(99.0), matrix.frequency_of(50.0)), Level::low);
    EXPECT_EQ(matrix.at(matrix.intensity_of(100.0), matrix.frequency_of(51.0)), Level::moderate);
    EXPECT_EQ(matrix.at(matrix.intensity_of(5.0), matrix.frequency_of(51.0)), Level::none);
}

}  // namespace
}  // namespace coupling::hazard::hazard_matrix_test
