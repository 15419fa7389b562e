"""What the package raises for bad input: one clear message each; exit code 2 on the command line."""


class SssRefError(Exception):
    """Base of every error this package raises on purpose; its message names the cause and the remedy."""


class SceneError(SssRefError):
    """A scene file or an override is wrong; the message lists every problem found, one per line."""


class MeshError(SssRefError):
    """A mesh file cannot be read, or what it holds cannot be rendered."""


class RenderError(SssRefError):
    """A stage computed NaN or infinity; the message names the stage, the pixel and its inputs."""


class DumpError(SssRefError):
    """A folder of buffers cannot be written or read back."""


class ProfileError(SssRefError):
    """A profile of a processor is wrong; the message lists every problem found, one per line."""


class StageError(SssRefError):
    """A function is not in the shader language; the message names file, line and rule."""


class ShaderError(SssRefError):
    """There is no OpenGL, or a shader does not compile, or does not fit its pass."""


class CourseError(SssRefError):
    """A folder of the course cannot be written or read, or the extra `course` is missing."""
