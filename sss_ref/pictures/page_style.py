"""How every page looks that is written for a browser: colours, type and tables, in light and in dark.

A page adds what is its own. `--good` and `--bad` are of verdicts, `--maybe` of what is in doubt, `--open` of what
nothing is said of; all are readable on white and on black.
"""

PAGE_STYLE = """
:root { color-scheme: light dark; --soft: #6d737d; --line: #8884; --panel: #8881; --good: #2f8f5b; --bad: #d1442f;
  --maybe: #b07a1e; --open: #5480be; }
@media (prefers-color-scheme: dark) { :root { --soft: #9aa1ad; --good: #4fae79; --bad: #ee6c58; --maybe: #d09a3e;
  --open: #7ba3dc; } }
* { box-sizing: border-box; }
body { font: 15px/1.5 system-ui, sans-serif; max-width: 1180px; margin: 1.5rem auto; padding: 0 1rem 3rem; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: 0; } h2 { font-size: 1.1rem; margin: 2.2rem 0 .6rem; }
h1, h2, li { overflow-wrap: anywhere; }
.soft, figcaption, .legend { color: var(--soft); font-size: .85rem; }
.facts { display: flex; flex-wrap: wrap; gap: .4rem; margin: .6rem 0; }
.facts span { background: var(--panel); border-radius: 4px; padding: 1px 8px; font-size: .85rem;
  overflow-wrap: anywhere; }
.verdict { border-left: 6px solid var(--line); padding: .7rem 1rem; margin: 1rem 0; background: var(--panel);
  font-size: 1.05rem; overflow-wrap: anywhere; }
.verdict.passed { border-color: var(--good); } .verdict.failed { border-color: var(--bad); }
figure { margin: 0; min-width: 0; } figcaption { margin-top: .2rem; }
img { width: 100%; image-rendering: pixelated; border-radius: 4px; display: block; }
.legend { display: flex; flex-wrap: wrap; gap: .2rem 1rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: .85rem; font-variant-numeric: tabular-nums; }
thead th { color: var(--soft); font-weight: 500; vertical-align: bottom; }
@media (max-width: 600px) { h1 { font-size: 1.25rem; } }
"""
