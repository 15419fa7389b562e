"""What the compressions of OpenEXR keep of a channel: all of it, 24 bits of each float, or an unknown part.

Which lose bits, and of which channels: the OpenEXR documentation, "Technical Introduction to OpenEXR", Data
Compression, and of DWA and LJ2K what the library does with a channel by its name. A compression that is not listed
here is taken to lose bits of every channel.
"""

LOSSLESS = ("NO", "RLE", "ZIPS", "ZIP", "PIZ", "HTJ2K256", "HTJ2K32", "ZSTD")
OF_HALVES = ("B44", "B44A")
OF_FLOATS = "PXR24"
BY_NAME = {  # compression -> the last part of the names of colours, which it approximates
    "DWAA": ("R", "G", "B", "Y", "RY", "BY"),
    "DWAB": ("R", "G", "B", "Y", "RY", "BY"),
    "LJ2K": ("R", "G", "B", "RED", "GREEN", "BLUE"),
}
ANY_CASE = ("LJ2K",)  # compressions for which small letters are the same


def is_spoiled(compression: str, channel: str, kind: str) -> bool:
    """Whether a compression changes a channel by an unknown amount. kind: "f" and bytes, or "u4", as NumPy has it."""
    if compression in BY_NAME:
        last = channel.rpartition(".")[2]
        name = last.upper() if compression in ANY_CASE else last
        return kind != "u4" and name in BY_NAME[compression]
    if compression in OF_HALVES:
        return kind == "f2"
    return compression not in (*LOSSLESS, OF_FLOATS)


def storage_after(compression: str, storage: str) -> str:
    """The storage of what a compression leaves of a channel that it does not spoil."""
    return "float24" if compression == OF_FLOATS and storage == "float32" else storage
