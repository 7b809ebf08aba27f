#include "coupling/results/report/page_head.hpp"

#include "config/text/base64.hpp"
#include "config/text/joined.hpp"
#include "config/text/language.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::report {
namespace {

using config::joined;

std::string entry(const std::string& name, const std::string& value) {
    return value.empty() ? "" : joined("<div><dt>", name, "</dt><dd>", escaped(value), "</dd></div>");
}

std::string day_of(const ReportSettings& report) {
    const auto date = config::parse_date(report.date);
    return date ? config::for_people(*date, language_in_use()) : "";
}

}  // namespace

std::string page_head(const ReportSettings& report, const std::string& about) {
    const std::string heading = joined("<h1>", page_title(report, about), "</h1>\n");
    if (!has_head(report)) {
        return heading;
    }
    const std::string entries =
        joined(entry(page_text("Client"), report.client), entry(page_text("Place"), report.place),
               entry(page_text("Author"), report.author), entry(page_text("Date"), day_of(report)));
    const Logo& logo = report.picture;
    return joined("<header class=\"head\"><div>", heading,
                  report.title.empty() ? "" : joined("<p class=\"about\">", about, "</p>\n"),
                  entries.empty() ? "" : joined("<dl>", entries, "</dl>"), "</div>",
                  logo.bytes.empty() ? ""
                                     : joined("<img class=\"logo\" alt=\"", page_text("Logo"),
                                              "\" src=\"data:", logo.media_type, ";base64,",
                                              config::base64(logo.bytes), "\"/>"),
                  "</header>\n");
}

std::string page_title(const ReportSettings& report, const std::string& about) {
    return report.title.empty() ? about : escaped(report.title);
}

}  // namespace coupling::report
