#include "coupling/results/report/page_head.hpp"

#include <optional>

#include "config/text/base64.hpp"
#include "config/text/language.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::report {
namespace {

std::optional<PageFields> entry(const std::string& value) {
    return value.empty() ? std::nullopt : std::optional{PageFields{{"entry", value}}};
}

std::optional<PageFields> picture_of(const Logo& logo) {
    return logo.bytes.empty() ? std::nullopt
                              : std::optional{PageFields{{"media_type", logo.media_type},
                                                         {"bytes", config::base64(logo.bytes)}}};
}

std::string day_of(const ReportSettings& report) {
    const auto date = config::parse_date(report.date);
    return date ? config::for_people(*date, language_in_use()) : "";
}

}  // namespace

std::string page_head(const ReportSettings& report, const std::string& about) {
    const std::string day = day_of(report);
    return filled_template("page_head.html",
                           {{"has_head", has_head(report)},
                            {"title", page_title(report, about)},
                            {"has_own_title", !report.title.empty()},
                            {"about", about},
                            {"has_entries", !(report.client.empty() && report.place.empty() &&
                                              report.author.empty() && day.empty())},
                            {"client", entry(report.client)},
                            {"place", entry(report.place)},
                            {"author", entry(report.author)},
                            {"day", entry(day)},
                            {"logo", picture_of(report.picture)}});
}

std::string page_title(const ReportSettings& report, const std::string& about) {
    return report.title.empty() ? about : escaped(report.title);
}

}  // namespace coupling::report
