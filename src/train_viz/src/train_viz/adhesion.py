"""What a locomotive's axles do on the rail, as plain arrays. Nothing here knows ROS or matplotlib."""
import dataclasses
from typing import List, Optional, Tuple

import numpy as np


@dataclasses.dataclass(frozen=True)
class Wheels:
    """What each wheel does, of models with contacts of their own (3d). SI units; [row, axle, side], left 0, right 1."""
    vertical_force_N: np.ndarray      # Q, of the rail on the wheel, + up
    lateral_force_N: np.ndarray       # of the rail on the wheelset, + left, as in AxleAdhesion
    t_gamma_N: np.ndarray             # sum over the wheel's contacts
    contacts: np.ndarray              # number of contacts

    @property
    def guiding_force_N(self) -> np.ndarray:
        """Y: lateral force of the wheel on its rail, + outward, as a flange presses."""
        return self.lateral_force_N * np.array([-1.0, 1.0])

    @property
    def lateral_over_vertical(self) -> np.ndarray:
        """Y/Q (L/V); no number where a wheel carries less than 1 kN (chosen: 1 % of the usual)."""
        carries = self.vertical_force_N > 1e3
        return np.where(carries, self.guiding_force_N, np.nan) / np.where(carries, self.vertical_force_N, 1.0)


@dataclasses.dataclass(frozen=True)
class Wheelsets:
    """Where a locomotive's wheelsets are in the track, of the model 3d. SI units; in rows of /tf, which are fewer."""
    time_s: np.ndarray
    location_m: np.ndarray            # [row, wheelset]
    lateral_m: np.ndarray             # [row, wheelset], + left of the middle of the track as designed


@dataclasses.dataclass(frozen=True)
class Adhesion:
    """One locomotive's wheels on the rail in rows of simulation time; SI units, signs as in AxleAdhesion.msg."""
    locomotive: int                   # counted from 1 at the head of the train
    time_s: np.ndarray                # since the start of the run
    location_m: np.ndarray            # chainage of this locomotive
    speed_mps: np.ndarray             # of this locomotive
    creep: np.ndarray                 # [row, axle], as all below; > 0 driving
    adhesion: np.ndarray              # used, > 0 driving
    friction: np.ndarray              # that the rail offers at this slip
    static_friction: np.ndarray       # that it would offer without slip
    normal_force_N: np.ndarray        # of both wheels
    torque_demanded_N_m: np.ndarray   # on the wheelset, before adhesion control
    torque_applied_N_m: np.ndarray    # after it
    shoe_torque_N_m: np.ndarray       # of the brake shoes, < 0 rolling forward
    controller_active: np.ndarray     # the controller takes torque away
    frictional_power_W: np.ndarray    # lost to slip
    t_gamma_N: np.ndarray             # energy lost to slip per distance
    wheels: Optional[Wheels] = None   # of the model 3d
    wheelsets: Optional[Wheelsets] = None  # of the model 3d, if the bag has /tf

    @property
    def location_km(self) -> np.ndarray:
        return self.location_m / 1000.0

    @property
    def speed_kmph(self) -> np.ndarray:
        return self.speed_mps * 3.6

    @property
    def brakes(self) -> bool:
        """Whether these wheels brake: adhesion below -0.02 (chosen: more than rolling and curves need)."""
        return bool(self.adhesion.min() < -0.02)

    @property
    def axles(self) -> int:
        return self.creep.shape[1]


def array_names(kind: type) -> List[str]:
    return [field.name for field in dataclasses.fields(kind) if field.type is np.ndarray]


AXLE_COLUMNS = array_names(Adhesion)[3:]  # the arrays by axle, in the order of the fields


def join_adhesion(parts: List[Adhesion]) -> Adhesion:
    """Joins one locomotive's rows from bags of one run; of rows of the same time any one will do."""
    _, rows = np.unique(np.concatenate([part.time_s for part in parts]), return_index=True)

    def joined(those: list) -> dict:
        return {name: np.concatenate([getattr(that, name) for that in those])[rows] for name in array_names(type(those[0]))}

    wheels = [part.wheels for part in parts]
    return dataclasses.replace(parts[0], **joined(parts), wheels=None if None in wheels else
                               dataclasses.replace(wheels[0], **joined(wheels)),
                               wheelsets=_join_wheelsets([part.wheelsets for part in parts]))


def _join_wheelsets(parts: List[Optional[Wheelsets]]) -> Optional[Wheelsets]:
    if None in parts:
        return None
    _, rows = np.unique(np.concatenate([part.time_s for part in parts]), return_index=True)
    return Wheelsets(**{name: np.concatenate([getattr(part, name) for part in parts])[rows]
                        for name in array_names(Wheelsets)})


def true_stretches(place: np.ndarray, flags: np.ndarray) -> List[Tuple[float, float]]:
    """Where flags are true, as (from, length): from a stretch's first row as far as the row that follows its last."""
    edges = np.flatnonzero(np.diff(np.concatenate(([False], flags.astype(bool), [False])).astype(int)))
    ends = np.minimum(edges[1::2], len(place) - 1)
    return [(float(place[first]), float(place[end] - place[first])) for first, end in zip(edges[0::2], ends)]
