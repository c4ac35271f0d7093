"""Cases."""

from riffel._case.growth import GrowthOfCase
from riffel._case.in_time import CaseInTime
from riffel._case.measured import MeasuredOnCase
from riffel._case.outlook import OutlookOfCase
from riffel._case.parts import PartsOfCase


class Case(GrowthOfCase, PartsOfCase, OutlookOfCase, CaseInTime, MeasuredOnCase):
    """One wheel on one track, checked and complete. It does not change; `with_` makes another one.

    Make one with `from_toml`, `from_dict` or `parse`.
    """

    __slots__ = ()
