"""Contact points of wheel and rail, as they are usually drawn: joined sections, and the radius difference."""
from typing import Dict, List, Tuple

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from train_viz import plot_style
from train_viz.contact_table import Contact

JUMP_DEG = 20.0                   # chosen: from tread or flange root to the flange
JUMP_MM, JUMP_PER_MM = 5.0, 4.0   # chosen: on S1002 and UIC60 the contact wanders up to 3 mm a mm
LIFT_MM = 12.0  # of the drawn wheel above its rail, so that joining lines can be seen


def point_on_wheel(contact: Contact, wheel: np.ndarray, nominal_radius_mm: float) -> np.ndarray:
    """Point of the section of that depth that is nearest to the contact, the wheel moved back to the centre."""
    outward_mm = -contact.y_mm if contact.side == 'right' else contact.y_mm
    expected = np.array([contact.y_rail_mm + outward_mm, contact.rolling_radius_mm - nominal_radius_mm])
    return wheel[np.argmin(np.hypot(*(wheel - expected).T))]


def draw_side(axes: Axes, side: str, contacts: List[Contact], sections: Dict[str, np.ndarray], radius_mm: float) -> None:
    mirror = 1.0 if side == 'right' else -1.0  # looking forward: the field side is outside
    wheel, rail = sections['wheel'], sections['rail']
    axes.plot(mirror * wheel[:, 0], LIFT_MM - wheel[:, 1], color=plot_style.BLUE, linewidth=2, label='wheel, centred')
    axes.plot(mirror * rail[:, 0], -rail[:, 1], color='0.2', linewidth=2, label='rail')
    largest_N = max(contact.normal_force_N for contact in contacts)
    for contact in contacts:
        y_wheel, z_wheel = point_on_wheel(contact, wheel, radius_mm)
        axes.plot([mirror * y_wheel, mirror * contact.y_rail_mm], [LIFT_MM - z_wheel, -contact.z_rail_mm],
                  color=plot_style.VERMILION, linewidth=0.4 + contact.normal_force_N / largest_N)
    axes.set_aspect('equal')
    axes.set_title(f'{side} wheel')
    axes.set_xlabel('from the rail\'s top [mm], right is +')
    axes.set_ylabel('height [mm]')


def main_contacts(contacts: List[Contact], side: str) -> Tuple[np.ndarray, List[Contact]]:
    """The contact with the largest load at each displacement, displacements rising."""
    main: Dict[float, Contact] = {}
    for contact in contacts:
        if contact.side == side and (contact.y_mm not in main or
                                     contact.normal_force_N > main[contact.y_mm].normal_force_N):
            main[contact.y_mm] = contact
    y_mm = np.array(sorted(main))
    return y_mm, [main[y] for y in y_mm]


def jumps_of(y_mm: np.ndarray, contacts: List[Contact]) -> np.ndarray:
    """Whether the contact jumps to another part of the profile between a displacement and the next."""
    angles_deg = np.degrees([contact.angle_rad for contact in contacts])
    places_mm = np.array([contact.y_rail_mm for contact in contacts])
    return (np.abs(np.diff(angles_deg)) > JUMP_DEG) | (np.abs(np.diff(places_mm)) > JUMP_MM + JUMP_PER_MM * np.diff(y_mm))


def parted(x: np.ndarray, y: List[float], jumps: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """With a hole in the line at every jump."""
    after = np.flatnonzero(jumps) + 1
    return np.insert(x, after, np.nan), np.insert(np.array(y), after, np.nan)


def draw_contacts(contacts: List[Contact], sections: Dict[str, np.ndarray]) -> Figure:
    across_mm, high_mm = (np.ptp(np.concatenate([sections[body][:, i] for body in ('wheel', 'rail')])) for i in (0, 1))
    above = 5.8 * (high_mm + LIFT_MM) / across_mm  # of a panel 5.8 inches wide with equal scales
    figure, axes = plt.subplots(2, 2, figsize=(13, above + 5.6), height_ratios=(above, 4.0))
    y_mm, left = main_contacts(contacts, 'left')
    _, right = main_contacts(contacts, 'right')
    radius_mm = nominal_radius(contacts, sections)
    for side, axis in (('left', axes[0, 0]), ('right', axes[0, 1])):
        draw_side(axis, side, [contact for contact in contacts if contact.side == side], sections, radius_mm)
    axes[0, 0].legend(loc='lower center')
    difference_mm = [b.rolling_radius_mm - a.rolling_radius_mm for a, b in zip(left, right)]
    jumps = jumps_of(y_mm, left) | jumps_of(y_mm, right)
    axes[1, 0].plot(*parted(y_mm, difference_mm, jumps), 'o-', color=plot_style.BLUE, markersize=3)
    axes[1, 0].set_ylabel('rolling radius, right - left [mm]')
    for name, side, colour in (('left', left, plot_style.BLUE), ('right', right, plot_style.VERMILION)):
        angle_deg = [np.degrees(contact.angle_rad) for contact in side]
        axes[1, 1].plot(*parted(y_mm, angle_deg, jumps_of(y_mm, side)), 'o-', color=colour, markersize=3, label=name)
    axes[1, 1].set_ylabel('contact angle [degrees]')
    axes[1, 1].legend()
    for axis in axes[1]:
        axis.set_xlabel('wheelset displaced to the right [mm]')
    return figure


def nominal_radius(contacts: List[Contact], sections: Dict[str, np.ndarray]) -> float:
    """Radius at the taping line: the wheel's depth there is 0, so any contact on the section tells it."""
    centred = min(contacts, key=lambda contact: (abs(contact.y_mm), abs(contact.angle_rad)))
    outward_mm = -centred.y_mm if centred.side == 'right' else centred.y_mm
    wheel = sections['wheel']
    return centred.rolling_radius_mm - float(np.interp(centred.y_rail_mm + outward_mm, wheel[:, 0], wheel[:, 1]))
