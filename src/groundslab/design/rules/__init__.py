"""What all design codes share: the check, the combinations that count, and what a code consists of."""
