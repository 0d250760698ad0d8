package org.sami.petri.pnml;

import java.util.List;

/**
 * How many colours a term has at least and at most, whatever its variables stand for: what would be too large is known before it is built.
 *
 * @param least how many colours it has for certain, each at least once
 * @param most how many colours it has at most, those counted below 0 as well
 * @param isSigned whether it subtracts, so that another term may lose colours when it is added
 */
record ColourBounds(long least, long most, boolean isSigned) {
    private static final long MANY = 1L << 31;

    /** The bounds of a term. */
    static ColourBounds of(XmlTerm term, ColourDeclarations declared) throws RefusedPnmlException {
        return switch (term.name()) {
            case "variable", "dotconstant", "booleanconstant", "finiteintrangeconstant" -> exactly(1);
            case "useroperator" -> {
                long colours = declared.constantOfColours(term).counts().size();
                yield new ColourBounds(Math.min(1, colours), Math.max(1, colours), false);
            }
            case "all" -> exactly(declared.sort(term.only()).size());
            case "successor", "predecessor" -> of(term.arguments(1).get(0), declared);
            case "tuple" -> tuple(term, declared);
            case "add" -> sum(term, declared);
            case "subtract" -> difference(term.arguments(2), declared);
            case "numberof", "scalarproduct" -> multiple(term.arguments(2), declared);
            default -> new ColourBounds(0, MANY, true);
        };
    }

    private static ColourBounds exactly(long colours) {
        return new ColourBounds(colours, colours, false);
    }

    private static ColourBounds tuple(XmlTerm term, ColourDeclarations declared) throws RefusedPnmlException {
        ColourBounds all = exactly(1);
        for (XmlTerm part : term.arguments()) {
            ColourBounds one = of(part, declared);
            all = new ColourBounds(
                    Math.min(MANY, all.least * one.least),
                    Math.min(MANY, all.most * one.most),
                    all.isSigned || one.isSigned);
        }
        return all;
    }

    private static ColourBounds sum(XmlTerm term, ColourDeclarations declared) throws RefusedPnmlException {
        ColourBounds all = exactly(0);
        for (XmlTerm part : term.arguments()) {
            ColourBounds one = of(part, declared);
            boolean isSigned = all.isSigned || one.isSigned;
            all = new ColourBounds(
                    isSigned ? 0 : Math.max(all.least, one.least), Math.min(MANY, all.most + one.most), isSigned);
        }
        return all;
    }

    private static ColourBounds difference(List<XmlTerm> parts, ColourDeclarations declared)
            throws RefusedPnmlException {
        ColourBounds first = of(parts.get(0), declared);
        ColourBounds second = of(parts.get(1), declared);
        return new ColourBounds(Math.max(0, first.least - second.most), Math.min(MANY, first.most + second.most), true);
    }

    private static ColourBounds multiple(List<XmlTerm> parts, ColourDeclarations declared) throws RefusedPnmlException {
        ColourBounds one = of(parts.get(1), declared);
        boolean isNone = parts.get(0).value().matches("0*");
        return isNone ? new ColourBounds(0, one.most, one.isSigned) : one;
    }
}
