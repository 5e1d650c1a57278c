# SPDX-License-Identifier: AGPL-3.0-or-later
"""What the paper prints: tables 1 to 4, and the numbers in the text of its section 5."""

# Table 1: nodes of the initial mesh and of four coarser ones. "interp" is also table 2.
TABLE_1 = {
    "interp": [67866, 30961, 15123, 8507, 5213],
    "log": [67866, 39010, 22264, 13246, 8323],
}
TABLE_1_RATIOS = {
    "interp": [2.19, 1.99, 1.77, 1.63],
    "log": [1.74, 1.75, 1.68, 1.59],
}

# Section 5.1: nodes before and after, for every height of the box's cells.
BOX = (27, 18)

# Section 5.2.
M6_SHARE_ABOVE_150 = 5  # "more than 5 %" of the nodes of the initial mesh
M6_TOP_5_PERCENT_LEVEL_4 = 39  # "less than 5 % of its nodes with an aspect ratio larger than 39"

# Table 4.
TABLE_4 = [2008248, 779558, 338762, 218850, 139522]
TABLE_4_RATIOS = [2.57, 2.3, 1.54, 1.56]

# Section 5.3. A node is isotropic below 5 on the finest mesh, and below 6 on the fourth.
FALCON_MAX_ASPECT_RATIO = 532713
FALCON_TOP_5_PERCENT = 15000
FALCON_SHARE_ISOTROPIC = 13
FALCON_LEVEL_4_MAX_ASPECT_RATIO = 82859.2
FALCON_LEVEL_4_SHARE_ISOTROPIC = 30

# Table 3: nodes in class k, whose aspect ratios are max / 2^k to max / 2^(k-1).
TABLE_3 = [
    1, 37, 1192, 42824, 98511, 110707, 122646, 124437, 126260, 125025,
    125231, 128334, 134652, 138429, 147686, 128581, 158672, 167013, 85961, 49,
]
