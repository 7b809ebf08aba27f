#include "coupling/results/report/page_frame.hpp"

#include "coupling/page_scripts/json_text.hpp"
#include "coupling/results/templates/page_files.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/script_texts.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::report {
namespace {

/// The texts that scripts write, by key, as JSON.
std::string texts_of_scripts() {
    page_scripts::JsonObject texts;
    for (const auto& [key, text] : script_texts()) {
        texts.text(key, text);
    }
    return texts.json();
}

}  // namespace

void begin_page(std::ostream& out, const PageFrame& frame) {
    out << filled_template("page_begin.html", {{"language", std::string{config::tag_of(language_in_use())}},
                                               {"policy", page_scripts::policy(frame.scripts)},
                                               {"version", frame.version},
                                               {"title", frame.title},
                                               {"shared_style", std::string{page_file("page.css")}},
                                               {"style", frame.style},
                                               {"before_main", frame.before_main}});
}

void end_page(std::ostream& out, const PageFrame& frame) {
    std::vector<PageFields> scripts;
    for (const page_scripts::Script& script : frame.scripts) {
        scripts.push_back({{"script", std::string{script.text}}});
    }
    out << filled_template(
        "page_end.html",
        {{"has_scripts", !frame.scripts.empty()}, {"texts", texts_of_scripts()}, {"scripts", scripts}});
}

}  // namespace coupling::report
