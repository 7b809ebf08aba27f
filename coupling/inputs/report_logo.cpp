#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <cctype>
#include <cstdint>
#include <string>

#include "config/text/joined.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/scenario/report_settings.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr std::size_t most_logo_bytes = 2'000'000;
constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

std::uint32_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
        value = (value << 8U) | static_cast<unsigned char>(bytes[at + i]);
    }
    return value;
}

/// Of the kind and the data of a chunk.
std::uint32_t crc_32(std::string_view bytes) {
    boost::crc_32_type crc;
    crc.process_bytes(bytes.data(), bytes.size());
    return crc.checksum();
}

/// Why the bytes of a PNG (ISO/IEC 15948) are not whole; empty: they are.
std::string fault_of_png(std::string_view bytes) {
    std::size_t at = png_signature.size();
    bool has_size = false;
    while (at + 12 <= bytes.size()) {
        const std::size_t length = big_endian(bytes, at, 4);
        const std::string_view kind = bytes.substr(at + 4, 4);
        if (length > bytes.size() - at - 12) {
            break;
        }
        if (crc_32(bytes.substr(at + 4, length + 4)) != big_endian(bytes, at + 8 + length, 4)) {
            return joined("a damaged PNG: its chunk at byte ", std::to_string(at), " has another checksum");
        }
        if (kind == "IHDR" && length == 13) {
            has_size = big_endian(bytes, at + 8, 4) > 0 && big_endian(bytes, at + 12, 4) > 0;
        }
        if (kind == "IEND") {
            return has_size ? "" : "a PNG without a size";
        }
        at += length + 12;
    }
    return "a PNG that ends before its end (chunk IEND)";
}

/// The same of a JPEG (ITU-T T.81).
std::string fault_of_jpeg(std::string_view bytes) {
    std::size_t at = 2;
    while (at + 4 <= bytes.size() && bytes[at] == '\xff') {
        const auto marker = static_cast<unsigned char>(bytes[at + 1]);
        const std::size_t length = big_endian(bytes, at + 2, 2);
        if (marker == 0xda) {  // pixels follow up to the mark of the end
            const std::size_t end = bytes.rfind("\xff\xd9");
            return end != std::string_view::npos && end > at ? std::string{}
                                                             : "a JPEG that ends before its end";
        }
        if (length < 2) {
            break;
        }
        at += length + 2;
    }
    return "a JPEG that ends before its pixels";
}

/// Past blanks, declaration, comments and document type of an XML text.
std::size_t root_of(std::string_view xml) {
    std::size_t at = xml.starts_with("\xef\xbb\xbf") ? 3 : 0;
    while (at < xml.size()) {
        at = std::min(xml.find_first_not_of(" \t\r\n", at), xml.size());
        const std::string_view rest = xml.substr(at);
        const std::string_view end = rest.starts_with("<?")     ? "?>"
                                     : rest.starts_with("<!--") ? "-->"
                                     : rest.starts_with("<!")   ? ">"
                                                                : "";
        if (end.empty()) {
            return at;
        }
        const std::size_t found = xml.find(end, at + 2);
        at = found == std::string_view::npos ? xml.size() : found + end.size();
    }
    return xml.size();
}

/// An address that leads out of the drawing.
bool leads_out(std::string_view lower, std::string_view before) {
    for (std::size_t at = lower.find(before); at != std::string_view::npos; at = lower.find(before, at + 1)) {
        const std::size_t begin = lower.find_first_not_of(" \t\r\n=\"'", at + before.size());
        const std::string_view address = begin == std::string_view::npos ? "" : lower.substr(begin);
        if (!address.starts_with('#') && !address.starts_with("data:")) {
            return true;
        }
    }
    return false;
}

std::string fault_of_svg(std::string_view bytes) {
    const std::string lower = config::in_lower_case(bytes);
    constexpr std::array scripts{"<script", "javascript:", "<foreignobject", "<!entity", "@import"};
    for (const char* script : scripts) {
        if (lower.find(script) != std::string::npos) {
            return joined("an SVG with \"", script, "\"");
        }
    }
    if (leads_out(lower, "href") || leads_out(lower, "url(")) {
        return "an SVG with an address outside of it";
    }
    const std::size_t end_of_root_tag = lower.find('>', root_of(bytes));
    const bool is_empty_drawing =
        end_of_root_tag != std::string::npos && end_of_root_tag > 0 && lower[end_of_root_tag - 1] == '/';
    return is_empty_drawing || lower.find("</svg>") != std::string::npos
               ? ""
               : "an SVG that ends before its end (</svg>)";
}

}  // namespace

Logo read_logo(std::string_view bytes, const config::Place& place) {
    const auto refuse = [&](const std::string& found) {
        config::fail(config::ExitCode::data, place, found, "a whole PNG, JPEG or SVG of at most 2 MB",
                     "export the logo again, drawings without scripts and links, or leave report.logo out");
    };
    const auto checked = [&](const char* media_type, const std::string& fault) {
        if (!fault.empty()) {
            refuse(fault);
        }
        return Logo{media_type, std::string{bytes}};
    };
    if (bytes.size() > most_logo_bytes) {
        refuse(joined(std::to_string(bytes.size()), " bytes"));
    }
    if (bytes.starts_with(png_signature)) {
        return checked("image/png", fault_of_png(bytes));
    }
    if (bytes.starts_with("\xff\xd8\xff")) {
        return checked("image/jpeg", fault_of_jpeg(bytes));
    }
    if (config::in_lower_case(bytes.substr(root_of(bytes), 4)) == "<svg") {
        return checked("image/svg+xml", fault_of_svg(bytes));
    }
    refuse(bytes.empty() ? "an empty file" : "a file that is no picture of these kinds");
    return {};
}

}  // namespace coupling
