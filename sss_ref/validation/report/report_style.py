"""What the page of a report adds to how every page looks."""

REPORT_STYLE = """
ul { margin: .5rem 0; padding-left: 1.2rem; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(250px, 45%), 1fr)); gap: 1rem; }
.sss-explanation { overflow-x: auto; }
.buffers td, .buffers th { padding: 3px 12px 3px 0; text-align: right; white-space: nowrap; vertical-align: middle; }
.buffers td:nth-child(-n+2), .buffers th:nth-child(-n+2) { text-align: left; }
.buffers tbody tr { border-bottom: 1px solid var(--line); } .buffers .pass th { padding-top: .9rem; }
.buffers small { display: block; font-weight: 400; line-height: 1.1; color: var(--soft); }
.buffers td:first-child { font-weight: 600; position: sticky; left: 0; background: Canvas; }
tr.fail td { color: var(--bad); } tr.empty td { opacity: .55; } tr.inherits td { color: var(--maybe); }
.bar { display: flex; gap: 1px; height: 10px; border-radius: 2px; overflow: hidden; }
.histogram { fill: var(--open); vertical-align: middle; } .histogram .base { fill: var(--line); }
.legend { margin: .6rem 0 0; }
.legend i { display: inline-block; width: .8em; height: .8em; border-radius: 2px; margin-right: .4em; }
.power { width: 100%; } .power td, .power th { text-align: left; vertical-align: top; padding: 4px 12px 4px 0; }
.power tr { border-bottom: 1px solid var(--line); } .power td:first-child { font-weight: 600; }
.power td:last-child { overflow-wrap: anywhere; }
.number { display: inline-block; margin: 1px 4px 1px 0; background: var(--panel); border-radius: 4px; padding: 1px 8px;
  font-size: .85rem; } .number.blind { color: var(--bad); }
.sss-explanation th { text-align: left; padding: 1px 14px 1px 0; font-weight: 500; color: var(--soft); }
.sss-explanation tr[class] td.may-be { white-space: pre-wrap; min-width: 30ch; color: var(--open); }
.sss-explanation .got td { color: var(--bad); border-top: 1px solid var(--line); }
@media (max-width: 600px) {
  .sss-explanation thead, body .sss-explanation tr[class] td:empty { display: none; }
  .sss-explanation tr, body .sss-explanation tr[class] td { display: block; max-width: none; white-space: pre-wrap; }
  body .sss-explanation tr[class] td + td { padding-left: 2em; }
  .sss-explanation td.may-be::before { content: "may be: "; color: var(--soft); } }
@media (max-width: 600px) { .power td { display: block; } .power th { display: none; } }
"""
