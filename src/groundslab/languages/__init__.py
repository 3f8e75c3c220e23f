"""Results in the languages of those who read them: messages are written in English, catalogues translate them."""

from groundslab.languages.catalogue import LANGUAGES, Language, Translator, page_messages, translator

__all__ = ["LANGUAGES", "Language", "Translator", "page_messages", "translator"]
