"""Volume cells within a closed surface mesh: what fills it, and how good that came out."""
