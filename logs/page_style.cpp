#include "logs/page_style.h"

#include "logs/html_text.h"

namespace citrine::logs {
namespace {

constexpr const char* kColours = R"css(
:root { color-scheme: light dark; --ink: #1d2126; --soft: #667080; --rule: #d9dee5; --page: #ffffff; --card: #f6f8fa;
  --good: #1a7f4b; --bad: #b3261e;
  --c0: #2f6fb5; --c1: #d9822b; --c2: #2b9a66; --c3: #b8418a; --c4: #8a6d3b; --c5: #5b57c7; --c6: #17a2b8; --c7: #8a8f98; }
@media (prefers-color-scheme: dark) { :root { --ink: #e4e8ee; --soft: #98a2b0; --rule: #323a45; --page: #14181d;
  --card: #1c2229; --good: #4cc38a; --bad: #ff7a70;
  --c0: #6ea8e8; --c1: #f0a35c; --c2: #5cc793; --c3: #e07fb9; --c4: #c4a56d; --c5: #9a97f2; --c6: #55cbdc; --c7: #b4b9c2; } }
)css";

constexpr const char* kParts = R"css(
svg text { font: 11px system-ui, sans-serif; fill: var(--soft); } svg .head { font-weight: 600; fill: var(--ink); }
.axis { stroke: var(--soft); } .grid { stroke: var(--rule); } .frame { fill: none; stroke: var(--rule); } .page { fill: var(--page); }
.limit { stroke: var(--bad); stroke-dasharray: 5 4; } .dashed { stroke-dasharray: 5 4; }
.curve { fill: none; stroke: var(--c); stroke-width: 1.5; stroke-linejoin: round; }
.bar, .dot { fill: var(--c); } .faint { fill: var(--c); opacity: 0.4; } .ring { fill: none; stroke: var(--c); stroke-width: 2; }
.c0 { --c: var(--c0); } .c1 { --c: var(--c1); } .c2 { --c: var(--c2); } .c3 { --c: var(--c3); }
.c4 { --c: var(--c4); } .c5 { --c: var(--c5); } .c6 { --c: var(--c6); } .c7 { --c: var(--c7); }
)css";

constexpr const char* kPage = R"css(
body { margin: 0 auto; max-width: 1200px; padding: 24px; background: var(--page); color: var(--ink);
  font: 15px/1.45 system-ui, sans-serif; }
h1 { font-size: 24px; margin: 0 0 4px; } h2 { font-size: 18px; margin: 32px 0 10px; }
.soft { color: var(--soft); }
.verdict { padding: 10px 14px; border-left: 5px solid; background: var(--card); font-weight: 600; }
.good { border-color: var(--good); } .bad { border-color: var(--bad); }
.figures { display: grid; grid-template-columns: repeat(auto-fill, minmax(400px, 1fr)); gap: 14px; align-items: start; }
.tables { columns: 2 400px; column-gap: 28px; } .tables table { break-inside: avoid; margin-bottom: 18px; }
figure { margin: 0; padding: 10px; background: var(--card); border-radius: 6px; }
figcaption, caption { font-weight: 600; text-align: left; padding-bottom: 6px; }
.legend { float: right; font-weight: 400; color: var(--soft); font-size: 13px; } .legend > span { margin-left: 10px; white-space: nowrap; }
.legend i { display: inline-block; width: 14px; height: 3px; margin-right: 4px; vertical-align: middle; background: var(--c); }
svg { width: 100%; height: auto; display: block; }
img { max-width: 100%; max-height: 820px; display: block; border-radius: 6px; }
table { border-collapse: collapse; width: 100%; } th, td { padding: 3px 8px; border-bottom: 1px solid var(--rule); }
th { font-weight: 400; text-align: left; color: var(--soft); } td { text-align: right; font-variant-numeric: tabular-nums; }
.numbers td { width: 45%; } .paper tr:first-of-type th:not(:first-child) { text-align: right; }
.sweep { background: var(--card); margin-bottom: 18px; font-size: 13px; } .sweep th, .sweep td { padding: 3px 5px; }
.wide { overflow-x: auto; } .sweep td { white-space: nowrap; } .sweep tr:first-of-type th:not(:first-child) { text-align: right; }
.paper { background: var(--card); } .ours th, .ours td { font-weight: 600; color: var(--ink); }
pre { background: var(--card); padding: 12px; overflow-x: auto; border-radius: 6px; font-size: 13px; }
)css";

}  // namespace

std::string SvgStyle() { return std::string(kColours) + kParts; }

std::string PageHead(const std::string& title) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>" +
         Escape(title) + "</title>\n<style>" + SvgStyle() + kPage + "</style>\n</head>\n<body>\n<h1>" +
         Escape(title) + "</h1>\n";
}

}  // namespace citrine::logs
