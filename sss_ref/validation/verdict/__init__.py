"""From compared buffers to verdicts: outcomes, widths, clusters, suspects, and what a run would see."""
