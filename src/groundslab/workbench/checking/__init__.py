"""What the edited text means, found out in a process with limits of time and memory."""
