"""Makes every language's protocol code from protocol/definition. Standard library only."""
