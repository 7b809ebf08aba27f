#include "coupling/results/finish.hpp"

#include <utility>

#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/excel_csv.hpp"
#include "coupling/results/gis_files.hpp"
#include "coupling/results/text/writing_language.hpp"
#include "coupling/results/workbook.hpp"

namespace coupling {
namespace {

/// The workbook of a run without a map.
void add_workbook(const std::filesystem::path& folder, const std::vector<TableLayout>& layouts,
                  std::vector<WrittenFile>& files, const WriteWatch& watch) {
    std::vector<std::pair<WrittenFile, std::filesystem::path>> tables;
    for (const WrittenFile& file : files) {
        if (file.path.ends_with(".csv")) {
            tables.emplace_back(file, folder / file.path);
        }
    }
    write_workbook(folder / "results.xlsx", tables, layouts, watch);
    files.push_back({"results.xlsx", workbook_sentence});
}

}  // namespace

void finish_results(const std::filesystem::path& folder, const Finish& finish,
                    std::vector<WrittenFile>& files, const WriteWatch& watch) {
    add_data_dictionary(folder, finish.dictionary, files);
    const GisFiles& wanted = finish.scenario.output.gis;
    if (finish.drawn != nullptr) {
        const report::WritingLanguage language{finish.scenario.report.language};
        const std::vector<WrittenFile> gis =
            write_gis_files(folder, wanted, *finish.drawn, files, finish.dictionary.tables, finish.streamed,
                            finish.paths, watch, finish.areas);
        files.insert(files.end(), gis.begin(), gis.end());
    } else if (wanted.workbook) {
        add_workbook(folder, finish.dictionary.tables, files, watch);
    }
    watch("summary.json");
    OutFile summary{folder / "summary.json"};
    finish.summary(summary.stream(), files);
    summary.close();
    watch("report.html");
    OutFile page{folder / "report.html"};
    finish.page(page.stream(), files);
    page.close();
}

void turn_tables_into_excel(const std::filesystem::path& folder, const Scenario& scenario) {
    if (scenario.output.gis.csv == CsvForm::excel) {
        turn_into_excel_csv(folder / "tables", config::decimal_sign(scenario.report.language));
    }
}

}  // namespace coupling
