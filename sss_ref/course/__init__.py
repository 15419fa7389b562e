"""What the lessons of the course work with: their scenes, their figures, and the checks of their exercises.

`figures` needs the extra `course`; nothing else of the package imports it.
"""
