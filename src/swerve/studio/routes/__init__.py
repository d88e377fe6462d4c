"""What the studio answers to which address, a module for each theme; each adds its own to an application."""
