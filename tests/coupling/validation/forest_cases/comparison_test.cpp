#include "coupling/validation/forest_cases/comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include "config/data/shipped_tables.hpp"
#include "coupling/validation/screen.hpp"
#include "coupling/validation/tables.hpp"
#include "coupling/validation/validate.hpp"
#include "coupling/validation/verdict.hpp"
#include "tests/coupling/validation/forest_cases/remeasured/synthetic_plot.hpp"

namespace coupling::validation::forest_cases::comparison_test {
namespace {

CaseFiles shipped(const std::string& name) {
    for (CaseFiles& files : shipped_cases()) {
        if (files.name == name) {
            return std::move(files);
        }
    }
    ADD_FAILURE() << "no case " << name;
    return {};
}

CaseResult result_of(const CaseFiles& files, const CaseChanges& changes = {}, int threads = 2) {
    return validate(read_case(files, changes), {.threads = threads, .quiet = true});
}

const VerdictRow& row_of(const CaseResult& result, const std::string& quantity) {
    for (const VerdictRow& row : result.rows) {
        if (row.quantity == quantity) {
            return row;
        }
    }
    throw std::runtime_error{"no row " + quantity};
}

void replace(std::string& text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    text.replace(at, what.size(), with);
}

std::string problem_of(const CaseFiles& files, const CaseChanges& changes = {}) {
    try {
        read_case(files, changes);
    } catch (const config::InputError& error) {
        return config::to_string(error.problems().front());
    }
    return "";
}

/// Two of the shipped plantations, of spruce with its table and of fir without, up to age 50.
CaseFiles small_yield() {
    CaseFiles files = shipped("forest_yield");
    files.texts["sites.csv"] =
        "site,species,elevation_m,fertility,table,class\n"
        "piab_1000,piab,1000,0.8,guttenberg_1915,2\nabal_500,abal,500,0.8,,\n";
    files.texts["criteria.csv"] =
        "quantity,low,high,rests_on,rule,cause\nvolume_ratio:piab_1000:50,0.5,2,fitted,,\n"
        "volume_m3pha:abal_500:40,1e6,2e6,independent,meant to be missed,no fir is that thick\n";
    replace(files.texts["case.ini"], "ages_years = 40, 50, 60, 70, 80, 90, 100, 110, 120, 130, 140",
            "ages_years = 40, 50");
    replace(files.texts["case.ini"], "drawn_ages_years = 70, 100", "drawn_ages_years = 50");
    return files;
}

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

TEST(ProductionCase, RefusesFiguresThatHaveNothingToCompare) {
    CaseFiles files = shipped("forest_production");
    const auto pine_with = [&](const std::string& head, const std::string& row) {
        files.texts["out_pine_pjs.csv"] = "date,species," + head + "\n2001-02,Pinus sylvestris," + row + "\n";
        return problem_of(files);
    };
    EXPECT_NE(pine_with("bio_stem,dhb", "90,20")
                  .find("out_pine_pjs.csv: found no figure to compare; "
                        "not read: bio_stem, dhb"),
              std::string::npos);
    EXPECT_NE(pine_with("dbh,biom_stem", "NA,").find("no figure to compare"), std::string::npos);
    EXPECT_NE(pine_with("tmp_min,co2", "-0.86,360").find("no figure to compare but weather"),
              std::string::npos);
    EXPECT_NE(pine_with("variable,value", "dbh,20").find("turn the table"), std::string::npos);
    EXPECT_NE(pine_with("dbh", "thick").find("out_pine_pjs.csv:2:26"), std::string::npos)
        << pine_with("dbh", "thick");
    const std::string no_stock = pine_with("dbh,bio_stem", "20.0228561,90");
    EXPECT_NE(no_stock.find("criteria.csv:4:1: found 'largest_biomass_difference_gpha:pine', which cannot be "
                            "computed: "),
              std::string::npos)
        << no_stock;
    EXPECT_NE(no_stock.find("not read: bio_stem"), std::string::npos) << no_stock;
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

TEST(ProductionCase, NamesTheMistakeInARun) {
    const auto with = [](const std::string& what, const std::string& instead) {
        CaseFiles files = shipped("forest_production");
        replace(files.texts["runs.csv"], what, instead);
        return problem_of(files);
    };
    EXPECT_NE(
        with("out_pine_pjs.csv", "out_pine.csv").find("runs.csv:3:34: found no file 'out_pine.csv' in "),
        std::string::npos)
        << with("out_pine_pjs.csv", "out_pine.csv");
    EXPECT_NE(with("\nbeech,", "\npine,").find("run 'pine' a second time"), std::string::npos);
    EXPECT_NE(with("3-PGmix,yes", "3-PGmix,ja").find("found thinned 'ja', expected yes or no"),
              std::string::npos);
    EXPECT_NE(
        with("pine,Pinus sylvestris", "pine,Pinus silvestris").find("if it is 'Pinus sylvestris', spell it"),
        std::string::npos);
    CaseFiles files = shipped("forest_production");
    files.texts["demo_thinning.csv"] = "species,age,stems_n,stem,root,foliage\nbeech,48,500,1,1,1\n";
    EXPECT_NE(problem_of(files).find("found no thinning of a species of run mixture"), std::string::npos)
        << problem_of(files);
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
    parameters = "parameter,Pinus sylvestris,Fagus sylvatica\n";
    EXPECT_NE(problem_of(files).find("demo_parameters.csv: found no parameter"), std::string::npos)
        << problem_of(files);
    parameters = "parameter,Pinus silvestris,Fagus sylvatica\nk,0.5,0.5\n";
    EXPECT_NE(
        problem_of(files).find("demo_parameters.csv: found no parameters of 'Pinus sylvestris', expected "
                               "a column for each species of run pine; if it is the column 'Pinus "
                               "silvestris'"),
        std::string::npos)
        << problem_of(files);
}

/// The sample of a file in validation/README.md, such as "case.ini" of "forest_light".
std::string sample_in_readme(const std::string& file, const std::string& kind) {
    std::ifstream in{BANNWALD_SOURCE_DIR "/validation/README.md"};
    const std::string readme{std::istreambuf_iterator<char>{in}, {}};
    const std::size_t named = readme.find("\n`" + file + "` of `" + kind + "`:\n");
    EXPECT_NE(named, std::string::npos) << file << " of " << kind;
    const std::size_t begin = readme.find('\n', readme.find("```", named)) + 1;
    return readme.substr(begin, readme.find("```", begin) - begin);
}

TEST(ForestCase, RunsTheSamplesOfTheReadme) {
    // The tables that the samples leave out are those of a shipped case, or of the synthetic plot.
    const std::map<std::string, std::vector<std::string>> samples{
        {"forest_production", {"case.ini", "criteria.csv", "runs.csv"}},
        {"forest_light", {"case.ini", "criteria.csv", "slopes.csv", "sensors.csv"}},
        {"forest_remeasured", {"case.ini", "criteria.csv"}}};
    for (const auto& [kind, names] : samples) {
        CaseFiles files = kind == "forest_remeasured" ? remeasured::synthetic_case() : shipped(kind);
        if (kind == "forest_light") {
            files.texts.erase("ground.csv");
        }
        for (const std::string& name : names) {
            files.texts[name] = sample_in_readme(name, kind);
        }
        const CaseResult result = result_of(files);
        const auto rows =
            std::count(files.texts["criteria.csv"].begin(), files.texts["criteria.csv"].end(), '\n');
        EXPECT_EQ(std::count_if(result.rows.begin(), result.rows.end(),
                                [](const VerdictRow& row) {
                                    return row.low && std::isfinite(row.default_value.value);
                                }),
                  rows - 1)
            << kind;
        EXPECT_EQ(result.warnings.empty(), kind != "forest_light") << "light of the slopes left out";
    }
}

TEST(ForestCase, AsksForItsKind) {
    CaseFiles files = shipped("forest_light");
    replace(files.texts["case.ini"], "kind = forest_light\n", "");
    EXPECT_EQ(problem_of(files).find("validation/forest_light/case.ini: found no case.kind, and no slope for "
                                     "rocks, expected a line `kind = ` under [case] with one of slope, "),
              0U)
        << problem_of(files);
    files = shipped("forest_light");
    replace(files.texts["case.ini"], "kind = forest_light", "kind = forest_lihgt");
    EXPECT_NE(problem_of(files).find("found case.kind 'forest_lihgt', expected 'forest_light'"),
              std::string::npos)
        << problem_of(files);
    files = shipped("vaujany_open");
    replace(files.texts["case.ini"], "kind = slope", "");
    EXPECT_EQ(problem_of(files), "") << "rocks on a slope";
}

TEST(ForestCase, WarnsThatNothingJudges) {
    CaseFiles files = shipped("forest_production");
    files.texts.erase("criteria.csv");
    const CaseResult result = result_of(files);
    ASSERT_EQ(result.warnings.size(), 1U);
    EXPECT_EQ(result.warnings[0].find("nothing is judged: "), 0U) << result.warnings[0];
    EXPECT_EQ(result.rows.size(), 6U) << "the figures help without bounds too";
    EXPECT_FALSE(misses_any(result));
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

TEST(ProductionCase, NamesRowsThatAreNotInTheRun) {
    const auto with_row = [](const std::string& row) {
        CaseFiles files = shipped("forest_production");
        replace(files.texts["criteria.csv"], "largest_biomass_difference_gpha:pine",
                "largest_biomass_difference_gpha:mixture");
        files.texts["out_pine_pjs.csv"] = "date,species,dbh\n2001-02-28,Pinus sylvestris,20.0228561\n" + row;
        return problem_of(files);
    };
    EXPECT_EQ(with_row(""), "");
    EXPECT_NE(with_row("2011-01-31,Pinus sylvestris,20\n")
                  .find("out_pine_pjs.csv:3:1: found date 2011-01-31, "
                        "which is not in the run"),
              std::string::npos)
        << with_row("2011-01-31,Pinus sylvestris,20\n");
    EXPECT_NE(with_row("2001-03-31,Pinus nigra,20\n").find("a species of the run: Pinus sylvestris"),
              std::string::npos);
    EXPECT_NE(with_row("2001-02,Pinus sylvestris,20\n").find("a second time"), std::string::npos);
    EXPECT_NE(with_row("February,Pinus sylvestris,20\n").find("a date such as"), std::string::npos);
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

TEST(ProductionCase, AsksForTheDateThatAReferenceMeans) {
    CaseFiles files = shipped("forest_production");
    const auto with_head = [&](const std::string& head) {
        files.texts["out_pine_pjs.csv"] = head + ",species,dbh\n2001,2,Pinus sylvestris,20.0228561\n";
        return problem_of(files);
    };
    EXPECT_EQ(with_head("Date,day"),
              "validation/forest_production/out_pine_pjs.csv: no column 'date' (is 'Date' meant to be it?)");
    EXPECT_NE(with_head("year,monht").find("no column 'month' (is 'monht' meant"), std::string::npos)
        << with_head("year,monht");
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
    files.texts["runs.csv"] = rows_with("2");
    EXPECT_NE(problem_of(files).find("exponential (model 2)"), std::string::npos);
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

TEST(LightCase, MissesTheCorrelationOnTheSouthSlopeAlone) {
    const CaseResult result = result_of(shipped("forest_light"));
    for (const VerdictRow& row : result.rows) {
        EXPECT_EQ(row.default_verdict == Verdict::missed,
                  row.quantity == "tree_light_correlation:slope_35_south")
            << row.quantity;
        EXPECT_EQ(row.strict_verdict, Verdict::no_criterion) << row.quantity;
        EXPECT_FALSE(row.label.empty()) << row.quantity;
    }
    EXPECT_TRUE(misses_any(result));
}

TEST(LightCase, ShowsEveryTreeOnEverySlope) {
    const CaseResult result = result_of(shipped("forest_light"));
    ASSERT_EQ(result.plots.size(), 2U);
    for (const PlotGroup& group : result.plots) {
        ASSERT_EQ(group.plots.size(), 3U);
        for (const Plot& plot : group.plots) {
            EXPECT_EQ(plot.series.back().points.size(), 333U);
        }
    }
}

TEST(LightCase, RefusesACorrelationOfOneSensor) {
    CaseFiles files = shipped("forest_light");
    files.texts["sensors.csv"] = "x_m,y_m,light_slope_6\n50,50,0.1\n";
    files.texts["criteria.csv"] = "quantity,low,high,rests_on,rule\nsensor_bias:slope_6,-1,1,independent,\n";
    const Values values = result_of(files).variants.front().values;
    EXPECT_TRUE(values.contains("sensor_bias:slope_6"));
    EXPECT_FALSE(values.contains("sensor_correlation:slope_6"));
    files.texts["criteria.csv"] += "fine_sensor_correlation:slope_6,0.5,1,independent,\n";
    EXPECT_NE(
        problem_of(files).find("criteria.csv:3:1: found 'fine_sensor_correlation:slope_6', which cannot be "
                               "computed: a correlation needs 3 places or more, and there is 1"),
        std::string::npos)
        << problem_of(files);
}

TEST(YieldCase, TakesClassesAndAgesOfAnyTable) {
    CaseFiles files = small_yield();
    files.texts["sites.csv"] =
        "site,species,elevation_m,fertility,table,class,latitude_deg\nmine,piab,1000,0.8,my table,II.5,46\n";
    // No basal area; ages as they were measured.
    files.texts["yield_tables.csv"] =
        "table,class,age_years,mean_height_m,stems_pha,mean_dbh_cm,volume_m3pha\n"
        "my table,II.5,23,6.5,4400,8.2,90\nmy table,II.5,37,12.4,2300,14.8,240\n"
        "my table,III,37,10.1,2700,12.6,170\n";
    files.texts["criteria.csv"] =
        "quantity,low,high,rests_on,rule,cause\nvolume_ratio:mine:37,0.2,5,"
        "independent,,\n";
    replace(files.texts["case.ini"], "ages_years = 40, 50", "ages_years =");
    replace(files.texts["case.ini"], "drawn_ages_years = 50", "drawn_ages_years =\ntwins = no");
    const CaseResult result = result_of(files);
    EXPECT_FALSE(misses_any(result));
    const Values& values = result.variants.front().values;
    EXPECT_NEAR(values.at("volume_m3pha:mine:37").value / values.at("volume_ratio:mine:37").value, 240.0,
                1e-9)
        << "of its class";
    replace(files.texts["yield_tables.csv"], "my table,III,37", "my table,II.5,37");
    EXPECT_NE(problem_of(files).find("age 37 of my table, class II.5, a second time"), std::string::npos)
        << problem_of(files);
}

TEST(YieldCase, JudgesEachSiteAgainstItsTable) {
    const CaseResult result = result_of(small_yield());
    // Guttenberg, class II, age 50.
    const double ratio = row_of(result, "volume_ratio:piab_1000:50").default_value.value;
    const Values& values = result.variants.front().values;
    EXPECT_NEAR(values.at("volume_m3pha:piab_1000:50").value / ratio, 320.0, 1e-9);
    EXPECT_EQ(row_of(result, "volume_m3pha:abal_500:40").default_verdict, Verdict::missed);
    EXPECT_FALSE(values.contains("volume_ratio:abal_500:50"));
    EXPECT_TRUE(values.contains("layers_volume_m3pha:abal_500:50"));
}

TEST(YieldCase, GivesTheSameFiguresOnAnyNumberOfThreads) {
    const auto figures = [](int threads) {
        const CaseResult result = result_of(small_yield(), {}, threads);
        std::ostringstream out;
        write_figures(out, {&result, 1});
        write_plots(out, {&result, 1});
        return out.str();
    };
    EXPECT_EQ(figures(1), figures(3));
}

TEST(YieldCase, SharesTheFiguresThatAgree) {
    const Values values = result_of(small_yield()).variants.front().values;
    EXPECT_EQ(values.at("share_within:all:to_100").value, values.at("share_within:piab:to_100").value);
    EXPECT_TRUE(values.contains("top_height_ratio:piab_1000:50"));
    EXPECT_LE(values.at("greatest_density:piab_1000").value, 1.1);
}

TEST(YieldCase, GrowsTheSpeciesOfItsOwnFolder) {
    CaseFiles files = small_yield();
    files.texts["species.csv"] = std::string{config::shipped_table("species.csv")};
    const auto volume = [](const CaseFiles& of) {
        return result_of(of).variants.front().values.at("volume_m3pha:piab_1000:50").value;
    };
    const double as_shipped = volume(files);
    EXPECT_EQ(as_shipped, volume(small_yield()));
    std::string& text = files.texts["species.csv"];
    const std::size_t row = text.find("PIAB");
    const std::size_t density = text.find(",430,400,", row);
    ASSERT_NE(density, std::string::npos);
    text.replace(density, 9, ",230,400,");
    EXPECT_GT(volume(files), 1.1 * as_shipped) << "light wood makes more volume of the same mass";
}

TEST(YieldCase, AsksForRowsOfTheTableAndRisingAges) {
    CaseFiles files = small_yield();
    files.texts["sites.csv"] =
        "site,species,elevation_m,fertility,table,class\npiab_1000,piab,1000,0.8,guttenberg_1915,9\n";
    EXPECT_NE(problem_of(files).find("no row of table 'guttenberg_1915' for site piab_1000"),
              std::string::npos)
        << problem_of(files);
    files = small_yield();
    replace(files.texts["case.ini"], "ages_years = 40, 50", "ages_years = 50, 40");
    EXPECT_NE(problem_of(files).find("yield.ages_years 40"), std::string::npos) << problem_of(files);
}

/// Two species at their optimum, four stands each, two years.
CaseFiles small_demography() {
    CaseFiles files = shipped("forest_demography");
    files.texts["reference.csv"] =
        "species,place,degree_days,wetness,dbh_cm,larger_m2pha,growth_mm_pyear,mortality_pyear\n"
        "abal,2,1823.7,0.446,30,5,8.2,0.0009\nabal,2,1823.7,0.446,30,40,4.3,0.0019\n"
        "lade,1,2332.4,0.024,15,20,2.6,0.0156\n";
    files.texts["criteria.csv"] = "quantity,low,high,rests_on,rule\nshare_growth:all:2,0,1,independent,x\n";
    replace(files.texts["case.ini"], "seeds = 50", "seeds = 4");
    replace(files.texts["case.ini"], "years = 10", "years = 2");
    return files;
}

TEST(DemographyCase, FindsLessGrowthUnderMoreCompetition) {
    const Values values = result_of(small_demography()).variants.front().values;
    const double open_mm = 8.2 * values.at("growth_ratio:abal:2:30:5").value;
    const double crowded_mm = 4.3 * values.at("growth_ratio:abal:2:30:40").value;
    EXPECT_GT(open_mm, 1.2 * crowded_mm);
    EXPECT_TRUE(values.contains("mortality_ratio:lade:1:15:20"));
    EXPECT_TRUE(values.contains("share_mortality:abal:2"));
}

TEST(DemographyCase, LeavesOutTheEdgesWhereAsked) {
    CaseChanges changes;
    changes.overrides = {"demography.edges=no"};
    const Values values = result_of(small_demography(), changes).variants.front().values;
    EXPECT_FALSE(values.contains("growth_ratio:lade:1:15:20"));
}

TEST(DemographyCase, GivesTheSameFiguresOnAnyNumberOfThreads) {
    const auto figures = [](int threads) {
        const CaseResult result = result_of(small_demography(), {}, threads);
        std::ostringstream out;
        write_figures(out, {&result, 1});
        return out.str();
    };
    EXPECT_EQ(figures(1), figures(3));
}

/// Two places, a ninth of a hectare, 40 years.
CaseChanges few_years(std::vector<std::string> more = {}) {
    CaseChanges changes;
    changes.overrides = {"belts.years=40", "belts.judged_from_year=20", "belts.replicates=2",
                         "belts.side_patches=3"};
    changes.overrides.insert(changes.overrides.end(), more.begin(), more.end());
    return changes;
}

CaseFiles small_belts() {
    CaseFiles files = shipped("forest_belts");
    files.texts["sites.csv"] =
        "site,elevation_m,fertility,water_mm,nitrogen_kg_ha_yr,ph\ne1500,1500,0.6,120,55,5.0\n"
        "e0500,500,0.8,120,70,5.5\n";
    files.texts["criteria.csv"] =
        "quantity,low,high,rests_on,rule\nshare:spruce:e1500,0,1,independent,x\n"
        "biomass_tpha:e0500,1,500,independent,x\n";
    return files;
}

TEST(BeltsCase, StacksTheSpeciesUpToTheWholeBiomass) {
    const CaseResult result = result_of(small_belts(), few_years());
    EXPECT_FALSE(misses_any(result));
    ASSERT_EQ(result.plots.size(), 2U);
    const Plot& biomass = result.plots[0].plots.at(1);
    const std::vector<report::ChartRange>& top = biomass.series.back().ranges;
    ASSERT_EQ(top.size(), 2U);
    EXPECT_EQ(top[0].x, 500.0) << "sites in the order of their elevation";
    const Values& values = result.variants.front().values;
    EXPECT_NEAR(top[0].high, values.at("biomass_tpha:e0500").value, 1e-9);
    EXPECT_NEAR(top[1].high, values.at("biomass_tpha:e1500").value, 1e-9);
    const Plot& shares = result.plots[0].plots.at(0);
    EXPECT_NEAR(shares.series.back().ranges[0].high, 100.0, 1e-9);
    ASSERT_EQ(result.plots[1].plots.size(), 2U);
    EXPECT_EQ(result.plots[1].plots[0].series.front().ranges.back().x, 40.0);
}

TEST(BeltsCase, GivesTheSameFiguresOnAnyNumberOfThreadsAndOthersForAnotherSeed) {
    const auto figures = [](int threads, const std::string& more) {
        const CaseResult result = result_of(small_belts(), few_years({more}), threads);
        std::ostringstream out;
        write_figures(out, {&result, 1});
        write_plots(out, {&result, 1});
        return out.str();
    };
    const std::string one = figures(1, "belts.seed=1");
    EXPECT_EQ(one, figures(3, "belts.seed=1"));
    EXPECT_NE(one, figures(3, "belts.seed=2"));
}

TEST(BeltsCase, RefusesToJudgeYearsThatAreNotGrown) {
    EXPECT_NE(
        problem_of(small_belts(), few_years({"belts.judged_from_year=41"})).find("belts.judged_from_year 41"),
        std::string::npos);
}

TEST(ForestCase, SaysWhatChangesNothingWithoutRocks) {
    CaseChanges changes;
    changes.most_rocks = 20;
    changes.overrides = {"series.seed=3", "rockfall.preset=strict"};
    const ValidationCase of = read_case(shipped("forest_light"), changes);
    ASSERT_EQ(of.notes.size(), 3U);
    EXPECT_EQ(of.notes[0], "--rocks changes nothing here: no rock falls");
    EXPECT_EQ(of.notes[1], "series.seed changes nothing here: no rock falls");
    EXPECT_EQ(of.notes[2], "rockfall.preset changes nothing here: no rock falls");
}

TEST(ForestCase, RefusesAProfileAndUnknownSettings) {
    CaseChanges changes;
    changes.profile_file = "mine.csv";
    changes.profile_text = "distance_m,height_m,surface\n0,500,fine_debris\n600,0,\n";
    EXPECT_NE(problem_of(shipped("forest_light"), changes).find("--profile for forest_light"),
              std::string::npos);
    const auto with = [](const std::string& text) {
        CaseChanges one;
        one.overrides = {text};
        return one;
    };
    EXPECT_NE(problem_of(shipped("forest_light"), with("yield.ages_years=50")), "");
    EXPECT_NE(problem_of(shipped("forest_light"), with("case.kind=forest_yield")), "");
    EXPECT_NE(problem_of(shipped("vaujany_open"), with("case.kind=forest_yield")), "");
    EXPECT_NE(problem_of(small_yield(), with("yield.age_years=50")), "");
}

TEST(ForestCase, NamesAMissingTableAndAnUnknownFigure) {
    CaseFiles files = shipped("forest_light");
    files.texts.erase("trees.csv");
    EXPECT_NE(problem_of(files).find("forest_light/trees.csv"), std::string::npos);
    files = shipped("forest_light");
    files.texts["criteria.csv"] += "tree_light_bais:slope_6,0,1,independent,,\n";
    EXPECT_NE(problem_of(files).find("'tree_light_bias:slope_6'"), std::string::npos) << problem_of(files);
}

}  // namespace
}  // namespace coupling::validation::forest_cases::comparison_test
