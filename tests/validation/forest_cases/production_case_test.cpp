#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tests/validation/forest_cases/case_runs.hpp"
#include "validation/engine/forest_cases/shared/comparison.hpp"
#include "validation/engine/screen.hpp"
#include "validation/engine/tables.hpp"

namespace coupling::validation::forest_cases::production_case_test {
namespace {

TEST(ForestProduction, NamesTheMonthAndColumnThatAreNoNumberAnyMore) {
    CaseFiles files = shipped("forest_production");
    // Height is D^1000 then: beyond all numbers from the first month on.
    replace(files.texts["demo_parameters.csv"], "nHB,0.5375352,0.4738211", "nHB,1000,1000");
    try {
        static_cast<void>(result_of(files));
        ADD_FAILURE() << "compared what is no number";
    } catch (const config::InputError& error) {
        const std::string message = config::to_string(error.problems().front());
        EXPECT_EQ(message.find("validation/forest_production/demo_parameters.csv: found run "), 0U)
            << message;
        EXPECT_NE(message.find("which gives no number from 2001-0"), std::string::npos) << message;
        EXPECT_NE(message.find("in column height"), std::string::npos) << message;
    }
}

TEST(ProductionCase, MeetsAllOfItsCriteria) {
    const CaseResult result = result_of(shipped("forest_production"));
    EXPECT_EQ(result.rows.size(), 5U);
    EXPECT_FALSE(misses_any(result));
    EXPECT_FALSE(result.has_strict);
}

TEST(ProductionCase, NoticesOneWrongDigitOfTheReference) {
    CaseFiles files = shipped("forest_production");
    // 1e-6 on 0.29643865 t/ha: 3373 ppb.
    replace(files.texts["out_pine_pjs.csv"], ",0.29643865,", ",0.29643965,");
    const CaseResult result = result_of(files);
    const VerdictRow& pine = row_of(result, "largest_difference_ppb:pine");
    EXPECT_EQ(pine.default_verdict, Verdict::missed);
    EXPECT_NEAR(pine.default_value.value, 3373.0, 50.0);
    EXPECT_EQ(row_of(result, "largest_difference_ppb:beech").default_verdict, Verdict::inside);
}

/// Lines of a table, its head first.
std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in{text};
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with('#')) {
            lines.push_back(line);
        }
    }
    return lines;
}

std::string text_of(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += line + "\n";
    }
    return text;
}

TEST(ProductionCase, PrintsWhatWasComparedAndWhereItDiffersMost) {
    CaseFiles files = shipped("forest_production");
    files.texts["out_pine_pjs.csv"] =
        "date,species,dbh,hieght,biom_stem\n2001-02,Pinus sylvestris,20.0228561,9,90.1373448\n"
        "2001-03,Pinus sylvestris,10,9,\n";
    const CaseResult result = result_of(files);
    ASSERT_EQ(result.details.size(), 3U);
    EXPECT_EQ(result.details[0].find("run pine: compared 2 columns (dbh, biom_stem) in 2 months, 3 figures; "
                                     "largest difference in column dbh, 2001-03: Bannwald 20."),
              0U)
        << result.details[0];
    EXPECT_NE(result.details[0].find(" cm, reference 10 cm, 10"), std::string::npos) << result.details[0];
    ASSERT_EQ(result.warnings.size(), 1U);
    EXPECT_NE(result.warnings[0].find("column 'hieght' is not read; if it is 'height'"), std::string::npos)
        << result.warnings[0];
    std::ostringstream screen;
    print_case(screen, result);
    EXPECT_NE(screen.str().find("warning: "), std::string::npos);
    EXPECT_NE(screen.str().find("  %  "), std::string::npos) << screen.str();
}

/// The shipped case with a text of one of its files replaced.
CaseFiles production_with(const std::string& file, const std::string& what, const std::string& instead) {
    CaseFiles files = shipped("forest_production");
    replace(files.texts[file], what, instead);
    return files;
}

/// The climate with its column prcp a thousandth.
std::string with_rain_in_metres(const std::string& climate) {
    std::istringstream in{climate};
    std::string text;
    for (std::string line; std::getline(in, line);) {
        std::istringstream fields{line};
        int at = 0;
        for (std::string field; std::getline(fields, field, ','); ++at) {
            const bool is_rain = at == 5 && field != "prcp";
            text += (at == 0 ? "" : ",") + (is_rain ? std::to_string(0.001 * std::stod(field)) : field);
        }
        text += '\n';
    }
    return text;
}

TEST(ProductionCase, WarnsOfInputsThatNothingReadsOrNoForestHas) {
    const auto warning = [](const std::string& file, const std::string& what, const std::string& instead) {
        const std::vector<std::string> warnings = read_case(production_with(file, what, instead)).warnings;
        return warnings.empty() ? std::string{} : warnings.front();
    };
    EXPECT_NE(warning("demo_climate.csv", "tmp_ave", "tmp_avg")
                  .find("column 'tmp_avg' is not read; if it is "
                        "'tmp_ave'"),
              std::string::npos);
    EXPECT_NE(warning("demo_site.csv", "altitude", "height").find("column 'height' is not read"),
              std::string::npos);
    CaseFiles dry = shipped("forest_production");
    dry.texts["demo_climate.csv"] = with_rain_in_metres(dry.texts["demo_climate.csv"]);
    ASSERT_FALSE(read_case(dry).warnings.empty());
    EXPECT_NE(read_case(dry).warnings.front().find("demo_climate.csv: prcp is 1 mm a year"),
              std::string::npos)
        << read_case(dry).warnings.front();
}

TEST(ProductionCase, NotesThatNothingStandsAtTheStart) {
    CaseFiles late = shipped("forest_production");
    std::string& species = late.texts["demo_species.csv"];
    replace(species, "1958-01", "2002-03");
    EXPECT_EQ(read_case(late).warnings.size(), 1U) << "beech alone; the mixture has pines at the start";
    EXPECT_EQ(
        read_case(late).warnings.front(),
        "run beech begins before its first species is planted, in month 3 of 2002; nothing stands before");
}

TEST(ProductionCase, NamesParametersThatTakeADefault) {
    CaseFiles files = shipped("forest_production");
    EXPECT_TRUE(read_case(files).warnings.empty());
    std::string& parameters = files.texts["demo_parameters.csv"];
    for (const std::string name : {"\nk,", "\ncrownshape,"}) {
        const std::size_t at = parameters.find(name);
        ASSERT_NE(at, std::string::npos) << name;
        parameters.erase(at, parameters.find('\n', at + 1) - at);
    }
    const std::vector<std::string> warnings = read_case(files).warnings;
    ASSERT_EQ(warnings.size(), 1U) << "one for all runs with the same file";
    EXPECT_NE(warnings[0].find("demo_parameters.csv: 2 parameters have no row and take the default of r3PG: "
                               "k = 0.5, crownshape = 3"),
              std::string::npos)
        << warnings[0];
}

TEST(ProductionCase, FindsRowsByDateAndSpeciesInAnyOrder) {
    CaseFiles files = shipped("forest_production");
    const Values straight = result_of(files).variants.front().values;
    for (const char* file : {"out_pine_pjs.csv", "own_mixture_thinned.csv"}) {
        std::vector<std::string> lines = lines_of(files.texts[file]);
        std::reverse(lines.begin() + 1, lines.end());
        files.texts[file] = text_of(lines);
    }
    const Values turned = result_of(files).variants.front().values;
    for (const auto& [name, estimate] : straight) {
        EXPECT_EQ(turned.at(name).value, estimate.value) << name;
    }
}

TEST(ProductionCase, ComparesThePartThatAReferenceHas) {
    CaseFiles files = shipped("forest_production");
    std::vector<std::string> lines = lines_of(files.texts["out_pine_pjs.csv"]);
    lines.erase(lines.begin() + 40, lines.begin() + 100);
    files.texts["out_pine_pjs.csv"] = text_of(lines);
    EXPECT_FALSE(misses_any(result_of(files)));
}

TEST(ProductionCase, NamesTheLargestDifferenceOfBiomassToo) {
    CaseFiles files = shipped("forest_production");
    files.texts["out_pine_pjs.csv"] =
        "date,species,dbh,biom_stem,biom_root\n2001-02,Pinus sylvestris,10,90.1373448,16\n"
        "2001-03,Pinus sylvestris,,99,\n";
    const std::string detail = result_of(files).details[0];
    EXPECT_NE(detail.find("column dbh, 2001-02: Bannwald 20.0228561 cm, reference 10 cm, 100 %; largest "
                          "difference of biomass in column biom_stem, 2001-03: Bannwald 90."),
              std::string::npos)
        << detail;
    EXPECT_TRUE(detail.ends_with(" t/ha, reference 99 t/ha, 8.59 t/ha")) << detail;
    files.texts["out_pine_pjs.csv"] = "date,species,biom_stem\n2001-03,Pinus sylvestris,99\n";
    EXPECT_EQ(result_of(files).details[0].find("of biomass"), std::string::npos) << "the same place once";
}

TEST(ProductionCase, TakesFilesAndTheHeightModelFromItsRows) {
    CaseFiles files = shipped("forest_production");
    for (const char* name : {"site", "species", "parameters", "climate"}) {
        files.texts[std::string{"my_"} + name + ".csv"] = files.texts[std::string{"demo_"} + name + ".csv"];
        files.texts.erase(std::string{"demo_"} + name + ".csv");
    }
    files.texts["criteria.csv"] =
        "quantity,low,high,rests_on,rule,cause\n"
        "largest_difference_ppb:pine,0,1000,independent,,\n";
    const auto rows_with = [](const std::string& height) {
        return "run,species,models,reference,source,site,start,parameters,climate,height\n"
               "pine,Pinus sylvestris,3-PGpjs,out_pine_pjs.csv,r3PG,my_site.csv,my_species.csv,"
               "my_parameters.csv,my_climate.csv," +
               height + "\n";
    };
    files.texts["runs.csv"] = rows_with("power");
    EXPECT_FALSE(misses_any(result_of(files)));
    files.texts["runs.csv"] = rows_with("exponential");
    EXPECT_TRUE(misses_any(result_of(files))) << "another height";
}

TEST(ProductionCase, TakesPublishedParameters) {
    // No litterfall at planting, conductance that more than halves at 700 ppm, leaves that change in a year.
    CaseFiles files = shipped("forest_production");
    std::string& parameters = files.texts["demo_parameters.csv"];
    const auto set = [&](const std::string& name, const std::string& value) {
        const std::size_t at = parameters.find("\n" + name + ",") + 1;
        ASSERT_NE(at, 0U) << name;
        parameters.replace(at, parameters.find('\n', at) - at, name + "," + value + "," + value);
    };
    set("gammaF0", "0");
    set("fCg700", "0.293");
    set("tSLA", "1");
    const CaseResult result = result_of(files);
    EXPECT_TRUE(std::isfinite(row_of(result, "largest_difference_ppb:pine").default_value.value));
}

}  // namespace
}  // namespace coupling::validation::forest_cases::production_case_test
