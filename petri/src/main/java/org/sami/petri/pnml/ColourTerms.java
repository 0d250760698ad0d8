package org.sami.petri.pnml;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** What terms of symmetric nets mean: multisets of colours, and truth, with colours for the variables in them. */
final class ColourTerms {
    private static final Set<String> NOT_STRICT = Set.of("lessthanorequal", "greaterthanorequal");

    private static final long MOST_COLOURS = 10_000_000;

    private static final Set<String> RELATIONS = Set.of(
            "equality", "inequality", "lessthan", "lessthanorequal", "greaterthan", "greaterthanorequal", "ltp", "gtp");

    private final ColourDeclarations declared;
    private final boolean isOfColours;
    private final IdentityHashMap<XmlTerm, ColourBag> all =
            new IdentityHashMap<>(); // each transition's arcs ask for it again

    /**
     * Terms of a net.
     *
     * @param isOfColours whether an element of a partition stands for the colours in it, not for itself
     */
    ColourTerms(ColourDeclarations declared, boolean isOfColours) {
        this.declared = declared;
        this.isOfColours = isOfColours;
    }

    /** Collects the variables of a term with their sorts, in the order in which they stand there. */
    void variables(XmlTerm term, Map<String, ColourSort> into) throws RefusedPnmlException {
        if (term.name().equals("variable") && !into.containsKey(term.reference())) {
            into.put(term.reference(), declared.variable(term));
        }
        for (XmlTerm part : term.parts()) {
            variables(part, into);
        }
    }

    /** The multiset that a term stands for; a term whose counts exceed a long is refused with its line. */
    ColourBag bag(XmlTerm term, Map<String, Integer> values) throws RefusedPnmlException {
        try {
            return evaluated(term, values);
        } catch (ArithmeticException tooMany) {
            throw uncountable(term);
        }
    }

    private static RefusedPnmlException uncountable(XmlTerm term) {
        return new RefusedPnmlException(
                "E-NUMBER", term.line(), term.name() + " has more tokens of a colour than can be counted");
    }

    private ColourBag evaluated(XmlTerm term, Map<String, Integer> values) throws RefusedPnmlException {
        return switch (term.name()) {
            case "variable" -> variable(term, values);
            case "useroperator" -> isOfColours ? declared.constantOfColours(term) : declared.constant(term);
            case "dotconstant" -> ColourBag.of(ColourSort.dot(), 0);
            case "booleanconstant" ->
                ColourBag.of(ColourSort.bool(), term.value().equals("true") ? 1 : 0);
            case "finiteintrangeconstant" -> declared.number(term);
            case "all" -> {
                ColourBag known = all.get(term);
                if (known == null) {
                    known = ColourBag.all(declared.sort(term.only()));
                    all.put(term, known);
                }
                yield known;
            }
            case "empty" -> new ColourBag(declared.sort(term.only()), Map.of());
            case "tuple" -> tuple(term, values);
            case "add" -> sum(term, values);
            case "subtract" -> difference(term, values);
            case "numberof", "scalarproduct" -> multiple(term, values);
            case "successor" -> next(term, values, 1);
            case "predecessor" -> next(term, values, -1);
            case "partitionelementof" -> elementsOf(term, values);
            default -> throw unknown(term);
        };
    }

    private static RefusedPnmlException unknown(XmlTerm term) {
        return new RefusedPnmlException("E-TERM", term.line(), "terms of the kind " + term.name() + " are not read");
    }

    private ColourBag variable(XmlTerm term, Map<String, Integer> values) throws RefusedPnmlException {
        Integer value = values.get(term.reference());
        if (value == null) {
            throw new RefusedPnmlException("E-TERM", term.line(), "a variable has no value here: " + term.reference());
        }
        return ColourBag.of(declared.variable(term), value);
    }

    private ColourBag tuple(XmlTerm term, Map<String, Integer> values) throws RefusedPnmlException {
        List<XmlTerm> parts = term.arguments();
        ColourBag bag = bag(atLeastOne(term, parts).get(0), values);
        for (XmlTerm part : parts.subList(1, parts.size())) {
            ColourBag last = bag(part, values);
            if (bag.sort().size() * last.sort().size() > MOST_COLOURS) {
                throw new RefusedPnmlException("E-SIZE", term.line(), "the tuple has too many colours");
            }
            bag = bag.with(last);
        }
        return bag;
    }

    private ColourBag sum(XmlTerm term, Map<String, Integer> values) throws RefusedPnmlException {
        List<XmlTerm> parts = term.arguments();
        ColourBag bag = bag(atLeastOne(term, parts).get(0), values);
        for (XmlTerm part : parts.subList(1, parts.size())) {
            bag = bag.plus(fitting(bag, bag(part, values), part), 1);
        }
        return bag;
    }

    private ColourBag difference(XmlTerm term, Map<String, Integer> values) throws RefusedPnmlException {
        List<XmlTerm> parts = term.arguments(2);
        ColourBag first = bag(parts.get(0), values);
        return first.plus(fitting(first, bag(parts.get(1), values), term), -1);
    }

    private static List<XmlTerm> atLeastOne(XmlTerm term, List<XmlTerm> parts) throws RefusedPnmlException {
        if (parts.isEmpty()) {
            throw new RefusedPnmlException("E-TERM", term.line(), term.name() + " has no arguments");
        }
        return parts;
    }

    private static ColourBag fitting(ColourBag first, ColourBag second, XmlTerm term) throws RefusedPnmlException {
        if (!first.sort().fits(second.sort())) {
            throw new RefusedPnmlException("E-TERM", term.line(), "the sorts of the parts differ");
        }
        return second;
    }

    private ColourBag multiple(XmlTerm term, Map<String, Integer> values) throws RefusedPnmlException {
        List<XmlTerm> parts = term.arguments(2);
        XmlTerm number = parts.get(0);
        if (!number.name().equals("numberconstant") || !number.value().matches("\\d{1,9}")) {
            throw new RefusedPnmlException(
                    "E-NUMBER", number.line(), "'" + number.value() + "' is no number of tokens");
        }
        return bag(parts.get(1), values).times(Long.parseLong(number.value()));
    }

    private ColourBag elementsOf(XmlTerm term, Map<String, Integer> values) throws RefusedPnmlException {
        PartitionSort partition = declared.partitionOf(term);
        ColourBag colours = bag(term.arguments(1).get(0), values);
        if (!colours.sort().fits(partition.base())) {
            throw new RefusedPnmlException(
                    "E-TERM", term.line(), "partition " + term.reference() + " is of another sort than its argument");
        }
        return partition.elementsOf(colours);
    }

    private ColourBag next(XmlTerm term, Map<String, Integer> values, int step) throws RefusedPnmlException {
        ColourBag bag = bag(term.arguments(1).get(0), values);
        if (bag.sort().parts().size() != 1) {
            throw new RefusedPnmlException("E-TERM", term.line(), "colours of products have no " + term.name());
        }
        int size = (int) bag.sort().size();
        return bag.changed(colour -> Math.floorMod(colour + step, size));
    }

    /** Whether a condition holds. */
    boolean isTrue(XmlTerm term, Map<String, Integer> values) throws RefusedPnmlException {
        return switch (term.name()) {
            case "and" -> !hasOne(term, values, false);
            case "or" -> hasOne(term, values, true);
            case "not" -> !isTrue(term.arguments(1).get(0), values);
            case "imply" ->
                !isTrue(term.arguments(2).get(0), values)
                        || isTrue(term.arguments(2).get(1), values);
            case "booleanconstant" -> term.value().equals("true");
            case "variable" -> isTrueColour(term, values);
            case "contains" -> contains(term, values);
            default -> compare(term, values);
        };
    }

    private boolean isTrueColour(XmlTerm term, Map<String, Integer> values) throws RefusedPnmlException {
        ColourBag colour = variable(term, values);
        if (!colour.sort().equals(ColourSort.bool())) {
            throw new RefusedPnmlException("E-TERM", term.line(), term.reference() + " is neither true nor false");
        }
        return colour.counts().containsKey(1);
    }

    /** Whether the first multiset has all of the second one. */
    private boolean contains(XmlTerm term, Map<String, Integer> values) throws RefusedPnmlException {
        List<XmlTerm> parts = term.arguments(2);
        ColourBag first = bag(parts.get(0), values);
        ColourBag second = fitting(first, bag(parts.get(1), values), parts.get(1));
        try {
            return first.plus(second, -1).counts().values().stream().allMatch(count -> count >= 0);
        } catch (ArithmeticException tooMany) {
            throw uncountable(term);
        }
    }

    private boolean hasOne(XmlTerm term, Map<String, Integer> values, boolean truth) throws RefusedPnmlException {
        for (XmlTerm part : term.arguments()) {
            if (isTrue(part, values) == truth) {
                return true;
            }
        }
        return false;
    }

    private boolean compare(XmlTerm term, Map<String, Integer> values) throws RefusedPnmlException {
        if (!RELATIONS.contains(term.name())) {
            throw unknown(term);
        }
        List<XmlTerm> parts = term.arguments(2);
        ColourBag first = bag(parts.get(0), values);
        ColourBag second = fitting(first, bag(parts.get(1), values), term);
        boolean isEqual = first.counts().equals(second.counts());
        if (term.name().equals("equality") || term.name().equals("inequality")) {
            return isEqual == term.name().equals("equality");
        }
        if (isEqual) {
            return NOT_STRICT.contains(term.name());
        }
        boolean isLess = only(first, term) < only(second, term);
        return isLess == (term.name().startsWith("less") || term.name().equals("ltp"));
    }

    private static int only(ColourBag bag, XmlTerm term) throws RefusedPnmlException {
        if (bag.counts().size() != 1) {
            throw new RefusedPnmlException("E-TERM", term.line(), "only single colours are compared");
        }
        return bag.counts().keySet().iterator().next();
    }
}
