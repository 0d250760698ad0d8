package org.sami.petri.pnml;

import java.util.ArrayList;
import java.util.List;

/** The nodes and arcs of a net as they stand in the file, from all of its pages. */
final class PnmlParts {
    /** The name of the net. */
    String name = "";

    final List<Node> places = new ArrayList<>();
    final List<Node> transitions = new ArrayList<>();
    final List<Reference> placeReferences = new ArrayList<>();
    final List<Reference> transitionReferences = new ArrayList<>();
    final List<Arc> arcs = new ArrayList<>();

    /**
     * A place or a transition.
     *
     * @param xmlId the id by which arcs and references name it
     * @param id the id that it has in the net, where that is no XML id or not unique in the file
     */
    record Node(String xmlId, String id, String name, int tokens, int line) {}

    /** A reference node: another name for a node on another page. */
    record Reference(String id, String target, int line) {}

    /** What an arc does. */
    enum ArcKind {
        NORMAL,
        INHIBITOR,
        RESET,
        READ
    }

    /** An arc between two ids. */
    record Arc(String id, String source, String target, int weight, ArcKind kind, int line) {
        String words() {
            return "arc " + id;
        }
    }

    int nodes() {
        return places.size() + transitions.size() + placeReferences.size() + transitionReferences.size();
    }
}
