"""What the plan that is meshed has beside plate and supports: borders and lines of loads, ground and voids; sizes."""
