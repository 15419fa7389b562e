"""Verdicts and causes as text, page and JSON."""
