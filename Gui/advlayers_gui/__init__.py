"""The window's side of Advancing Layers: commands, panels and view providers."""
