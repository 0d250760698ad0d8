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
    /** So many choices of colours are tried in all transitions together. */
    private static final long MOST_CHOICES = 20_000_000;

    private final PnmlParts coloured;
    private final FindingList findings;
    private final PnmlLimits limits;
    private final ColourDeclarations declared;
    private final ColourTerms terms;
    private final PnmlParts plain = new PnmlParts();
    private final Map<String, ColourSort> sorts = new HashMap<>();
    private final Map<String, String> references = new HashMap<>();
    private long choices;

    private ColourUnfolding(PnmlParts coloured, FindingList findings, PnmlLimits limits) throws RefusedPnmlException {
        this.coloured = coloured;
        this.findings = findings;
        this.limits = limits;
        declared = new ColourDeclarations(coloured.declarations, limits.nodes());
        terms = new ColourTerms(declared);
    }

    /** The parts of the unfolded net; what is wrong in a place, transition or arc is a finding. */
    static PnmlParts unfold(PnmlParts coloured, FindingList findings, PnmlLimits limits) throws RefusedPnmlException {
        return new ColourUnfolding(coloured, findings, limits).unfold();
    }

    private PnmlParts unfold() throws RefusedPnmlException {
        plain.name = coloured.name;
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

    private void place(Node place) throws RefusedPnmlException {
        XmlTerm type = place.terms().get("type");
        ColourSort sort = type == null ? ColourSort.dot() : declared.sort(type);
        if (sort.size() + plain.nodes() > limits.nodes()) {
            throw new RefusedPnmlException(
                    "E-SIZE", place.line(), "the unfolded net has more than " + limits.nodes() + " nodes");
        }
        sorts.put(place.xmlId(), sort);
        XmlTerm initial = place.terms().get("hlinitialMarking");
        Map<Integer, Long> tokens = Map.of();
        if (initial != null) {
            ColourBag bag = terms.bag(initial, Map.of());
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

    /** An id that no node of the file has: attributes have no line ends. */
    private static String instance(String xmlId, long number) {
        return xmlId + "\n" + number;
    }

    private void transition(Node transition, List<Arc> arcs) throws RefusedPnmlException {
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
        List<String> names = List.copyOf(variables.keySet());
        Map<String, Integer> values = new HashMap<>();
        names.forEach(name -> values.put(name, 0));
        boolean isEmpty = variables.values().stream().anyMatch(sort -> sort.size() == 0);
        for (long number = 0; !isEmpty; number++) {
            if (++choices > MOST_CHOICES) {
                throw new RefusedPnmlException(
                        "E-SIZE",
                        transition.line(),
                        "the variables have more than " + MOST_CHOICES + " choices of colours");
            }
            if (condition == null || terms.isTrue(condition, values)) {
                add(transition, arcs, variables, values, number);
            }
            isEmpty = !next(names, variables, values);
        }
    }

    /** Goes on to the next choice of colours; false after the last one. */
    private static boolean next(List<String> names, Map<String, ColourSort> sorts, Map<String, Integer> values) {
        for (int i = names.size() - 1; i >= 0; i--) {
            int value = values.merge(names.get(i), 1, Integer::sum);
            ColourSort sort = sorts.get(names.get(i));
            if (sort != null && value < sort.size()) {
                return true;
            }
            values.put(names.get(i), 0);
        }
        return false;
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
        if (plain.nodes() > limits.nodes()) {
            throw new RefusedPnmlException(
                    "E-SIZE", transition.line(), "the unfolded net has more than " + limits.nodes() + " nodes");
        }
        for (Arc arc : arcs) {
            add(arc, id, values);
        }
    }

    private void add(Arc arc, String transition, Map<String, Integer> values) throws RefusedPnmlException {
        boolean isFromPlace = sorts.containsKey(end(arc.source()));
        String place = end(isFromPlace ? arc.source() : arc.target());
        ColourSort sort = sorts.getOrDefault(place, ColourSort.dot());
        XmlTerm inscription = arc.terms().get("hlinscription");
        ColourBag bag = inscription == null ? ColourBag.all(ColourSort.dot()) : terms.bag(inscription, values);
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
        if (plain.arcs.size() > limits.arcs()) {
            throw new RefusedPnmlException(
                    "E-SIZE", arc.line(), "the unfolded net has more than " + limits.arcs() + " arcs");
        }
    }
}
