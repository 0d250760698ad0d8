package org.sami.petri.pnml;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Conditions of one transition as functions of the numbers of its variables' colours: millions of choices are tried, and multisets for each would take minutes. What
 * compares multisets, or makes no sense, is left to {@link ColourTerms}, which says so once it is asked for. For one thread.
 */
final class CompiledConditions {
    private static final long MOST_COLOURS = 10_000_000;

    /** Whether a condition holds with these colours; -1 stands for none. */
    @FunctionalInterface
    interface Truth {
        boolean holds(int[] chosen) throws RefusedPnmlException;
    }

    @FunctionalInterface
    private interface Colour {
        int of(int[] chosen);
    }

    /** A term that is always one colour. */
    private record Single(ColourSort sort, Colour colour) {}

    private final ColourDeclarations declared;
    private final ColourTerms terms;
    private final List<String> names;
    private long multisets;

    /** Conditions over these variables, whose colours stand in the same order. */
    CompiledConditions(ColourDeclarations declared, ColourTerms terms, List<String> names) {
        this.declared = declared;
        this.terms = terms;
        this.names = names;
    }

    /** The colours by variable. */
    Map<String, Integer> values(int[] chosen) {
        Map<String, Integer> values = new HashMap<>();
        for (int i = 0; i < chosen.length; i++) {
            if (chosen[i] >= 0) {
                values.put(names.get(i), chosen[i]);
            }
        }
        return values;
    }

    Truth of(XmlTerm condition) {
        try {
            return truth(condition);
        } catch (RefusedPnmlException refused) {
            return slow(condition); // it is refused when it is asked for, which an earlier part may prevent
        }
    }

    private Truth slow(XmlTerm condition) {
        return chosen -> {
            multisets++;
            return terms.isTrue(condition, values(chosen));
        };
    }

    /** How often multisets were compared so far. */
    long multisets() {
        return multisets;
    }

    private Truth truth(XmlTerm condition) throws RefusedPnmlException {
        return switch (condition.name()) {
            case "and" -> hasOne(condition, false);
            case "or" -> hasOne(condition, true);
            case "not" -> {
                Truth inner = of(condition.arguments(1).get(0));
                yield chosen -> !inner.holds(chosen);
            }
            case "imply" -> {
                List<XmlTerm> parts = condition.arguments(2);
                Truth first = of(parts.get(0));
                Truth second = of(parts.get(1));
                yield chosen -> !first.holds(chosen) || second.holds(chosen);
            }
            case "booleanconstant" -> {
                boolean isTrue = condition.value().equals("true");
                yield chosen -> isTrue;
            }
            case "equality" -> compare(condition, true, false, false);
            case "inequality" -> compare(condition, false, true, true);
            case "lessthan", "ltp" -> compare(condition, false, true, false);
            case "lessthanorequal" -> compare(condition, true, true, false);
            case "greaterthan", "gtp" -> compare(condition, false, false, true);
            case "greaterthanorequal" -> compare(condition, true, false, true);
            default -> slow(condition);
        };
    }

    private Truth hasOne(XmlTerm condition, boolean truth) throws RefusedPnmlException {
        List<Truth> parts = new ArrayList<>();
        for (XmlTerm part : condition.arguments()) {
            parts.add(of(part));
        }
        return chosen -> {
            for (Truth part : parts) {
                if (part.holds(chosen) == truth) {
                    return truth;
                }
            }
            return !truth;
        };
    }

    private Truth compare(XmlTerm condition, boolean ifEqual, boolean ifLess, boolean ifGreater)
            throws RefusedPnmlException {
        List<XmlTerm> parts = condition.arguments(2);
        Optional<Single> first = single(parts.get(0));
        Optional<Single> second = single(parts.get(1));
        if (first.isEmpty()
                || second.isEmpty()
                || !first.get().sort().fits(second.get().sort())) {
            return slow(condition);
        }
        Colour one = first.get().colour();
        Colour other = second.get().colour();
        return chosen -> {
            int difference = Integer.compare(one.of(chosen), other.of(chosen));
            return difference == 0 ? ifEqual : difference < 0 ? ifLess : ifGreater;
        };
    }

    private Optional<Single> single(XmlTerm term) throws RefusedPnmlException {
        return switch (term.name()) {
            case "variable" -> {
                int index = names.indexOf(term.reference());
                yield index < 0
                        ? Optional.empty()
                        : Optional.of(new Single(declared.variable(term), chosen -> chosen[index]));
            }
            case "useroperator", "dotconstant", "booleanconstant", "finiteintrangeconstant" ->
                constant(terms.bag(term, Map.of()));
            case "successor" -> next(term, 1);
            case "predecessor" -> next(term, -1);
            case "tuple" -> tuple(term);
            case "partitionelementof" -> element(term);
            case "numberof" -> {
                List<XmlTerm> parts = term.arguments(2);
                boolean isOne = parts.get(0).name().equals("numberconstant")
                        && parts.get(0).value().equals("1");
                yield isOne ? single(parts.get(1)) : Optional.empty();
            }
            default -> Optional.empty();
        };
    }

    private static Optional<Single> constant(ColourBag bag) {
        if (bag.counts().size() != 1 || !bag.counts().containsValue(1L)) {
            return Optional.empty();
        }
        int colour = bag.counts().keySet().iterator().next();
        return Optional.of(new Single(bag.sort(), chosen -> colour));
    }

    private Optional<Single> next(XmlTerm term, int step) throws RefusedPnmlException {
        return single(term.arguments(1).get(0))
                .filter(inner -> inner.sort().parts().size() == 1)
                .map(inner -> {
                    int size = (int) inner.sort().size();
                    Colour colour = inner.colour();
                    return new Single(inner.sort(), chosen -> Math.floorMod(colour.of(chosen) + step, size));
                });
    }

    private Optional<Single> tuple(XmlTerm term) throws RefusedPnmlException {
        Single tuple = null;
        for (XmlTerm part : term.arguments()) {
            Optional<Single> next = single(part);
            if (next.isEmpty()) {
                return Optional.empty();
            }
            tuple = tuple == null ? next.get() : pair(tuple, next.get());
            if (tuple.sort().size() > MOST_COLOURS) {
                return Optional.empty();
            }
        }
        return Optional.ofNullable(tuple);
    }

    private static Single pair(Single first, Single last) {
        int size = (int) last.sort().size();
        Colour high = first.colour();
        Colour low = last.colour();
        return new Single(
                ColourSort.product(first.sort(), last.sort()), chosen -> high.of(chosen) * size + low.of(chosen));
    }

    private Optional<Single> element(XmlTerm term) throws RefusedPnmlException {
        PartitionSort partition = declared.partitionOf(term);
        return single(term.arguments(1).get(0))
                .filter(inner -> inner.sort().fits(partition.base()))
                .map(inner -> {
                    Colour colour = inner.colour();
                    return new Single(
                            partition.sort(), chosen -> partition.elementOf().get(colour.of(chosen)));
                });
    }
}
