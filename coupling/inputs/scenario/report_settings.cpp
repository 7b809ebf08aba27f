#include "coupling/inputs/scenario/report_settings.hpp"

#include <array>
#include <utility>

#include "config/text/joined.hpp"

namespace coupling {
namespace {

using config::joined;

/// A heading, not a chapter.
constexpr std::size_t longest_heading_bytes = 400;

}  // namespace

void declare(config::Options& options, ReportSettings& report) {
    options.text("report.title", report.title, {.meaning = "title of the page; none: what it is about"});
    options.text("report.client", report.client, {.meaning = "for whom the page is made"});
    options.text("report.author", report.author, {.meaning = "who made it"});
    options.text("report.place", report.place, {.meaning = "the place it is about"});
    options.text("report.date", report.date,
                 {.meaning = "date of the page, as 2026-11-24 or 24.11.2026; none: no date"});
    options.file("report.logo", report.logo,
                 {.meaning = "PNG, JPEG or SVG file, which becomes part of the page"});
    options.choice(
        "report.language", report.language,
        {{"en", config::Language::en},
         {"de", config::Language::de},
         {"fr", config::Language::fr},
         {"it", config::Language::it},
         {"de_CH", config::Language::de_CH},
         {"fr_CH", config::Language::fr_CH}},
        {.meaning = "language of pages and workbooks: English, German, French, Italian, German and French of "
                    "Switzerland",
         .source = "choice"});
}

void check(const ReportSettings& report, const config::Options& options, config::Problems& problems) {
    const std::array<std::pair<const char*, const std::string*>, 4> texts{{{"report.title", &report.title},
                                                                           {"report.client", &report.client},
                                                                           {"report.author", &report.author},
                                                                           {"report.place", &report.place}}};
    for (const auto& [key, text] : texts) {
        if (text->size() > longest_heading_bytes) {
            problems.add(config::ExitCode::settings, options.place_of(key),
                         joined(key, " of ", std::to_string(text->size()), " bytes"),
                         joined("at most ", std::to_string(longest_heading_bytes)),
                         "shorten it: it stands in the heading of the page");
        }
    }
    if (!report.date.empty() && !config::parse_date(report.date)) {
        problems.add(config::ExitCode::settings, options.place_of("report.date"),
                     joined("report.date '", report.date, "'"), "a day such as 2026-11-24 or 24.11.2026",
                     "correct the date or leave it out");
    }
}

bool has_head(const ReportSettings& report) {
    return !report.title.empty() || !report.client.empty() || !report.author.empty() ||
           !report.place.empty() || !report.date.empty() || !report.logo.empty();
}

}  // namespace coupling
