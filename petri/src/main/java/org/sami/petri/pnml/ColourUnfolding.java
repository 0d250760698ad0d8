package org.sami.petri.pnml;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.petri.pnml.PnmlParts.Arc;
import org.sami.petri.pnml.PnmlParts.ArcKind;
import org.sami.petri.pnml.PnmlParts.Node;
import org.sami.petri.pnml.PnmlParts.Reference;

/**
 * Unfolds a symmetric net: a place becomes one for each of its colours, a transition one for each choice of colours for its variables that fulfils its condition.
 * Source: ISO/IEC 15909-1, section 10. For one thread, once.
 */
final class ColourUnfolding {
    private final PnmlParts coloured;
    private final FindingList findings;
    private final PnmlLimits limits;
    private final ColourDeclarations declared;
    private final ColourTerms terms;
    private final ColourTerms termsOfColours;
    private final PnmlParts plain = new PnmlParts();
    private final Map<String, ColourSort> sorts = new HashMap<>();
    private final Map<String, String> references = new HashMap<>();
    private long nodes;
    private long arcsAtLeast;
    private long tried;

    private ColourUnfolding(PnmlParts coloured, FindingList findings, PnmlLimits limits) throws RefusedPnmlException {
        this.coloured = coloured;
        this.findings = findings;
        this.limits = limits;
        declared = new ColourDeclarations(coloured.declarations, limits.nodes());
        terms = new ColourTerms(declared, false);
        termsOfColours = new ColourTerms(declared, true);
    }

    /** The parts of the unfolded net; what is wrong in a place, transition or arc is a finding. */
    static PnmlParts unfold(PnmlParts coloured, FindingList findings, PnmlLimits limits) throws RefusedPnmlException {
        return new ColourUnfolding(coloured, findings, limits).unfold();
    }

    private PnmlParts unfold() throws RefusedPnmlException {
        plain.name = coloured.name;
        countPlaces();
        for (Node place : coloured.places) {
            place(place);
        }
        for (List<Reference> list : List.of(coloured.placeReferences, coloured.transitionReferences)) {
            list.forEach(reference -> references.put(reference.id(), reference.target()));
        }
        Map<String, List<Arc>> arcs = new HashMap<>();
        Set<String> transitions = new HashSet<>();
        coloured.transitions.forEach(transition -> transitions.add(transition.xmlId()));
        for (Arc arc : coloured.arcs) {
            String source = end(arc.source());
            String target = end(arc.target());
            boolean isFromPlace = sorts.containsKey(source) && transitions.contains(target);
            if (isFromPlace == (transitions.contains(source) && sorts.containsKey(target))) {
                findings.error(
                        "E-ARC",
                        arc.line(),
                        arc.words(),
                        "it leads from " + arc.source() + " to " + arc.target()
                                + ", not between a place and a transition, or both ids are those of either");
                continue;
            }
            arcs.computeIfAbsent(isFromPlace ? target : source, id -> new ArrayList<>())
                    .add(arc);
        }
        for (Node transition : coloured.transitions) {
            count(transition, arcs.getOrDefault(transition.xmlId(), List.of()));
        }
        for (Node transition : coloured.transitions) {
            transition(transition, arcs.getOrDefault(transition.xmlId(), List.of()));
        }
        return plain;
    }

    /** The node that an id means, over references; of those that were passed it is known afterwards. */
    private String end(String id) {
        Set<String> passed = new HashSet<>();
        String at = id;
        while (references.containsKey(at) && passed.add(at)) {
            at = references.getOrDefault(at, at);
        }
        String end = at;
        passed.forEach(reference -> references.put(reference, end));
        return end;
    }

    /** Refuses too many places before the first one is made. */
    private void countPlaces() throws RefusedPnmlException {
        for (Node place : coloured.places) {
            XmlTerm type = place.terms().get("type");
            ColourSort sort = type == null ? ColourSort.dot() : declared.sort(type);
            sorts.put(place.xmlId(), sort);
            nodes += sort.size();
            refuseNodes(place);
        }
    }

    private void refuseNodes(Node at) throws RefusedPnmlException {
        if (nodes > limits.nodes()) {
            throw new RefusedPnmlException(
                    "E-SIZE", at.line(), "the unfolded net has more than " + limits.nodes() + " nodes");
        }
    }

    private void refuseArcs(long arcs, int line) throws RefusedPnmlException {
        if (arcs > limits.arcs()) {
            throw new RefusedPnmlException("E-SIZE", line, "the unfolded net has more than " + limits.arcs() + " arcs");
        }
    }

    private void place(Node place) throws RefusedPnmlException {
        ColourSort sort = sorts.getOrDefault(place.xmlId(), ColourSort.dot());
        XmlTerm initial = place.terms().get("hlinitialMarking");
        Map<Integer, Long> tokens = Map.of();
        if (initial != null) {
            ColourBag bag = bag(initial, Map.of(), sort);
            if (!bag.sort().fits(sort)) {
                findings.error(
                        "E-TERM",
                        place.line(),
                        "place " + place.id(),
                        "the initial marking is not of the sort of the place");
                return;
            }
            tokens = bag.counts();
        }
        for (int colour = 0; colour < sort.size(); colour++) {
            long count = tokens.getOrDefault(colour, 0L);
            if (count < 0 || count > Integer.MAX_VALUE) {
                findings.error("E-NUMBER", place.line(), "place " + place.id(), count + " tokens cannot be there");
                count = 0;
            }
            String name = sort.name(colour);
            plain.places.add(new Node(
                    instance(place.xmlId(), colour),
                    place.id() + name,
                    place.name() + name,
                    (int) count,
                    place.line(),
                    Map.of()));
        }
    }

    /** The multiset of a term; where it is not of a sort, that with the colours of partitions' elements in their place. */
    private ColourBag bag(XmlTerm term, Map<String, Integer> values, ColourSort sort) throws RefusedPnmlException {
        ColourBag bag = terms.bag(term, values);
        return bag.sort().fits(sort) ? bag : termsOfColours.bag(term, values);
    }

    /** An id that no node of the file has: attributes have no line ends. */
    private static String instance(String xmlId, long number) {
        return xmlId + "\n" + number;
    }

    private Map<String, ColourSort> variables(Node transition, List<Arc> arcs) throws RefusedPnmlException {
        Map<String, ColourSort> variables = new LinkedHashMap<>();
        XmlTerm condition = transition.terms().get("condition");
        if (condition != null) {
            terms.variables(condition, variables);
        }
        for (Arc arc : arcs) {
            XmlTerm inscription = arc.terms().get("hlinscription");
            if (inscription != null) {
                terms.variables(inscription, variables);
            }
        }
        return variables;
    }

    private ColourChoices choices(Node transition, Map<String, ColourSort> variables) throws RefusedPnmlException {
        XmlTerm condition = transition.terms().get("condition");
        return new ColourChoices(declared, terms, variables, condition == null ? List.of() : List.of(condition));
    }

    /** Counts the choices of a transition, and the arcs that they have at least; refuses too many before the first one is made. */
    private void count(Node transition, List<Arc> arcs) throws RefusedPnmlException {
        ColourChoices chosen = choices(transition, variables(transition, arcs));
        long arcsOfEach = 0;
        for (long number = 0; chosen.next(tried, transition.line()); number++) {
            if (number == 0) {
                arcsOfEach = leastArcs(arcs); // terms of a transition that never fires are not looked at
            }
            nodes++;
            arcsAtLeast += arcsOfEach;
            refuseNodes(transition);
            refuseArcs(arcsAtLeast, transition.line());
        }
        tried += chosen.tried();
    }

    private long leastArcs(List<Arc> arcs) throws RefusedPnmlException {
        long least = 0;
        for (Arc arc : arcs) {
            XmlTerm inscription = arc.terms().get("hlinscription");
            if (arc.kind() == ArcKind.RESET) {
                String place = end(sorts.containsKey(end(arc.source())) ? arc.source() : arc.target());
                least += sorts.getOrDefault(place, ColourSort.dot()).size();
            } else {
                least += inscription == null
                        ? 1
                        : ColourBounds.of(inscription, declared).least();
            }
        }
        return least;
    }

    private void transition(Node transition, List<Arc> arcs) throws RefusedPnmlException {
        Map<String, ColourSort> variables = variables(transition, arcs);
        ColourChoices chosen = choices(transition, variables);
        for (long number = 0; chosen.next(0, transition.line()); number++) {
            add(transition, arcs, variables, chosen.values(), number);
        }
    }

    private void add(
            Node transition,
            List<Arc> arcs,
            Map<String, ColourSort> variables,
            Map<String, Integer> values,
            long number)
            throws RefusedPnmlException {
        List<String> chosen = new ArrayList<>();
        variables.forEach((name, sort) -> {
            String colour = sort.name(values.getOrDefault(name, 0));
            chosen.add(name + "=" + (colour.isEmpty() ? "dot" : colour.substring(1, colour.length() - 1)));
        });
        String suffix = chosen.isEmpty() ? "" : "(" + String.join(",", chosen) + ")";
        String id = instance(transition.xmlId(), number);
        plain.transitions.add(
                new Node(id, transition.id() + suffix, transition.name() + suffix, 0, transition.line(), Map.of()));
        for (Arc arc : arcs) {
            add(arc, id, values);
        }
    }

    private void add(Arc arc, String transition, Map<String, Integer> values) throws RefusedPnmlException {
        boolean isFromPlace = sorts.containsKey(end(arc.source()));
        String place = end(isFromPlace ? arc.source() : arc.target());
        ColourSort sort = sorts.getOrDefault(place, ColourSort.dot());
        XmlTerm inscription = arc.terms().get("hlinscription");
        ColourBag bag = inscription == null ? ColourBag.all(ColourSort.dot()) : bag(inscription, values, sort);
        if (arc.kind() == ArcKind.RESET) {
            bag = ColourBag.all(sort);
        }
        if (!bag.sort().fits(sort)) {
            findings.error("E-TERM", arc.line(), arc.words(), "the inscription is not of the sort of the place");
            return;
        }
        for (Map.Entry<Integer, Long> entry : bag.counts().entrySet()) {
            long count = entry.getValue();
            if (count < 0 || count > Integer.MAX_VALUE) {
                findings.error("E-NUMBER", arc.line(), arc.words(), "an arc cannot have the weight " + count);
            } else if (count > 0) {
                String instance = instance(place, entry.getKey());
                plain.arcs.add(new Arc(
                        arc.id(),
                        isFromPlace ? instance : transition,
                        isFromPlace ? transition : instance,
                        (int) count,
                        arc.kind(),
                        arc.line(),
                        Map.of()));
            }
        }
        refuseArcs(plain.arcs.size(), arc.line());
    }
}
