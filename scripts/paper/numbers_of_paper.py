"""The numbers that the paper prints in section 5. Times are milliseconds, memory is KB."""

# Table 1, Kitten: faces -> GDF, bisector, total, memory.
RESOLUTIONS = {
    10000: (76.11, 19.25, 95.3, 293.59),
    30000: (366.2, 187.6, 553.7, 464.87),
    60000: (758.65, 231.12, 989.8, 571.68),
    90000: (1967.8, 276.98, 2244.8, 703.70),
    120000: (3893.7, 1042.02, 4935.7, 799.31),
    150000: (6701.08, 627.39, 7328.4, 877.07),
}

GENERATORS_OF_TABLE_1 = 50

# Table 2, Spot: number of generators -> GDF, bisector, total, memory.
GENERATOR_COUNTS = {
    10: (96.62, 7.66, 104.28, 127.91),
    30: (117.1, 20.63, 137.73, 261.63),
    60: (162.2, 31.89, 194.12, 415.87),
    80: (171.0, 41.00, 211.99, 510.14),
    120: (238.4, 64.83, 303.28, 665.10),
    250: (197.9, 93.83, 292.77, 1023.87),
    500: (330.2, 164.83, 495.155, 1766.63),
}

FACES_OF_TABLE_2 = 20000

# Table 3: model, quality -> Q_avg, percent below 30 degrees, E.
QUALITIES = {
    ("Elephant", "low"): (0.598, 52.88, 0.087),
    ("Elephant", "medium"): (0.769, 10.15, 0.132),
    ("Elephant", "high"): (0.859, 0.455, 0.076),
    ("Rocker", "low"): (0.692, 27.57, 0.303),
    ("Rocker", "medium"): (0.803, 11.88, 0.154),
    ("Rocker", "high"): (0.914, 0.00, 0.222),
    ("Pegaso", "low"): (0.638, 39.43, 0.164),
    ("Pegaso", "medium"): (0.758, 11.62, 0.126),
    ("Pegaso", "high"): (0.871, 0.02, 0.120),
}

# Table 4: model -> faces, m, then GDF, VD, total, E of Xu et al. [27], and the same of the paper's method.
WINDOWS = {
    "Spot": (5856, 30, (31.15, 15.60, 46.76, 0.168), (10.32, 6.42, 16.74, 0.205)),
    "Bunny": (10000, 47, (77.98, 47.02, 125.00, 0.151), (55.28, 14.20, 69.48, 0.184)),
    "Ant": (14482, 24, (125.51, 78.50, 204.01, 0.141), (67.24, 8.31, 75.55, 0.154)),
    "Lucy": (19984, 43, (203.11, 79.10, 282.21, 1.095), (155.67, 19.92, 175.59, 1.196)),
    "Bear": (20444, 21, (234.05, 125.65, 359.70, 0.016), (104.04, 14.16, 118.2, 0.019)),
    "Handok": (20582, 35, (234.10, 93.01, 327.10, 0.042), (118.71, 18.58, 137.29, 0.073)),
    "4-kids": (25014, 83, (235.15, 109.15, 344.30, 0.308), (153.45, 37.21, 190.66, 0.562)),
}

# Table 5: model -> E of LRVD [28], E of the paper's method.
STRAIGHT_DISTANCES = {
    "sphere": (0.024, 0.016),
    "spot": (7.458, 0.205),
    "bunny": (11.310, 0.184),
    "bear": (13.001, 0.019),
}

# How many times as fast as [27] the paper calls its method: in the abstract (section 1: on average), and in section 5.3.
ABSTRACT_SPEED_UP = 3
SPEED_UPS = (2, 7)

# Figure 1: seconds for Lucy, and percent of its triangles with an angle below 30 degrees.
LUCY = (0.2, 58.1)

# Section 5.4: with more vertices than these, the factorisation of the diffusion diagram [8] is said to be hard.
FACTORISABLE_VERTICES = 10000
