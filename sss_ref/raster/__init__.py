"""From clip space to fragments: clip, snap, cover, interpolate; knows nothing of passes and shaders."""
