"""How the page of a ladder looks, on wide and narrow screens, in light and in dark."""

LADDER_STYLE = """
:root { color-scheme: light dark; --soft: #6d737d; --line: #8884; --panel: #8881; --heat: 209, 88, 47; }
@media (prefers-color-scheme: dark) { :root { --soft: #9aa1ad; } }
* { box-sizing: border-box; }
body { font: 15px/1.5 system-ui, sans-serif; max-width: 1180px; margin: 1.5rem auto; padding: 0 1rem 3rem; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: 0; } h2 { font-size: 1.1rem; margin: 2.2rem 0 .6rem; }
h3 { font-size: 1rem; margin: 0 0 .4rem; } p { max-width: 75ch; }
.soft, figcaption { color: var(--soft); font-size: .85rem; }
.facts { display: flex; flex-wrap: wrap; gap: .4rem; margin: .6rem 0; padding: 0; }
.facts span { background: var(--panel); border-radius: 4px; padding: 1px 8px; font-size: .85rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: .85rem; font-variant-numeric: tabular-nums; }
td, th { padding: 4px 8px; text-align: right; white-space: nowrap; }
td:first-child, th:first-child { text-align: left; position: sticky; left: 0; background: Canvas; }
thead th { color: var(--soft); font-weight: 500; vertical-align: bottom; }
tbody tr { border-bottom: 1px solid var(--line); } tr.beside td { color: var(--soft); }
td[style] { background: rgba(var(--heat), var(--share)); }
.row { margin: 0 0 1.6rem; } .row div { display: grid; grid-template-columns: repeat(3, 1fr); gap: .6rem; }
figure { margin: 0; min-width: 0; } img { width: 100%; image-rendering: pixelated; border-radius: 4px; display: block; }
.bar { display: grid; grid-template-columns: auto 1fr auto; gap: .6rem; align-items: center; max-width: 34rem; }
.bar img { height: 14px; image-rendering: auto; }
.where { display: grid; grid-template-columns: minmax(0, 17rem) 1fr; gap: 1.2rem; align-items: start;
  margin-top: 1.2rem; }
.where ul { list-style: none; margin: 0; padding: 0; } .where li { margin: 0 0 .35rem; }
.where i { display: inline-block; width: .8em; height: .8em; border-radius: 2px; margin-right: .5em; }
@media (min-width: 900px) { .rows { display: grid; grid-template-columns: 1fr 1fr; gap: 0 2rem; } }
@media (max-width: 600px) { h1 { font-size: 1.25rem; } .where { grid-template-columns: 1fr; }
  .row div { gap: .3rem; } td, th { padding: 4px 6px; } figcaption { font-size: .75rem; } }
"""
