package org.sami.petri.pnml;

import java.util.ArrayList;
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
    private final Map<String, ColourSort> sorts = new HashMap<>();
    private final Map<String, ColourBag> constants = new HashMap<>();
    private final Set<String> open = new HashSet<>();

    ColourDeclarations(List<XmlTerm> declarations, int mostColours) throws RefusedPnmlException {
        this.mostColours = mostColours;
        for (XmlTerm declaration : declarations) {
            switch (declaration.name()) {
                case "namedsort" -> named.put(declaration.id(), declaration);
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
        ColourSort sort = sort(declaration.only());
        open.remove(id);
        sorts.put(id, sort);
        return sort;
    }

    /** The sort that an element describes. */
    ColourSort sort(XmlTerm term) throws RefusedPnmlException {
        ColourSort sort = switch (term.name()) {
            case "usersort" -> namedSort(term.reference(), term.line());
            case "dot" -> ColourSort.dot();
            case "cyclicenumeration", "finiteenumeration" -> enumeration(term);
            case "finiteintrange" -> range(term);
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
        term.parts().forEach(constant -> names.add(constant.value().isEmpty() ? constant.id() : constant.value()));
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
        List<List<String>> parts = new ArrayList<>();
        for (XmlTerm part : term.parts()) {
            parts.addAll(sort(part).parts());
            if (parts.size() > MOST_PARTS) {
                throw new RefusedPnmlException(
                        "E-SIZE", term.line(), "a product of more than " + MOST_PARTS + " sorts is not read");
            }
        }
        return new ColourSort(parts);
    }

    /** The sort of a variable. */
    ColourSort variable(XmlTerm use) throws RefusedPnmlException {
        XmlTerm declaration = variables.get(use.reference());
        if (declaration == null) {
            throw new RefusedPnmlException("E-TERM", use.line(), "there is no variable '" + use.reference() + "'");
        }
        return sort(declaration.only());
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
