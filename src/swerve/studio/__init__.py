"""The web pages of `swerve view`: finished runs, two of them together, and new ones of a scene moved by hand."""
