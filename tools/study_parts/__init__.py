"""The parts of tools/study.py. Each has run(bench), which returns (markdown, figures)."""
