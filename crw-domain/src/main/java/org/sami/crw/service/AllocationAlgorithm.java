package org.sami.crw.service;

import org.sami.crw.event.Allocation;

/** Divides locations among boats and puts each boat's locations in order. Deterministic; no state. */
public interface AllocationAlgorithm {
    /** Name for people: the method of the allocations that it makes. */
    String name();

    /** An allocation in which each location is on exactly one path and every boat has a path, if an empty one. */
    Allocation allocate(AllocationProblem problem);
}
