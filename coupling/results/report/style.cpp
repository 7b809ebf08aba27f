#include "coupling/results/report/style.hpp"

namespace coupling::report {

std::string_view style() {
    return R"css(
:root{color-scheme:light dark;--ink:#1d2528;--soft:#566166;--paper:#fff;--ground:#f3f4f1;--line:#d5d9d4;
--forest:#00664f;--forest-fill:#00966e44;--bare:#b04a00;--bare-fill:#e07b2026;--note:#fff4d6}
@media (prefers-color-scheme:dark){:root{--ink:#e6eae8;--soft:#a3adaa;--paper:#1d2322;--ground:#141918;--line:#3a4341;
--forest:#3fc79f;--forest-fill:#3fc79f40;--bare:#ff9d52;--bare-fill:#ff9d5222;--note:#3b3216}}
*{box-sizing:border-box}
body{margin:0;background:var(--ground);color:var(--ink);font:16px/1.5 system-ui,-apple-system,"Segoe UI",Roboto,"Noto Sans","DejaVu Sans",sans-serif}
main{max-width:1180px;margin:0 auto;padding:24px 20px 60px}
h1{font-size:1.9rem;line-height:1.2;margin:.2em 0 .3em}
h2{font-size:1.3rem;margin:2.2em 0 .6em;border-bottom:2px solid var(--line);padding-bottom:.2em}
h3{font-size:1.1rem;margin:0 0 .4em}
p{margin:.5em 0;max-width:75ch}
figure p:last-child,section p:last-child{margin-bottom:0}
h2+h3,p+h3{margin-top:.6em}
.lead{font-size:1.05rem}
.soft,figure p,caption{color:var(--soft);font-size:.87rem}
section.card,figure,.facts{background:var(--paper);border:1px solid var(--line);border-radius:6px;padding:14px 16px;margin:0 0 16px}
section.card p.answer{font-size:1.12rem;max-width:none}
.facts{display:grid;grid-template-columns:repeat(auto-fit,minmax(150px,1fr));gap:10px 18px;margin-top:14px}
.facts div{min-width:0}
.facts dt{color:var(--soft);font-size:.82rem}
.facts dd{margin:0;font-weight:600;overflow-wrap:break-word}
.facts .row{grid-column:1/-1}
.mark{font-weight:400;font-size:.74rem;color:var(--soft);border:1px solid var(--line);border-radius:3px;padding:0 4px;white-space:nowrap}
.mark.given{color:inherit;border-color:currentColor}
dl.facts{margin-bottom:0}
.two{display:grid;grid-template-columns:minmax(260px,2fr) 3fr;gap:22px;align-items:center}
.halves,.thirds{display:grid;gap:14px;align-items:start;margin-bottom:14px}
.halves{grid-template-columns:repeat(auto-fill,minmax(min(430px,100%),1fr))}
.thirds{grid-template-columns:repeat(auto-fill,minmax(min(300px,100%),1fr))}
.halves>*,.thirds>*{margin:0;min-width:0}
svg{display:block;width:100%;height:auto}
svg.definitions{position:absolute;width:0;height:0}
svg text{font-family:inherit}
svg text:where(:not([fill])){fill:var(--ink)}
.chart svg text,.bars text{font-size:13px}
.chart svg text.small{font-size:11px;fill:var(--soft)}
.chart .grid{stroke:var(--line);stroke-width:1;fill:none}
.chart .axis{stroke:var(--ink);stroke-width:1;fill:none}
.chart .mark{stroke:var(--soft);stroke-width:1;stroke-dasharray:2 3}
ul.names{list-style:none;margin:.3em 0 .5em;padding:0;display:flex;flex-wrap:wrap;gap:.15em 1.1em;font-size:.85rem}
ul.names li{display:flex;align-items:center;gap:.45em}
ul.names svg{width:30px;height:14px;flex:none}
.chart svg text.word{font-weight:600;text-anchor:middle;stroke:var(--paper);stroke-width:3.5;stroke-linejoin:round;paint-order:stroke}
.chart svg text.letter{font-weight:700}
.forest{stroke:var(--forest);stroke-width:2;fill:none}
.bare{stroke:var(--bare);stroke-width:2;stroke-dasharray:6 4;fill:none}
.area.forest{fill:var(--forest-fill)}
.area.bare{fill:var(--bare-fill)}
.path0{stroke:var(--forest);stroke-width:1.8;fill:none}
.path1{stroke:var(--bare);stroke-width:1.8;stroke-dasharray:6 3;fill:none}
.path2{stroke:var(--soft);stroke-width:1.8;stroke-dasharray:2 3;fill:none}
.bars rect.forest{fill:var(--forest);stroke:none}
.bars rect.bare{fill:var(--bare-fill);stroke:var(--bare);stroke-width:1.5;stroke-dasharray:none}
.bars .whisker{stroke:var(--ink);stroke-width:1.6;fill:none}
.map{background:#fff;color:#1d2528}
.map svg text{fill:#1d2528}
.map p{color:#566166}
.map svg.legend{max-width:440px}
.map svg.legend text{font-size:13px}
.map svg.legend .tick{stroke:#555;stroke-width:.7}
.values{image-rendering:pixelated;mix-blend-mode:multiply}
.sheet .neat{fill:none;stroke:#333;stroke-width:1.5}
#sources .source{fill:none;stroke:#222;stroke-width:.5;vector-effect:non-scaling-stroke}
#targets .halo{fill:none;stroke:#fff;stroke-width:5.5;stroke-linejoin:round;stroke-linecap:round;vector-effect:non-scaling-stroke}
#targets .target{fill:none;stroke:#111;stroke-width:2.4;stroke-linejoin:round;stroke-linecap:round;vector-effect:non-scaling-stroke}
.net-view .edge,.names .edge{stroke:var(--ink)}
#targets .net{fill:none;stroke:#2458ad;stroke-width:2.8;stroke-dasharray:5 2;vector-effect:non-scaling-stroke}
.sheet text.name{font-weight:700;stroke:#fff;stroke-width:6;stroke-linejoin:round;paint-order:stroke}
.sheet .plate{fill:#fff;fill-opacity:.82}
.sheet .filled{fill:#1d2528;stroke:#1d2528;stroke-width:1}
.sheet .hollow{fill:#fff;stroke:#1d2528;stroke-width:1}
.sheet .coordinates path{stroke:#333;stroke-width:1}
.paths path{fill:none;stroke-linejoin:round;vector-effect:non-scaling-stroke}
.legend.paths path{stroke-opacity:1}
.paths .class0{stroke:#2c7fb8;stroke-width:.6;stroke-opacity:.75}
.paths .class1{stroke:#e66101;stroke-width:.9;stroke-opacity:.8}
.paths .class2{stroke:#67001f;stroke-width:1.5;stroke-opacity:.85}
table{border-collapse:collapse;font-size:.9rem;width:100%;font-variant-numeric:tabular-nums}
.wide{overflow-x:auto}.wide+.wide{margin-top:1.3em}.wide+.halves,.wide+.thirds{margin-top:16px}
caption{text-align:left;padding:0 0 .4em}
th,td{padding:.28em .6em;text-align:right;border-bottom:1px solid var(--line);vertical-align:top}
thead th{border-bottom:2px solid var(--line);font-weight:600;vertical-align:bottom}
th:first-child,td:first-child,td.text,th.text{text-align:left}
td.text{overflow-wrap:break-word}
tr.changed td:first-child{font-weight:700}
tr.changed td:first-child::after{content:" \25CF";color:var(--bare)}
tr.group th{padding-top:1em;text-align:left;color:var(--soft)}
code{font:.86em ui-monospace,"DejaVu Sans Mono",monospace}
.alert{background:var(--note);border:1px solid var(--bare);border-left-width:5px;border-radius:6px;padding:.6em 1em;margin:0 0 16px;font-size:.92rem}
.alert ul{margin:.25em 0 0;padding-left:1.3em}.alert li{overflow-wrap:anywhere}.alert details{margin:.3em 0 0}
ul.notes{background:var(--note);border:1px solid var(--line);border-radius:6px;padding:.7em 1em .7em 2em;margin:0}
fieldset.switches{border:0;margin:0 0 1em;padding:0}
.switches label{margin-right:1.4em;white-space:nowrap}
main:has(#show-sources:not(:checked)) use.sources,main:has(#show-targets:not(:checked)) .targets,
main:has(#show-hillshade:not(:checked)) use.shade{display:none}
.live .drawn{height:310px;width:100%;outline-offset:2px}
.live ul.names button{all:unset;display:flex;align-items:center;gap:.45em;cursor:pointer;border-radius:3px}
.live ul.names span{display:flex;align-items:center;gap:.45em}
.live ul.names button:focus-visible{outline:2px solid var(--blue,#2458ad);outline-offset:2px}
.live ul.names button[aria-pressed=false]{opacity:.4;text-decoration:line-through}
.tip{display:grid;gap:.1em;font-size:.85rem}
.tip div{display:grid;grid-template-columns:30px 1fr auto;gap:.5em;align-items:center}
.tip svg{width:30px;height:14px}
.tip small{color:var(--soft)}
.scene .stage{position:relative;margin:.5em 0}
.scene canvas{display:block;width:100%;border-radius:4px;touch-action:none;cursor:grab}
.scene canvas:focus-visible{outline:3px solid var(--bare);outline-offset:1px}
.scene .compass{position:absolute;right:12px;top:10px;width:34px;text-align:center;color:#1d2528;pointer-events:none;background:#ffffffb8;border-radius:4px;font-size:.8rem;line-height:1.1}
.scene .compass svg{width:30px;height:30px;margin:auto}
.scene .scale{position:absolute;left:14px;bottom:12px;border:solid #1d2528;border-width:0 2px 2px;background:#ffffffb8;color:#1d2528;font-size:.78rem;text-align:center;line-height:1.25;pointer-events:none;min-width:2.5em}
.scene .switches{display:flex;flex-wrap:wrap;gap:.4em 1.2em;align-items:center;font-size:.9rem}
.scene .years{display:flex;align-items:center;gap:.4em}.scene .years output{display:inline-block;min-width:5em;font-weight:600}
.scene .years input{width:220px}
.scene .map-legend{background:#fff;color:#1d2528;border-radius:4px;font-size:.85rem}
.scene .map-legend:empty{display:none}
.scene .map-legend svg{max-width:440px}.scene .map-legend text{fill:#1d2528;font-size:13px}
details{margin:0 0 .8em}summary{cursor:pointer;font-weight:600;padding:.2em 0}
.map-choice svg.sheet{max-width:820px}.map-choice .switches{display:flex;flex-wrap:wrap;gap:.4em 1.2em;margin-bottom:.6em}
@media screen{.is-live>svg,.is-live>ul.names,.is-live>.paper{display:none}}
@media print{.chart .live,.only-live,.scene .switches,.scene:not(.is-live),h2:has(+.scene:not(.is-live)){display:none!important}}
@media (max-width:700px){main{padding:14px 10px 40px}.two{grid-template-columns:1fr}}
@media print{
@page{size:A4;margin:12mm}
:root{font-size:13px;color-scheme:light;--ink:#000;--soft:#444;--paper:#fff;--ground:#fff;--line:#bbb;--forest:#00664f;--bare:#b04a00;--note:#fff}
body{font-size:1rem}main{max-width:none;padding:0}h2+p,h3+p{break-after:avoid}
section.card,figure,.facts{padding:7px 8px;margin-bottom:8px}
*{-webkit-print-color-adjust:exact;print-color-adjust:exact}
figure,section.card,tr{break-inside:avoid}h2,h3{break-after:avoid}
.halves{grid-template-columns:1fr 1fr}.thirds{grid-template-columns:1fr 1fr 1fr}.thirds:has(.chart){grid-template-columns:1fr 1fr}.thirds,.halves{gap:8px}
.switches{display:none}.wide{overflow:visible}table{font-size:.85rem}th,td{padding:.2em .35em}}
)css";
}

}  // namespace coupling::report
