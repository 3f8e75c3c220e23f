"""The package of studies as it is for type checkers, which know no module that can be called."""

from __future__ import annotations

import sys
from types import ModuleType
from typing import TYPE_CHECKING, Any, cast

if TYPE_CHECKING:
    from groundslab.study import run
    from groundslab.study.definition.schema import StudyFile as _StudyFile
    from groundslab.study.evaluation.form import reliability
    from groundslab.study.evaluation.study import Study as _Study
    from groundslab.study.evaluation.study import open_study
    from groundslab.study.report.writer import evaluate

    class _StudyPackage:
        Study = _Study
        StudyFile = _StudyFile
        evaluate = staticmethod(evaluate)
        open_study = staticmethod(open_study)
        reliability = staticmethod(reliability)
        run = staticmethod(run)
        __call__ = staticmethod(run)


class CallableModule(ModuleType):
    """A module that runs a study when it is called."""

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        """Run a study, see `groundslab.study.run`."""
        return self.run(*arguments, **options)


study = cast("_StudyPackage", sys.modules[__package__])
