"""Writing results to disk and reading them back: NPY, PNG, EXR, the contact sheet and the manifest."""
