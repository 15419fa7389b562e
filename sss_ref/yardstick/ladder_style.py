"""What the page of a ladder adds to how every page looks."""

LADDER_STYLE = """
:root { --heat: 209, 88, 47; }
h3 { font-size: 1rem; margin: 0 0 .4rem; } p { max-width: 75ch; }
td, th { padding: 4px 8px; text-align: right; white-space: nowrap; }
td:first-child, th:first-child { text-align: left; position: sticky; left: 0; background: Canvas; }
tbody tr { border-bottom: 1px solid var(--line); } tr.beside td { color: var(--soft); }
td[style] { background: rgba(var(--heat), var(--share)); }
.row { margin: 0 0 1.6rem; } .row div { display: grid; grid-template-columns: repeat(3, 1fr); gap: .6rem; }
.bar { display: grid; grid-template-columns: auto 1fr auto; gap: .6rem; align-items: center; max-width: 34rem; }
.bar img { height: 14px; image-rendering: auto; }
.where { display: grid; grid-template-columns: minmax(0, 17rem) 1fr; gap: 1.2rem; align-items: start;
  margin-top: 1.2rem; }
.where ul { list-style: none; margin: 0; padding: 0; } .where li { margin: 0 0 .35rem; }
.where i { display: inline-block; width: .8em; height: .8em; border-radius: 2px; margin-right: .5em; }
@media (min-width: 900px) { .rows { display: grid; grid-template-columns: 1fr 1fr; gap: 0 2rem; } }
@media (max-width: 600px) { .where { grid-template-columns: 1fr; } .row div { gap: .3rem; } td, th { padding: 4px 6px; }
  figcaption { font-size: .75rem; } }
"""
