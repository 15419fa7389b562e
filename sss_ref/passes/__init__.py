"""The stages, one file for each of the paper's nouns; read them beside the paper."""
