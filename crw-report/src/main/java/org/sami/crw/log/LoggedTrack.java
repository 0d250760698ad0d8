package org.sami.crw.log;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * The positions of one kind that a log holds.
 *
 * @param positions how many
 * @param distanceM metres along them, jumps left out
 * @param stretchCount in how many pieces jumps divide it
 * @param stretches the pieces, the first {@value TrackBuilder#MOST_STRETCHES} of them
 */
public record LoggedTrack(long positions, double distanceM, int stretchCount, List<TrackSegment> stretches) {
    public LoggedTrack {
        stretches = List.copyOf(stretches);
    }

    /** The longest stretch; of equal ones the one with most positions, then the first. */
    Optional<TrackSegment> main() {
        return stretches.stream()
                .max(Comparator.comparingDouble(TrackSegment::distanceM)
                        .thenComparingLong(TrackSegment::positions)
                        .thenComparing(
                                Comparator.comparingInt(TrackSegment::number).reversed()));
    }
}
