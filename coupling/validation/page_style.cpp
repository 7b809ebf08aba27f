#include "coupling/validation/page_parts.hpp"

namespace coupling::validation {

std::string_view page_style() {
    return R"css(
:root{--blue:#2458ad;--violet:#7c3aa6;--grey:#5c6468;--rose:#a8205f;--sand:#7d6200;--default-band:#00966e30;--strict-band:#e07b2030}
@media (prefers-color-scheme:dark){:root{--blue:#86b4ff;--violet:#d09df2;--grey:#b4bcb9;--rose:#ff8fbf;--sand:#e0c25a;
--default-band:#3fc79f38;--strict-band:#ff9d5230}}
.line{fill:none}
.default{stroke:var(--forest);stroke-width:2.4;fill:none}
.strict{stroke:var(--bare);stroke-width:2;stroke-dasharray:7 4;fill:none}
.other0{stroke:var(--blue);stroke-width:2;stroke-dasharray:1.5 3.5;fill:none}
.other1{stroke:var(--violet);stroke-width:2;stroke-dasharray:9 3 2 3;fill:none}
.other2{stroke:var(--grey);stroke-width:1.6;stroke-dasharray:14 5;fill:none}
.other3{stroke:var(--rose);stroke-width:1.6;stroke-dasharray:9 3 2 3 2 3;fill:none}
.other4{stroke:var(--sand);stroke-width:1.6;stroke-dasharray:4 2;fill:none}
.area.default,.band.default{fill:var(--default-band)}
.area.strict,.band.strict{fill:var(--strict-band)}
.band.default,.band.strict{stroke-width:.8;stroke-dasharray:none}
.band.strict{stroke-dasharray:3 2}
.dot{stroke:var(--ink);stroke-width:1.8}
.dot.observed{fill:var(--ink)}
.dot.published{fill:var(--paper)}
.dot.default{fill:var(--forest);stroke:none}
.dot.strict{fill:var(--paper);stroke:var(--bare);stroke-dasharray:none}
.dot.other0{fill:var(--blue);stroke:none}
.dot.other1{fill:var(--paper);stroke:var(--violet);stroke-dasharray:none}
.whiskers{stroke-dasharray:none;stroke-width:1.2}
.dot.tree{fill:var(--forest);fill-opacity:.35;stroke:none;r:2.6px}
.band[class*=layer]{stroke:var(--paper);stroke-width:.7;stroke-dasharray:none}
.layer0{fill:#0072b2}.layer1{fill:#e69f00}.layer2{fill:#009e73}.layer3{fill:#cc79a7}.layer4{fill:#56b4e9}.layer5{fill:#d55e00}
.layer6{fill:#f0e442}.layer7{fill:#8a8f91}
.equal{stroke:var(--soft);stroke-width:1.2;stroke-dasharray:4 3;fill:none}
.level{stroke:var(--soft);stroke-width:1;stroke-dasharray:2 3;fill:none}
.profile .ground{stroke:var(--ink);stroke-width:2;fill:none}
.profile .change{stroke:var(--soft);stroke-width:1;fill:none}
.profile text{font-size:13px}
.profile .letter{font-weight:700}
.chart.profile>svg{max-width:860px}
ul.notes+section.card{margin-top:14px}
.words dt{color:var(--ink);font-weight:600;font-size:.95rem}
.words dd{font-weight:400;font-size:.92rem}
.badge{display:inline-block;border:1.5px solid var(--forest);border-radius:4px;padding:0 .4em;font-size:.82rem;font-weight:600;
line-height:1.35;color:var(--forest);white-space:nowrap}
.badge.missed{background:var(--bare);border-color:var(--bare);color:var(--paper)}
td .badge{margin-left:.3em}
td .line{white-space:nowrap}
td .interval,td small{font-size:.8rem;color:var(--soft)}
td small,th small{display:block}
td small{white-space:nowrap}
sup{font-size:.7em;line-height:0;color:var(--soft)}
ol.sources{font-size:.82rem;color:var(--soft);margin:.4em 0 1em;padding-left:1.6em}
ul.causes{margin:.4em 0 1em;padding-left:1.3em}
ul.causes li{margin:.25em 0;max-width:85ch}
nav.cases{display:flex;flex-wrap:wrap;gap:.2em 1.2em}
a{color:inherit}
th.text small{font-weight:400}
tbody th{text-align:left;font-weight:400}
@media print{.badge.missed{background:#fff;color:#000;border:2px solid #000}.badge{color:#000;border-color:#777}h2{break-before:auto}
ol.sources{columns:2}}
)css";
}

}  // namespace coupling::validation
