package org.sami.petri.pnml;

import java.util.List;

/**
 * A sort of a symmetric net: the colours of tokens. A basic sort has one part, the names of its colours in their order; of a product each part is a basic sort.
 * Colours are numbered, those of a product with the last part first. Immutable.
 */
record ColourSort(List<List<String>> parts) {
    ColourSort {
        parts = List.copyOf(parts);
    }

    static ColourSort basic(List<String> names) {
        return new ColourSort(List.of(List.copyOf(names)));
    }

    /** The sort of uncoloured tokens. */
    static ColourSort dot() {
        return basic(List.of(""));
    }

    /** How many colours it has. */
    long size() {
        long size = 1;
        for (List<String> part : parts) {
            size = Math.min(Integer.MAX_VALUE, size * part.size());
        }
        return size;
    }

    /** Whether the colours of another sort can be put in the place of its own. */
    boolean fits(ColourSort other) {
        if (parts.size() != other.parts.size()) {
            return false;
        }
        for (int i = 0; i < parts.size(); i++) {
            if (parts.get(i).size() != other.parts.get(i).size()) {
                return false;
            }
        }
        return true;
    }

    /** The name of a colour, in brackets; empty for uncoloured tokens. */
    String name(int colour) {
        StringBuilder name = new StringBuilder();
        int rest = colour;
        for (int i = parts.size() - 1; i >= 0; i--) {
            int size = parts.get(i).size();
            String own = parts.get(i).get(rest % size);
            name.insert(0, name.length() == 0 ? own : own + ",");
            rest /= size;
        }
        return name.length() == 0 ? "" : "(" + name + ")";
    }
}
