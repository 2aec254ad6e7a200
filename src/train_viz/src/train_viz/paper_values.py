"""What Wu, Spiryagin, Cole, Railway Engineering Science 28 (2020), states in numbers about its three simulations.

Read from the text of Sect. 5, not from the pictures; all of the leading locomotive.
"""
PAPER = 'Wu, Spiryagin, Cole, Train energy simulation with locomotive adhesion model, Railway Engineering Science 28 (2020)'

# Traction force [kN] by place [km] and model (Fig. 6)
FORCE_KN = {3.15: {'1d': 460.0, '2d': 400.0, '3d': 416.0},
            3.45: {'1d': 460.0, '2d': 386.0, '3d': 423.0}}

# Energy by Eq. (4) from 3.0 km on, difference against 3D [%] by place [km] and model (Fig. 8)
ENERGY_AGAINST_3D = {3.6: {'1d': 7.6, '2d': -4.9},
                     4.5: {'1d': 2.5, '2d': -1.7}}

# Largest difference of force against 3D [%]: place [km], value (Fig. 9)
LARGEST_AGAINST_3D = {'1d': (3.3, 12.5), '2d': (3.4, -8.6)}

FIG9_PLACES_KM = (3.2, 3.3, 3.4, 3.5, 3.6)  # the caption's and text's samples
SLIP_LIMIT = 0.07        # Sect. 3.2
STATIC_FRICTION = 0.35   # Table 1
LEADING_MASS_KG = 134e3  # Table 2

# The case: vehicles from the head as number and mass of each [kg] (Table 2), curves as from, to [km], radius [m], and where the
# leading locomotive starts (Sect. 5)
TRAIN = [(3, LEADING_MASS_KG), (105, 120e3)]
CURVES = [(3.3, 3.6, 300.0)]
START_KM = 3.0

REPORT_PLACES_KM = sorted(set(FORCE_KN) | set(ENERGY_AGAINST_3D) | set(FIG9_PLACES_KM))


def energy_ratio(model: str, base: str, place_km: float) -> float:
    """Energy of one model over that of another, from what the paper states against 3D."""
    share = dict(ENERGY_AGAINST_3D[place_km], **{'3d': 0.0})
    return (100.0 + share[model]) / (100.0 + share[base])


def force_against(model: str, base: str, place_km: float) -> float:
    """Difference of force against another model [%], from the forces that the paper states."""
    force = FORCE_KN[place_km]
    return 100.0 * (force[model] / force[base] - 1.0)
