package org.sami.petri.pnml;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * A partition of a sort: each colour of the sort belongs to one of its elements, which are colours of a sort of their own in the order of the file. Immutable.
 *
 * @param base the sort that is divided
 * @param sort the sort of the elements
 * @param elementOf the number of the element to which each colour of the base belongs
 */
record PartitionSort(ColourSort base, ColourSort sort, List<Integer> elementOf) {
    PartitionSort {
        elementOf = List.copyOf(elementOf);
    }

    /** The elements to which the colours of a multiset belong. */
    ColourBag elementsOf(ColourBag colours) {
        return new ColourBag(
                sort, colours.changed(colour -> elementOf.get(colour)).counts());
    }

    /** The colours of an element, each of them once. */
    ColourBag coloursOf(int element) {
        Map<Integer, Long> colours = new TreeMap<>();
        for (int colour = 0; colour < elementOf.size(); colour++) {
            if (elementOf.get(colour) == element) {
                colours.put(colour, 1L);
            }
        }
        return new ColourBag(base, colours);
    }
}
