"""Measures of speed, of the controller and of its peers: `python -m bench`. Nothing here is needed to drive."""
