"""The paper's methods, each a page that can be read aloud."""
