"""How the page looks, on wide and narrow screens, in light and in dark."""

STYLE = """
:root { color-scheme: light dark; --soft: #7c828c; --line: #8883; --panel: #8881; --good: #2f8f5b; --bad: #d1442f; }
* { box-sizing: border-box; }
body { font: 15px/1.5 system-ui, sans-serif; max-width: 1180px; margin: 1.5rem auto; padding: 0 1rem 3rem; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: 0; } h2 { font-size: 1.1rem; margin: 2.2rem 0 .6rem; }
ul { margin: .5rem 0; padding-left: 1.2rem; } li { overflow-wrap: anywhere; }
.soft { color: var(--soft); font-size: .85rem; }
.facts { display: flex; flex-wrap: wrap; gap: .4rem; margin: .6rem 0; }
.facts span, .number { background: var(--panel); border-radius: 4px; padding: 1px 8px; font-size: .85rem; }
.verdict { border-left: 6px solid var(--good); padding: .7rem 1rem; margin: 1rem 0; background: var(--panel);
  font-size: 1.05rem; overflow-wrap: anywhere; }
.verdict.fail { border-color: var(--bad); }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(250px, 45%), 1fr)); gap: 1rem; }
figure { margin: 0; } figcaption { color: var(--soft); font-size: .85rem; margin-top: .2rem; }
img { width: 100%; image-rendering: pixelated; border-radius: 4px; display: block; }
.scroll, .sss-explanation { overflow-x: auto; }
table { border-collapse: collapse; font-size: .85rem; font-variant-numeric: tabular-nums; }
.buffers td, .buffers th { padding: 3px 12px 3px 0; text-align: right; white-space: nowrap; vertical-align: middle; }
.buffers td:nth-child(-n+2), .buffers th:nth-child(-n+2) { text-align: left; }
.buffers thead th { color: var(--soft); font-weight: 500; vertical-align: bottom; }
.buffers tbody tr { border-bottom: 1px solid var(--line); } .buffers .pass th { padding-top: .9rem; }
.buffers small { display: block; font-weight: 400; line-height: 1.1; color: var(--soft); }
.buffers td:first-child { font-weight: 600; position: sticky; left: 0; background: Canvas; }
tr.fail td { color: var(--bad); } tr.empty td { opacity: .55; } tr.inherits td { color: #b07a1e; }
.bar { display: flex; gap: 1px; height: 10px; border-radius: 2px; overflow: hidden; }
.histogram { fill: #5480be; vertical-align: middle; } .histogram .base { fill: var(--line); }
.legend { display: flex; flex-wrap: wrap; gap: .2rem 1rem; font-size: .85rem; margin: .6rem 0 0; }
.legend i { display: inline-block; width: .8em; height: .8em; border-radius: 2px; margin-right: .4em; }
.power { width: 100%; } .power td, .power th { text-align: left; vertical-align: top; padding: 4px 12px 4px 0; }
.power tr { border-bottom: 1px solid var(--line); } .power td:first-child { font-weight: 600; }
.power td:last-child { overflow-wrap: anywhere; }
.number { display: inline-block; margin: 1px 4px 1px 0; } .number.blind { color: var(--bad); }
.sss-explanation th { text-align: left; padding: 1px 14px 1px 0; font-weight: 500; color: var(--soft); }
.sss-explanation tr[class] td.may-be { white-space: pre-wrap; min-width: 30ch; color: #5480be; }
.sss-explanation .got td { color: var(--bad); border-top: 1px solid var(--line); }
@media (max-width: 600px) {
  .sss-explanation thead, body .sss-explanation tr[class] td:empty { display: none; }
  .sss-explanation tr, body .sss-explanation tr[class] td { display: block; max-width: none; white-space: pre-wrap; }
  body .sss-explanation tr[class] td + td { padding-left: 2em; }
  .sss-explanation td.may-be::before { content: "may be: "; color: var(--soft); } }
@media (max-width: 600px) { .power td { display: block; } .power th { display: none; } h1 { font-size: 1.25rem; } }
"""
