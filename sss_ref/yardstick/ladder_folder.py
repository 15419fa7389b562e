"""The folder of a measurement: the traced truth, from which it goes on, and what is told of it."""

import json
from pathlib import Path

from sss_ref.errors import DumpError
from sss_ref.errors.text_file import write_texts
from sss_ref.errors.wording import told
from sss_ref.yardstick.ladder import Ladder
from sss_ref.yardstick.ladder_page import as_html
from sss_ref.yardstick.ladder_record import as_record
from sss_ref.yardstick.ladder_table import as_markdown

TRUTH, PAGE, RECORD, TABLE = "truth", "measure.html", "measure.json", "measure.md"
OWN = {TRUTH, PAGE, RECORD, TABLE}


def checked_folder(folder: Path) -> Path:
    """A folder that is new, empty or of an earlier measurement. Raises DumpError for another."""
    if folder.exists() and not (folder.is_dir() and {path.name for path in folder.iterdir()} <= OWN):
        remedy = "choose another folder"
        raise DumpError(told(str(folder), "a new folder or one of sss-ref measure", "other files", remedy))
    return folder


def write_ladder(ladder: Ladder, folder: Path) -> Path:
    """Write page, record and table beside the truth; returns the page's path. Raises DumpError."""
    files = {
        PAGE: as_html(ladder),
        RECORD: json.dumps(as_record(ladder), indent=1) + "\n",
        TABLE: as_markdown(ladder),
    }
    write_texts(folder, files, DumpError)
    return folder / PAGE
