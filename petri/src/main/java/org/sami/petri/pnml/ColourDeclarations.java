package org.sami.petri.pnml;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The sorts, constants and variables that a symmetric net declares. */
final class ColourDeclarations {
    private static final int MOST_PARTS = 64;
    private static final int MOST_LEVELS = 512;

    private final int mostColours;
    private final Map<String, XmlTerm> named = new HashMap<>();
    private final Map<String, XmlTerm> variables = new HashMap<>();
    private final Map<String, ColourSort> sortsOfVariables = new HashMap<>();
    private final Map<String, ColourSort> sorts = new HashMap<>();
    private final Map<String, ColourSort> ranges = new HashMap<>();
    private final Map<String, ColourBag> constants = new HashMap<>();
    private final Map<String, PartitionSort> partitions = new HashMap<>();
    private final Map<String, ColourBag> colours = new HashMap<>(); // of each element of a partition
    private final Set<String> open = new HashSet<>();

    ColourDeclarations(List<XmlTerm> declarations, int mostColours) throws RefusedPnmlException {
        this.mostColours = mostColours;
        for (XmlTerm declaration : declarations) {
            switch (declaration.name()) {
                case "namedsort", "partition" -> named.put(declaration.id(), declaration);
                case "variabledecl" -> variables.put(declaration.id(), declaration);
                default ->
                    throw new RefusedPnmlException(
                            "E-TERM",
                            declaration.line(),
                            "declarations of the kind " + declaration.name() + " are not read");
            }
        }
        for (String id : named.keySet()) {
            namedSort(id, 0);
        }
    }

    private ColourSort namedSort(String id, int line) throws RefusedPnmlException {
        ColourSort known = sorts.get(id);
        if (known != null) {
            return known;
        }
        XmlTerm declaration = named.get(id);
        if (declaration == null || !open.add(id)) {
            throw new RefusedPnmlException(
                    "E-TERM",
                    line,
                    declaration == null ? "there is no sort '" + id + "'" : "sort " + id + " contains itself");
        }
        if (open.size() > MOST_LEVELS) {
            throw new RefusedPnmlException(
                    "E-DEPTH",
                    declaration.line(),
                    "sorts refer to each other over more than " + MOST_LEVELS + " levels");
        }
        ColourSort sort = declaration.name().equals("partition") ? partition(declaration) : sort(declaration.only());
        open.remove(id);
        sorts.put(id, sort);
        return sort;
    }

    /** The sort that an element describes. */
    ColourSort sort(XmlTerm term) throws RefusedPnmlException {
        ColourSort sort = switch (term.name()) {
            case "usersort" -> namedSort(term.reference(), term.line());
            case "dot" -> ColourSort.dot();
            case "bool" -> ColourSort.bool();
            case "cyclicenumeration", "finiteenumeration" -> enumeration(term);
            case "finiteintrange" -> {
                ColourSort known = ranges.get(term.value());
                if (known == null) {
                    known = range(term);
                    ranges.put(term.value(), known);
                }
                yield known;
            }
            case "productsort" -> product(term);
            default ->
                throw new RefusedPnmlException(
                        "E-TERM", term.line(), "sorts of the kind " + term.name() + " are not read");
        };
        if (sort.size() > mostColours) {
            throw new RefusedPnmlException(
                    "E-SIZE",
                    term.line(),
                    "a sort has " + sort.size() + " colours or more; at most " + mostColours + " are read");
        }
        return sort;
    }

    private ColourSort enumeration(XmlTerm term) {
        List<String> names = new ArrayList<>();
        List<String> ids = term.parts().stream().map(XmlTerm::id).toList();
        term.parts().forEach(constant -> names.add(constant.nameOrId()));
        boolean isNamed =
                Set.copyOf(names).size() == names.size(); // some tools give all constants the name of their sort
        ColourSort sort = ColourSort.basic(isNamed ? names : ids);
        for (int colour = 0; colour < names.size(); colour++) {
            constants.put(term.parts().get(colour).id(), ColourBag.of(sort, colour));
        }
        return sort;
    }

    private ColourSort range(XmlTerm term) throws RefusedPnmlException {
        long first = bound(term, 0);
        long last = bound(term, 1);
        if (last < first || last - first >= mostColours) {
            throw new RefusedPnmlException(
                    "E-TERM",
                    term.line(),
                    "the range " + term.value() + " is empty, or has more than " + mostColours + " numbers");
        }
        List<String> names = new ArrayList<>();
        for (long number = first; number <= last; number++) {
            names.add(Long.toString(number));
        }
        return ColourSort.basic(names);
    }

    private static long bound(XmlTerm term, int index) throws RefusedPnmlException {
        String[] bounds = term.value().split("\\.\\.", 2);
        if (bounds.length < 2 || !bounds[index].matches("-?\\d{1,9}")) {
            throw new RefusedPnmlException("E-TERM", term.line(), "'" + term.value() + "' is no range of numbers");
        }
        return Long.parseLong(bounds[index]);
    }

    private ColourSort product(XmlTerm term) throws RefusedPnmlException {
        ColourSort product = new ColourSort(List.of(), List.of());
        for (XmlTerm part : term.parts()) {
            product = ColourSort.product(product, sort(part));
            if (product.parts().size() > MOST_PARTS) {
                throw new RefusedPnmlException(
                        "E-SIZE", term.line(), "a product of more than " + MOST_PARTS + " sorts is not read");
            }
        }
        return product;
    }

    /** The sort of a partition's elements; refuses one that does not have each colour of its sort in one element. */
    private ColourSort partition(XmlTerm term) throws RefusedPnmlException {
        List<XmlTerm> elements = term.parts().stream()
                .filter(part -> part.name().equals("partitionelement"))
                .toList();
        if (elements.size() != term.parts().size() - 1) {
            throw new RefusedPnmlException(
                    "E-TERM",
                    term.line(),
                    "partition " + term.id() + " has other parts than one sort and its elements");
        }
        ColourSort base = sort(term.parts().get(0));
        ColourSort sort = ColourSort.partition(
                term.id(), elements.stream().map(XmlTerm::nameOrId).toList());
        int[] elementOf = new int[(int) base.size()];
        Arrays.fill(elementOf, -1);
        for (int element = 0; element < elements.size(); element++) {
            for (XmlTerm colour : elements.get(element).arguments()) {
                enter(colour, element, elementOf, base, term);
            }
        }
        for (int colour = 0; colour < elementOf.length; colour++) {
            if (elementOf[colour] < 0) {
                throw outside(term, base, colour, "no element");
            }
        }
        PartitionSort partition =
                new PartitionSort(base, sort, Arrays.stream(elementOf).boxed().toList());
        partitions.put(term.id(), partition);
        for (int element = 0; element < elements.size(); element++) {
            constants.put(elements.get(element).id(), ColourBag.of(sort, element));
            colours.put(elements.get(element).id(), partition.coloursOf(element));
        }
        return sort;
    }

    private void enter(XmlTerm colour, int element, int[] elementOf, ColourSort base, XmlTerm partition)
            throws RefusedPnmlException {
        ColourBag single = colour.name().equals("finiteintrangeconstant") ? number(colour) : constant(colour);
        if (!single.sort().fits(base)) {
            throw new RefusedPnmlException(
                    "E-TERM", colour.line(), "a colour in partition " + partition.id() + " is not of its sort");
        }
        for (int number : single.counts().keySet()) {
            if (elementOf[number] >= 0) {
                throw outside(partition, base, number, "two elements");
            }
            elementOf[number] = element;
        }
    }

    private static RefusedPnmlException outside(XmlTerm partition, ColourSort base, int colour, String where) {
        return new RefusedPnmlException(
                "E-TERM",
                partition.line(),
                "colour " + base.name(colour) + " is in " + where + " of partition " + partition.id());
    }

    /** The partition that an element names. */
    PartitionSort partitionOf(XmlTerm use) throws RefusedPnmlException {
        PartitionSort partition = partitions.get(use.reference());
        if (partition == null) {
            throw new RefusedPnmlException("E-TERM", use.line(), "there is no partition '" + use.reference() + "'");
        }
        return partition;
    }

    /** A number of a range. */
    ColourBag number(XmlTerm term) throws RefusedPnmlException {
        ColourSort range = sort(term.only());
        int colour = range.parts().get(0).indexOf(term.value());
        if (colour < 0) {
            throw new RefusedPnmlException("E-TERM", term.line(), term.value() + " is not in its range");
        }
        return ColourBag.of(range, colour);
    }

    /** The sort of a variable. */
    ColourSort variable(XmlTerm use) throws RefusedPnmlException {
        ColourSort known = sortsOfVariables.get(use.reference());
        if (known != null) {
            return known;
        }
        XmlTerm declaration = variables.get(use.reference());
        if (declaration == null) {
            throw new RefusedPnmlException("E-TERM", use.line(), "there is no variable '" + use.reference() + "'");
        }
        ColourSort sort = sort(declaration.only());
        sortsOfVariables.put(use.reference(), sort);
        return sort;
    }

    /** The same constant, where an element of a partition stands for all its colours. */
    ColourBag constantOfColours(XmlTerm use) throws RefusedPnmlException {
        ColourBag all = colours.get(use.reference());
        return all == null ? constant(use) : all;
    }

    /** The constant that an element names. */
    ColourBag constant(XmlTerm use) throws RefusedPnmlException {
        ColourBag constant = constants.get(use.reference());
        if (constant == null) {
            throw new RefusedPnmlException("E-TERM", use.line(), "there is no constant '" + use.reference() + "'");
        }
        return constant;
    }
}
