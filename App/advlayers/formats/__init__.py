"""Mesh files: one module a format, over the one description of a mesh in mesh_parts."""
