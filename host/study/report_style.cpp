#include "study/report.h"

namespace capcon {

// Colours after Okabe and Ito, darkened on light and lightened on dark grounds; markers tell the lines apart
// without them.
std::string_view report_style() {
  return R"(
:root{--ground:#fdfdfb;--ink:#1c1f23;--soft:#5d646d;--rule:#d9dbd6;--faint:#eeefeb;--panel:#f5f5f1;--good:#00704d;--bad:#b03a16;
--c0:#6d6d6d;--c1:#8f4fa0;--c2:#b87100;--c3:#0060a8;--c4:#007d58;--c5:#cf3310;--c6:#3f8fb5;--c7:#7a6a1e}
@media (prefers-color-scheme:dark){:root{--ground:#15181c;--ink:#e6e7e4;--soft:#a0a7b0;--rule:#3b4149;--faint:#262b31;--panel:#1d2126;
--good:#4fd3a4;--bad:#ff9472;--c0:#b4b4b4;--c1:#d49ce2;--c2:#efb13e;--c3:#66b5f5;--c4:#3fcb9d;--c5:#ff7350;--c6:#8fd0ee;--c7:#d8c766}}
*{box-sizing:border-box}
body{margin:0 auto;max-width:1180px;padding:2rem 1.25rem 4rem;background:var(--ground);color:var(--ink);
font:16px/1.55 system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue","DejaVu Sans",sans-serif}
h1{font-size:2rem;line-height:1.2;margin:.1em 0 .3em;letter-spacing:-.01em}
h2{font-size:1.35rem;margin:3rem 0 .8rem;padding-top:.8rem;border-top:1px solid var(--rule)}
h3{font-size:1rem;margin:1.6rem 0 .4rem}
p,ul,dl{max-width:76ch}
.kicker{margin:0;color:var(--soft);font-size:.85rem;letter-spacing:.04em}
.small,figcaption{color:var(--soft);font-size:.85rem}
.headline{font-size:1.3rem;line-height:1.4;font-weight:600}
li{margin:.35em 0}
.skip{position:absolute;left:-999px}.skip:focus{left:1rem;top:1rem;background:var(--panel);padding:.5rem}
:focus-visible{outline:2px solid var(--c3);outline-offset:2px}
figure{margin:0}
figcaption{margin-top:.25rem}
.charts{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,470px),1fr));gap:1.5rem 2rem}
.charts h3{margin-top:0}
.chart{display:block;width:100%;height:auto;overflow:visible}
.chart text{fill:var(--soft);font-size:12px}
.chart .axis{font-size:13px;fill:var(--ink)}
.chart .major{stroke:var(--rule);stroke-width:1}
.chart .minor{stroke:var(--faint);stroke-width:1}
.chart .one{stroke:var(--soft);stroke-width:1.8}
.chart .line{fill:none;stroke:var(--c);stroke-width:1.6;stroke-linejoin:round}
.chart .strong .line{stroke-width:2.8}
.chart .line.companion{stroke-width:1.3;stroke-dasharray:4 3}
.chart .bar{stroke:var(--c);stroke-width:1.5}
.chart .hollow{fill:var(--ground);stroke:var(--c);stroke-width:1.5}
.chart .tie{fill:none;stroke:var(--c);stroke-width:.8;opacity:.6}
.chart .name{fill:var(--c);font-size:13px}
.chart .strong .name{font-weight:700}
.mark{fill:var(--c)}
.s0{--c:var(--c0)}.s1{--c:var(--c1)}.s2{--c:var(--c2)}.s3{--c:var(--c3)}.s4{--c:var(--c4)}.s5{--c:var(--c5)}.s6{--c:var(--c6)}.s7{--c:var(--c7)}
.key{width:.8em;height:.8em;margin-right:.35em;vertical-align:-.05em}
.scroll{overflow-x:auto;max-width:100%;margin:1.2rem 0}
table{border-collapse:collapse;font-variant-numeric:tabular-nums;font-size:.88rem;width:100%}
caption{text-align:left;font-weight:600;padding-bottom:.4rem}
th,td{text-align:right;padding:.28rem .7rem;border-bottom:1px solid var(--faint);white-space:nowrap;vertical-align:top}
thead th{border-bottom:1px solid var(--rule);font-weight:600}
th:first-child{text-align:right;color:var(--soft);font-weight:600;width:4.5rem}
.figure{display:block}
.interval{display:block;color:var(--soft);font-size:.78rem}
.none{color:var(--soft)}
.best{font-weight:700;text-decoration:underline;text-underline-offset:3px}
.better{color:var(--good)}.worse{color:var(--bad)}
.figure.better::before{content:"▼ ";font-size:.7em}.figure.worse::before{content:"▲ ";font-size:.7em}
.pair{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,720px),1fr));gap:0 2rem}
.pair th,.pair td{padding:.28rem .45rem}
.pictures{display:flex;flex-wrap:wrap;gap:1.25rem}
.overview{flex:1 1 400px;max-width:560px}
.framed{position:relative}
.framed img,.views img{display:block;width:100%;height:auto;image-rendering:pixelated}
.framed svg{position:absolute;inset:0;width:100%;height:100%}
.framed rect{vector-effect:non-scaling-stroke}
.halo{fill:none;stroke:#000;stroke-width:4;opacity:.6}.frame{fill:none;stroke:#ffd24a;stroke-width:2}
.views{display:grid;grid-template-columns:repeat(var(--n),minmax(130px,1fr));gap:.7rem .6rem}
.views figcaption{margin:.15rem 0 0;white-space:nowrap}
dl{display:grid;grid-template-columns:minmax(8rem,max-content) 1fr;gap:.45rem 1.2rem;max-width:100ch}
dt{font-weight:600}dd{margin:0;overflow-wrap:anywhere}
code{font:.88em/1.4 ui-monospace,"DejaVu Sans Mono",monospace}
@media (max-width:560px){dl{grid-template-columns:1fr;gap:.1rem}dd{margin-bottom:.6rem}}
@media print{.overview{flex:1 1 40%}:root{--ground:#fff;--ink:#000;--soft:#444;--rule:#bbb;--faint:#ddd;--panel:#fff;--good:#00583c;--bad:#8c2b0d;
--c0:#6d6d6d;--c1:#8f4fa0;--c2:#b87100;--c3:#0060a8;--c4:#007d58;--c5:#cf3310;--c6:#3f8fb5;--c7:#7a6a1e}
body{max-width:none;padding:0;font-size:10pt}.skip{display:none}h2{break-after:avoid}h3{break-after:avoid}
figure,.views,tr{break-inside:avoid}.scroll{overflow:visible}.charts{grid-template-columns:1fr 1fr;gap:1rem}
.views{grid-template-columns:repeat(var(--n),1fr)}table{font-size:8pt}.pair{grid-template-columns:1fr}th,td{padding:.15rem .4rem}}
)";
}

}  // namespace capcon
