package org.sami.petri.pnml;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** The nodes and arcs of a net as they stand in the file, from all of its pages. */
final class PnmlParts {
    /** The name of the net. */
    String name = "";

    /** Whether it is a symmetric net, which is to be unfolded. */
    boolean isColoured;

    /** What a symmetric net declares: sorts, variables. */
    final List<XmlTerm> declarations = new ArrayList<>();

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
     * @param terms of a symmetric net: type, initial marking, condition, by the element's name
     */
    record Node(String xmlId, String id, String name, int tokens, int line, Map<String, XmlTerm> terms) {}

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
    record Arc(
            String id, String source, String target, int weight, ArcKind kind, int line, Map<String, XmlTerm> terms) {
        String words() {
            return "arc " + id;
        }
    }

    int nodes() {
        return places.size() + transitions.size() + placeReferences.size() + transitionReferences.size();
    }
}
