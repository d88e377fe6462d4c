"""What all tables of a scenario have in common, and the error that names one of their keys."""

from pydantic import BaseModel, ConfigDict


class Settings(BaseModel):
    """One table of a scenario: frozen, and closed to keys that it does not know."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class KeyedError(ValueError):
    """A value that does not go with another one.

    Attributes:
        key: the dotted key at fault, below the table that was being checked.
        sentence: what is wrong with it, and what would be right.
    """

    def __init__(self, key: str, sentence: str) -> None:
        super().__init__(f"{key}: {sentence}")
        self.key = key
        self.sentence = sentence
