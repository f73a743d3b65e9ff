# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python scripts hold no mistake that pyflakes and pycodestyle see; the short list of rules is in ruff.toml."""
import house

house.run(house.tool("ruff"), "check", "--no-cache", "--config", str(house.beside("ruff.toml")),
          *map(str, house.files(".py")))
