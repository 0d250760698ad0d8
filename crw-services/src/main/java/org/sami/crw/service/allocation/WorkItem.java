package org.sami.crw.service.allocation;

import java.util.Set;
import java.util.TreeSet;
import org.sami.spn.value.GeoPoint;

/**
 * Something to be done at a location by one boat.
 *
 * @param name for people; no two of a problem have the same
 * @param needs the capabilities that a boat must offer to do it; in the order of the alphabet
 */
public record WorkItem(String name, GeoPoint location, Set<String> needs) {
    public WorkItem {
        needs = java.util.Collections.unmodifiableSet(new TreeSet<>(needs));
    }

    /** A visit that any boat can make. */
    public static WorkItem visit(String name, GeoPoint location) {
        return new WorkItem(name, location, Set.of());
    }
}
