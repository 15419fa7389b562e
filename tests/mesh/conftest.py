"""The fixtures of these tests."""

from data_folder import data_folder, small  # noqa: F401
