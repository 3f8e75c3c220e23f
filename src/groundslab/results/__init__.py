"""What an analysis returns: fields, their recovery from a solution, and the certificate."""
