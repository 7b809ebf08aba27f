#include "coupling/results/report/page_frame.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "config/text/joined.hpp"
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

/// The title at the foot of printed pages. A string of CSS knows no entities of HTML, and must not end its
/// element.
std::string running_title(std::string_view title) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 6> written{{{"&amp;", "&"},
                                                                                    {"&lt;", "\\3c "},
                                                                                    {"&gt;", "\\3e "},
                                                                                    {"&quot;", "\\22 "},
                                                                                    {"\"", "\\22 "},
                                                                                    {"\\", "\\5c "}}};
    std::string text;
    while (!title.empty()) {
        const auto special = std::find_if(written.begin(), written.end(),
                                          [&](const auto& one) { return title.starts_with(one.first); });
        const bool is_special = special != written.end();
        text += is_special ? special->second : title.substr(0, 1);
        title.remove_prefix(is_special ? special->first.size() : 1);
    }
    return config::joined("@page{@bottom-left{content:\"", text, "\"}}");
}

}  // namespace

void begin_page(std::ostream& out, const PageFrame& frame) {
    out << filled_template("page_begin.html",
                           {{"language", std::string{config::tag_of(language_in_use())}},
                            {"policy", page_scripts::policy(frame.scripts)},
                            {"version", frame.version},
                            {"title", frame.title},
                            {"shared_style", std::string{page_file("page.css")}},
                            {"style", config::joined(running_title(frame.title), frame.style)},
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
