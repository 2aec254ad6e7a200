"""Where wheelsets are, from the poses that a bag holds on /tf. Reads messages, as bag_reader does."""
from typing import Optional

import numpy as np
import rosbag

from train_viz.adhesion import Adhesion, Wheelsets
from train_viz.track_shape import TrackShape

FIRST_STAMP_NS = 10**9  # of a run's start


def read_wheelsets(bag: rosbag.Bag, adhesion: Adhesion, resolved: str) -> Optional[Wheelsets]:
    """Lateral displacement of every wheelset; None if the bag has no poses of this locomotive's wheelsets.

    /tf gives a body in the track's frame at the locomotive's place (loco_N/base_link), so in a curve the way the track has
    turned in between is taken off.
    """
    name = f'loco_{adhesion.locomotive}/'
    children = {f'{name}wheelset_{i + 1}': i for i in range(adhesion.axles)}
    rows = {}
    for _, message, _ in bag.read_messages('/tf'):
        found = {children[t.child_frame_id]: t for t in message.transforms if t.child_frame_id in children}
        if len(found) == adhesion.axles and all(t.header.frame_id == name + 'base_link' for t in found.values()):
            stamp = found[0].header.stamp.to_nsec()
            rows[stamp] = [(p.x, p.y, p.z) for p in (found[i].transform.translation for i in range(adhesion.axles))]
    try:
        shape = TrackShape(resolved)
    except (KeyError, TypeError, ValueError):  # a track that we do not understand
        return None
    if not rows:
        return None
    stamps = sorted(rows)
    time_s = (np.array(stamps) - FIRST_STAMP_NS) / 1e9
    place_m = np.interp(time_s, adhesion.time_s, adhesion.location_m)
    points = np.array([rows[stamp] for stamp in stamps])  # [row, wheelset, xyz]
    lateral = [shape.lateral_m(place_m, *points[:, i, :].T) for i in range(adhesion.axles)]
    return Wheelsets(time_s, place_m[:, None] + points[:, :, 0], np.array(lateral).T)
