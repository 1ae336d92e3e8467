#include "report/sections.hpp"

namespace trilith::report {

const char* report_style() {
  return R"css(
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { margin: 0; background: #e9e8e4; color: #1d2126; font: 15px/1.5 "Source Serif 4", Charter, "Bitstream Charter",
  "Noto Serif", "DejaVu Serif", Georgia, serif; }
main { max-width: 210mm; margin: 24px auto; padding: 18mm 15mm; background: #fff; box-shadow: 0 1px 6px #0002; }
h1, h2, h3, table, figcaption, time, .kind, .by, .warning, summary { font-family: "Source Sans 3", "Noto Sans",
  "Helvetica Neue", Arial, "Liberation Sans", "DejaVu Sans", sans-serif; }
h1 { font-size: 30px; line-height: 1.15; margin: 0; overflow-wrap: anywhere; }
h2 { font-size: 18px; margin: 30px 0 8px; padding-top: 10px; border-top: 1.5px solid #1d2126; }
h3 { font-size: 14.5px; margin: 18px 0 6px; }
p { margin: 8px 0; }
.kind { margin: 0 0 2px; font-size: 12.5px; letter-spacing: .08em; text-transform: uppercase; color: #5d646c; }
.by { margin: 6px 0 0; font-size: 13px; color: #5d646c; overflow-wrap: anywhere; }
.verdict { margin: 18px 0; padding: 2px 0 2px 14px; border-left: 4px solid #d03a00; font-size: 17px; }
.warning { margin: 14px 0; padding: 8px 12px; border: 1.5px solid #d03a00; color: #9c2c00; font-size: 14px;
  font-weight: 600; }
.note { font-size: 13px; color: #4a5058; }
table { border-collapse: collapse; width: 100%; margin: 8px 0; font-size: 12.5px; line-height: 1.4;
  font-variant-numeric: tabular-nums; }
th { text-align: left; font-weight: 600; border-bottom: 1px solid #1d2126; vertical-align: bottom; }
th, td { padding: 3px 10px 3px 0; }
td { vertical-align: top; border-bottom: .5px solid #d5d8db; overflow-wrap: break-word; }
td b, td.w { overflow-wrap: anywhere; }
th.n, td.n { text-align: right; white-space: nowrap; }
th.n { white-space: normal; }
th:last-child, td:last-child { padding-right: 0; }
ul { margin: 6px 0; padding-left: 20px; }
figure { margin: 12px 0; }
figure svg { display: block; width: 100%; height: auto; }
figcaption { margin-top: 6px; font-size: 12.5px; color: #4a5058; }
.tree { font-size: 13.5px; line-height: 1.45; }
.tree ul { list-style: none; margin: 0; padding-left: 0; }
.tree ul ul { margin-left: 5px; padding-left: 15px; border-left: 1px solid #c3c8ce; }
.tree li { padding-left: 16px; text-indent: -16px; }
.tree li > ul, .tree li > details > ul { text-indent: 0; }
.tree li::before { content: "●"; display: inline-block; width: 16px; text-indent: 0; font-size: 9px; color: #9aa1a9;
  vertical-align: 1px; }
.tree li.failure::before, .tree li.loss::before, .tree li.invalid::before { color: #d03a00; }
.tree li.damage::before { color: #e69f00; }
.tree li.change::before { color: #9c4f96; }
.tree li.loss, .tree li.invalid { font-weight: 600; }
.tree li > ul { font-weight: 400; }
.tree li.fold::before { content: ""; }
.tree li.fold { color: #4a5058; font-weight: 400; }
.tree details { display: inline-block; text-indent: 0; }
.tree summary { font-size: 12.5px; }
time { font-size: 12px; font-variant-numeric: tabular-nums; color: #4a5058; font-weight: 400; }
summary { cursor: pointer; font-size: 13.5px; }
pre { margin: 8px 0; padding: 8px 10px; background: #f4f4f1; font: 12px/1.45 "Source Code Pro", "DejaVu Sans Mono",
  Menlo, Consolas, monospace; white-space: pre-wrap; overflow-wrap: anywhere; }
@page { size: A4; margin: 16mm 15mm 18mm; @bottom-right { content: counter(page) " / " counter(pages);
  font: 9pt sans-serif; color: #5d646c; } }
@media print {
  body { background: #fff; font-size: 10pt; }
  main { max-width: none; margin: 0; padding: 0; box-shadow: none; }
  .verdict { font-size: 11.5pt; }
  .tree { font-size: 9pt; }
  table, .note, figcaption { font-size: 8.5pt; }
  h2, h3 { break-after: avoid; }
  .warning, .verdict { break-inside: avoid; }
  figure, tr { break-inside: avoid; }
  figure svg { max-height: 225mm; }
  thead { display: table-header-group; }
  p, li { orphans: 3; widows: 3; }
  pre { font-size: 8pt; padding: 0; background: none; }
  .script::details-content { content-visibility: visible; block-size: auto; }
  .script > summary, .fold summary { list-style: none; }
}
)css";
}

}  // namespace trilith::report
