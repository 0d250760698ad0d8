package org.sami.crw.report;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Something that an operator did, or noted.
 *
 * @param kind such as {@code answer} or {@code note}
 * @param mission the mission concerned; 0 for none in particular
 * @param boats the boats concerned; may be empty
 * @param latDeg where, with {@code lonDeg}, for a note about a place
 */
public record OperatorAction(
        long number,
        long atMillis,
        String kind,
        String text,
        long mission,
        List<String> boats,
        Optional<Double> latDeg,
        Optional<Double> lonDeg) {
    public OperatorAction {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(text, "text");
        boats = List.copyOf(boats);
        Objects.requireNonNull(latDeg, "latDeg");
        Objects.requireNonNull(lonDeg, "lonDeg");
    }
}
