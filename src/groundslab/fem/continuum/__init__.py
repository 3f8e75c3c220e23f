"""The elastic half-space and layered elastic continuum under the plate."""
