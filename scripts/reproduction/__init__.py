# SPDX-License-Identifier: AGPL-3.0-or-later
"""The paper's figures and tables beside ours; run by scripts/reproduce."""
