package org.sami.petri.pnml;

import java.util.ArrayList;
import java.util.List;

/**
 * A sort of a symmetric net: the colours of tokens. A basic sort has one part, the names of its colours in their order; of a product each part is a basic sort.
 * Colours are numbered, those of a product with the last part first. Immutable.
 *
 * @param partitions for each part the id of the partition whose elements it has; empty for other parts
 */
record ColourSort(List<List<String>> parts, List<String> partitions) {
    ColourSort {
        parts = List.copyOf(parts);
        partitions = List.copyOf(partitions);
    }

    static ColourSort basic(List<String> names) {
        return new ColourSort(List.of(List.copyOf(names)), List.of(""));
    }

    /** The sort of the elements of a partition. */
    static ColourSort partition(String id, List<String> names) {
        return new ColourSort(List.of(List.copyOf(names)), List.of(id));
    }

    /** The sort of all pairs of a colour of one sort and a colour of another. */
    static ColourSort product(ColourSort first, ColourSort last) {
        return new ColourSort(joined(first.parts, last.parts), joined(first.partitions, last.partitions));
    }

    private static <T> List<T> joined(List<T> first, List<T> last) {
        List<T> all = new ArrayList<>(first);
        all.addAll(last);
        return all;
    }

    /** The sort of uncoloured tokens. */
    static ColourSort dot() {
        return basic(List.of(""));
    }

    /** The sort of truth values, false first. */
    static ColourSort bool() {
        return basic(List.of("false", "true"));
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
        if (!partitions.equals(other.partitions)) {
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
