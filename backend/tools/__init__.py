"""Tools that make files of the tree; nothing of them ships."""
