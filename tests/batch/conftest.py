from data_folder import data_folder  # noqa: F401
