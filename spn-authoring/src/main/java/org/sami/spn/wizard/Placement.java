package org.sami.spn.wizard;

import java.util.Optional;
import org.sami.spn.model.LayoutPoint;

/** Finds the vertex that gets what is added, or draws it with the edge that leads to it. */
final class Placement {
    private Placement() {}

    /**
     * The vertex of a target.
     *
     * @param place whether it is to be a place
     * @param name of a vertex that is drawn; may be empty
     */
    static String vertex(Growth growth, EventTarget target, boolean place, String name) {
        if (target instanceof EventTarget.OnVertex on) {
            return on.vertex();
        }
        if (target instanceof EventTarget.Free free) {
            return drawn(growth, place, name, free.at());
        }
        String behind = ((EventTarget.Behind) target).vertex();
        boolean fromPlace = growth.plan().place(behind).isPresent();
        if (fromPlace == place) {
            String blank = drawn(growth, !place, "", growth.behind(behind));
            connect(growth, behind, blank, fromPlace);
            behind = blank;
        }
        String vertex = drawn(growth, place, name, growth.behind(behind));
        connect(growth, behind, vertex, !place);
        return vertex;
    }

    private static void connect(Growth growth, String from, String to, boolean fromPlace) {
        if (fromPlace) {
            growth.connect(from, to);
        } else {
            growth.connectOut(from, to);
        }
    }

    private static String drawn(Growth growth, boolean place, String name, Optional<LayoutPoint> at) {
        return place ? growth.place(name, at) : growth.transition(name, at);
    }
}
