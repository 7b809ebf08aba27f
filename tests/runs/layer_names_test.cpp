// Layers, groups and legends in GIS programs are in the language of the page: none has the name that it has
// in English. Names in files (layers of results.gpkg, tables, grids) stay, as scripts use them.

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

#include "coupling/results/pack/zip_file.hpp"
#include "tests/runs/hazard.hpp"
#include "tests/runs/lambert.hpp"
#include "tests/runs/nets.hpp"
#include "tests/runs/years.hpp"

namespace coupling::layer_names_test {
namespace {

using Names = std::vector<std::string>;

/// What stands between two texts, wherever it does; nothing that is empty.
Names all_between(const std::string& text, const std::string& begin, const std::string& end) {
    Names found;
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
        at += begin.size();
        const std::size_t close = text.find(end, at);
        if (close != at) {
            found.push_back(text.substr(at, close - at));
        }
    }
    return found;
}

/// Titles and legends of a folder of results, in their order; those of tables without places are left out.
Names titles_in(const SampleProject& project, const std::string& folder) {
    const std::string tree = project.read(folder + "/results.qlr");
    Names titles = all_between(tree, "<layer-tree-group name=\"", "\"");
    const auto add = [&](const Names& more) {
        EXPECT_FALSE(more.empty()) << folder;
        titles.insert(titles.end(), more.begin(), more.end());
    };
    for (const std::string& layer : all_between(tree, "<maplayer", "</maplayer>")) {
        if (layer.find("No geometry") == std::string::npos) {
            add(all_between(layer, "<layername>", "<"));
        }
    }
    add(all_between(tree, " label=\"", "\""));
    const std::string kml =
        pack::ZipReader{project.file(folder + "/results.kmz")}.text("doc.kml", 100'000'000);
    add(all_between(kml, "<Document>\n<name>Bannwald</name>\n<description>", "<"));
    for (const std::string& head : all_between(kml, "<Folder>", "<Placemark>")) {
        add(all_between(head, "<name>", "<"));
        add(all_between(head, "<description>", "<"));
    }
    add(all_between(project.read(folder + "/results.gpx"), "<name>", "<"));
    return titles;
}

/// Numbers with their unit and names of the project are the same in all languages.
bool has_no_words(const std::string& title, const std::set<std::string>& names) {
    static const std::regex number{"[-0-9.,e+ ]*( (kJ|m|%|deg|m/s|-|m3/ha|m2/ha|1/ha))?"};
    return names.contains(title) || std::regex_match(title, number);
}

/// Each title differs from that of the run in English, whose sources are the same.
void expect_translated(const SampleProject& project, const std::string& english, const std::string& other,
                       const std::set<std::string>& names) {
    const Names before = titles_in(project, english);
    const Names after = titles_in(project, other);
    ASSERT_EQ(before.size(), after.size()) << other;
    std::size_t translated = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (!has_no_words(before[i], names)) {
            EXPECT_NE(before[i], after[i]) << other;
            ++translated;
        }
    }
    EXPECT_GT(translated, 30U);
    EXPECT_EQ(all_between(project.read(english + "/results.qlr"), "<datasource>", "<"),
              all_between(project.read(other + "/results.qlr"), "<datasource>", "<"));
}

constexpr const char* for_people = "--set output.kml=yes --set output.gpx=yes ";

TEST(LayerNames, OfTodayAreInTheLanguageOfThePage) {
    const SampleProject project;
    project.write("dem.prj", lambert);
    add_nets(project);
    const std::string run =
        std::string{"run scenario.ini --quiet --set release.rocks=300 --set output.sample_paths=20 "} +
        for_people;
    ASSERT_EQ(call(project, run + "--out en").code, 0);
    for (const std::string language : {"de", "fr", "it", "de_CH"}) {
        ASSERT_EQ(call(project, run + "--set report.language=" + language + " --out " + language).code, 0);
        expect_translated(project, "en", language, {"Bannwald"});
    }
}

TEST(LayerNames, OfHazardMapsAreInTheLanguageOfThePage) {
    const SampleProject project;
    project.write("dem.prj", lambert);
    add_blocks(project);
    project.write("blocks.csv", "return_period_years,diameter_m\n30,0.5\n300,1.2\n");
    const std::string run = std::string{"run scenario.ini --quiet --set release.rocks=60 "} + for_people;
    ASSERT_EQ(call(project, run + "--out en").code, 0);
    for (const std::string language : {"de", "fr", "it"}) {
        ASSERT_EQ(call(project, run + "--set report.language=" + language + " --out " + language).code, 0);
        expect_translated(project, "en/hazard", language + "/hazard", {"Bannwald"});
        expect_translated(project, "en/return_period_30", language + "/return_period_30", {"Bannwald"});
    }
}

TEST(LayerNames, OfYearsAreInTheLanguageOfThePage) {
    const ForestProject project;
    project.write("dem.prj", lambert);
    const std::string run = std::string{four_members} + for_people;
    ASSERT_EQ(call(project, run + "--out en").code, 0);
    for (const std::string language : {"de", "fr", "it"}) {
        ASSERT_EQ(call(project, run + "--set report.language=" + language + " --out " + language).code, 0);
        expect_translated(project, "en", language, {"Bannwald", "none", "single_tree_selection"});
    }
}

}  // namespace
}  // namespace coupling::layer_names_test
