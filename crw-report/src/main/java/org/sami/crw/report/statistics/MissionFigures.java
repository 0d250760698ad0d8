package org.sami.crw.report.statistics;

import java.util.Collections;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * What one mission, or sub-mission, of a session needed.
 *
 * @param plan id of its plan
 * @param millis from its start to its end; of one that was running, to the journal's last entry
 * @param isOver whether it has ended
 * @param isRoot whether the operator started it, and not another mission
 * @param presses number of presses of each interrupt with which a transition of it fired
 * @param decisions number of questions that it asked
 * @param answered how many of them the operator answered
 * @param answerMillis how long those stood before they were answered, in sum
 * @param clicks the operator's clicks for it
 * @param boats that were in it
 * @param distanceM metres that those boats drove meanwhile; empty where the journal holds no positions
 */
public record MissionFigures(
        String plan,
        long millis,
        boolean isOver,
        boolean isRoot,
        SortedMap<String, Integer> presses,
        int decisions,
        int answered,
        long answerMillis,
        long clicks,
        SortedSet<String> boats,
        OptionalDouble distanceM) {
    public MissionFigures {
        Objects.requireNonNull(plan, "plan");
        presses = Collections.unmodifiableSortedMap(new TreeMap<>(presses));
        boats = Collections.unmodifiableSortedSet(new TreeSet<>(boats));
        Objects.requireNonNull(distanceM, "distanceM");
    }
}
