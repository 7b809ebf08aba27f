#include "coupling/results/report/page_frame.hpp"

#include "coupling/page_scripts/json_text.hpp"
#include "coupling/results/templates/page_files.hpp"
#include "coupling/results/text/markup.hpp"
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
    out << "<!DOCTYPE html>\n<html lang=\"" << config::tag_of(language_in_use())
        << "\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        << page_scripts::policy(frame.scripts)
        << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
           "<meta name=\"generator\" content=\"Bannwald "
        << escaped(frame.version) << "\"/>\n<title>" << frame.title << "</title>\n<style>"
        << page_file("page.css") << frame.style << "</style>\n</head>\n<body>\n"
        << frame.before_main << "<main>\n";
}

void end_page(std::ostream& out, const PageFrame& frame) {
    out << "</main>\n";
    if (!frame.scripts.empty()) {
        out << page_scripts::data("page-texts", texts_of_scripts()) << '\n'
            << page_scripts::elements(frame.scripts);
    }
    out << "</body>\n</html>\n";
}

}  // namespace coupling::report
