package org.sami.petri.pnml;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;
import org.sami.petri.pnml.PnmlParts.Arc;
import org.sami.petri.pnml.PnmlParts.ArcKind;
import org.sami.petri.pnml.PnmlParts.Node;
import org.sami.petri.pnml.PnmlParts.Reference;

/** Makes a net of the parts of a file: resolves reference nodes, and finds the ends of arcs. For one thread, once. */
final class PnmlAssembly {
    private final PnmlParts parts;
    private final FindingList findings;
    private final PetriNetBuilder builder;
    private final Map<String, Integer> places = new HashMap<>();
    private final Map<String, Integer> transitions = new HashMap<>();

    PnmlAssembly(PnmlParts parts, FindingList findings) {
        this.parts = parts;
        this.findings = findings;
        builder = new PetriNetBuilder(parts.name);
    }

    /** The net; of use only where no error was found. */
    PetriNet net() {
        for (Node place : parts.places) {
            if (isNew(place, "place", places.keySet(), builder.hasPlace(place.id()))) {
                places.put(place.xmlId(), builder.place(place.id(), place.name(), place.tokens()));
            }
        }
        for (Node transition : parts.transitions) {
            if (isNew(transition, "transition", transitions.keySet(), builder.hasTransition(transition.id()))) {
                transitions.put(transition.xmlId(), builder.transition(transition.id(), transition.name()));
            }
        }
        resolve(parts.placeReferences, "place", places);
        resolve(parts.transitionReferences, "transition", transitions);
        parts.arcs.forEach(this::add);
        try {
            return builder.build();
        } catch (IllegalArgumentException tooHeavy) {
            findings.error("E-NUMBER", 0, "", String.valueOf(tooHeavy.getMessage()));
            return new PetriNetBuilder(parts.name).build();
        }
    }

    private boolean isNew(Node node, String kind, Set<String> xmlIds, boolean hasId) {
        if (hasId || xmlIds.contains(node.xmlId())) {
            findings.error("E-ID", node.line(), kind + " " + node.id(), "there is a " + kind + " with this id already");
            return false;
        }
        return true;
    }

    /** Gives each reference the node that it leads to, over other references too. */
    private void resolve(List<Reference> references, String kind, Map<String, Integer> nodes) {
        Map<String, Reference> byId = new LinkedHashMap<>();
        for (Reference reference : references) {
            if (nodes.containsKey(reference.id()) || byId.putIfAbsent(reference.id(), reference) != null) {
                findings.error(
                        "E-ID",
                        reference.line(),
                        "reference " + reference.id(),
                        "there is a " + kind + " or reference with this id already");
            }
        }
        Map<String, String> lost = new HashMap<>(); // of each reference that leads to no node: why
        for (Reference reference : byId.values()) {
            Set<String> passed = new HashSet<>();
            String at = reference.id();
            while (!nodes.containsKey(at) && !lost.containsKey(at) && byId.containsKey(at) && passed.add(at)) {
                at = byId.get(at).target();
            }
            Integer node = nodes.get(at);
            if (node == null) {
                String why =
                        lost.getOrDefault(at, byId.containsKey(at) ? "leads back to itself" : "leads to no " + kind);
                passed.forEach(id -> lost.put(id, why));
                findings.error("E-REFERENCE", reference.line(), "reference " + reference.id(), "it " + why);
            } else {
                passed.forEach(id -> nodes.put(id, node));
            }
        }
    }

    private void add(Arc arc) {
        OptionalInt sourcePlace = number(places, arc.source());
        OptionalInt sourceTransition = number(transitions, arc.source());
        OptionalInt targetPlace = number(places, arc.target());
        OptionalInt targetTransition = number(transitions, arc.target());
        boolean isFromPlace = sourcePlace.isPresent() && targetTransition.isPresent();
        boolean isFromTransition = sourceTransition.isPresent() && targetPlace.isPresent();
        if (isFromPlace && isFromTransition) {
            findings.error(
                    "E-ARC",
                    arc.line(),
                    arc.words(),
                    "both " + arc.source() + " and " + arc.target() + " are ids of a place and of a transition");
        } else if (isFromPlace) {
            fromPlace(arc, sourcePlace.getAsInt(), targetTransition.getAsInt());
        } else if (isFromTransition) {
            fromTransition(arc, sourceTransition.getAsInt(), targetPlace.getAsInt());
        } else {
            findings.error("E-ARC", arc.line(), arc.words(), whyNot(arc));
        }
    }

    private String whyNot(Arc arc) {
        for (String end : List.of(arc.source(), arc.target())) {
            if (!places.containsKey(end) && !transitions.containsKey(end)) {
                return "there is no node with the id '" + end + "'";
            }
        }
        return "it leads from " + arc.source() + " to " + arc.target() + ", not between a place and a transition";
    }

    private void fromPlace(Arc arc, int place, int transition) {
        switch (arc.kind()) {
            case NORMAL -> builder.consume(transition, place, arc.weight());
            case INHIBITOR -> builder.inhibit(transition, place, arc.weight());
            case RESET -> builder.reset(transition, place);
            case READ -> builder.consume(transition, place, arc.weight()).produce(transition, place, arc.weight());
        }
    }

    private void fromTransition(Arc arc, int transition, int place) {
        if (arc.kind() == ArcKind.NORMAL) {
            builder.produce(transition, place, arc.weight());
        } else {
            findings.error(
                    "E-ARC",
                    arc.line(),
                    arc.words(),
                    "inhibitor, reset and read arcs lead from a place to a transition");
        }
    }

    private static OptionalInt number(Map<String, Integer> nodes, String id) {
        Integer number = nodes.get(id);
        return number == null ? OptionalInt.empty() : OptionalInt.of(number);
    }
}
