package org.sami.crw.report.statistics;

import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * All missions of one plan together (thesis, Tables 6.1 to 6.3).
 *
 * @param runs number of missions
 * @param running how many of them were not over
 * @param totalMillis sum of their times; {@code leastMillis} and {@code mostMillis} of single ones
 * @param boats number of different boats
 * @param distanceM sum of metres; empty where no mission has any
 */
public record PlanStatistics(
        String plan,
        int runs,
        int running,
        long totalMillis,
        long leastMillis,
        long mostMillis,
        SortedMap<String, Integer> presses,
        int decisions,
        int answered,
        long answerMillis,
        long clicks,
        int boats,
        OptionalDouble distanceM) {
    public PlanStatistics {
        Objects.requireNonNull(plan, "plan");
        presses = Collections.unmodifiableSortedMap(new TreeMap<>(presses));
        Objects.requireNonNull(distanceM, "distanceM");
    }

    /** Of each plan, in the order of their names. */
    public static List<PlanStatistics> of(List<MissionFigures> missions) {
        return missions.stream().map(MissionFigures::plan).distinct().sorted().toList().stream()
                .map(plan -> together(
                        plan,
                        missions.stream().filter(one -> one.plan().equals(plan)).toList()))
                .toList();
    }

    private static PlanStatistics together(String plan, List<MissionFigures> missions) {
        SortedMap<String, Integer> presses = new TreeMap<>();
        TreeSet<String> boats = new TreeSet<>();
        for (MissionFigures mission : missions) {
            mission.presses().forEach((name, count) -> presses.merge(name, count, Integer::sum));
            boats.addAll(mission.boats());
        }
        List<OptionalDouble> distances = missions.stream()
                .map(MissionFigures::distanceM)
                .filter(OptionalDouble::isPresent)
                .toList();
        return new PlanStatistics(
                plan,
                missions.size(),
                (int) missions.stream().filter(one -> !one.isOver()).count(),
                missions.stream().mapToLong(MissionFigures::millis).sum(),
                missions.stream().mapToLong(MissionFigures::millis).min().orElse(0),
                missions.stream().mapToLong(MissionFigures::millis).max().orElse(0),
                presses,
                missions.stream().mapToInt(MissionFigures::decisions).sum(),
                missions.stream().mapToInt(MissionFigures::answered).sum(),
                missions.stream().mapToLong(MissionFigures::answerMillis).sum(),
                missions.stream().mapToLong(MissionFigures::clicks).sum(),
                boats.size(),
                distances.isEmpty()
                        ? OptionalDouble.empty()
                        : OptionalDouble.of(distances.stream()
                                .mapToDouble(OptionalDouble::getAsDouble)
                                .sum()));
    }

    /** The mean time of a mission. */
    public long meanMillis() {
        return Math.round((double) totalMillis / runs);
    }

    /** How long a question stood before the operator answered it, on average; empty where the operator answered none. */
    public OptionalDouble meanAnswerMillis() {
        return answered == 0 ? OptionalDouble.empty() : OptionalDouble.of((double) answerMillis / answered);
    }
}
