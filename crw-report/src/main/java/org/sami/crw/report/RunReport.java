package org.sami.crw.report;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.operator.mission.Wait;

/**
 * Everything that is reported about one run. Immutable; all writers read only this.
 *
 * @param waits where the mission stood and what it waited for; empty where it is over
 * @param origin when it began, and which program reports it; empty where that was not recorded
 * @param map the areas and points of its plan, and how near boats came to one another
 * @param parts further parts, in the order of the report, each kind once
 */
public record RunReport(
        RunHeader header,
        RunResult result,
        List<BoatResult> boats,
        List<LocationResult> locations,
        List<DecisionResult> decisions,
        List<FiringResult> firings,
        List<InterruptResult> interrupts,
        List<NoteResult> notes,
        List<ReadingResult> readings,
        List<TaskResult> tasks,
        List<Wait> waits,
        Optional<RunOrigin> origin,
        RunMap map,
        List<ReportPart> parts) {
    private static final List<ReportPart> EMPTY_PARTS =
            List.of(new PhasesPart(List.of()), new OperatorActionsPart(List.of()));

    public RunReport {
        parts = List.copyOf(parts);
        Objects.requireNonNull(origin, "origin");
        Objects.requireNonNull(map, "map");
        Objects.requireNonNull(header, "header");
        Objects.requireNonNull(result, "result");
        boats = List.copyOf(boats);
        locations = List.copyOf(locations);
        decisions = List.copyOf(decisions);
        firings = SpooledList.copyOf(firings);
        interrupts = List.copyOf(interrupts);
        notes = List.copyOf(notes);
        readings = SpooledList.copyOf(readings);
        tasks = List.copyOf(tasks);
        waits = List.copyOf(waits);
    }

    /** A report of a run without tasks, of boats that measured nothing. */
    public RunReport(
            RunHeader header,
            RunResult result,
            List<BoatResult> boats,
            List<LocationResult> locations,
            List<DecisionResult> decisions,
            List<FiringResult> firings,
            List<InterruptResult> interrupts,
            List<NoteResult> notes) {
        this(header, result, boats, locations, decisions, firings, interrupts, notes, RunMap.of(boats));
    }

    /** A report of a run without tasks, of boats that measured nothing, with the areas and points of its plan. */
    public RunReport(
            RunHeader header,
            RunResult result,
            List<BoatResult> boats,
            List<LocationResult> locations,
            List<DecisionResult> decisions,
            List<FiringResult> firings,
            List<InterruptResult> interrupts,
            List<NoteResult> notes,
            RunMap map) {
        this(
                header,
                result,
                boats,
                locations,
                decisions,
                firings,
                interrupts,
                notes,
                List.of(),
                List.of(),
                List.of(),
                Optional.empty(),
                map,
                EMPTY_PARTS);
    }

    /** The same with what the boats measured. */
    public RunReport withReadings(List<ReadingResult> measured) {
        return with(measured, tasks, waits, origin, map);
    }

    /** The same with what became of the tasks. */
    public RunReport withTasks(List<TaskResult> told) {
        return with(readings, told, waits, origin, map);
    }

    /** The same with where the mission stands. */
    public RunReport withWaits(List<Wait> told) {
        return with(readings, tasks, told, origin, map);
    }

    /** The same with its start time and the reporting program. */
    public RunReport withOrigin(RunOrigin from) {
        return with(readings, tasks, waits, Optional.of(from), map);
    }

    /** The same with the areas and points of its plan. */
    public RunReport withMap(RunMap of) {
        return with(readings, tasks, waits, origin, of);
    }

    private RunReport with(
            List<ReadingResult> newReadings,
            List<TaskResult> newTasks,
            List<Wait> newWaits,
            Optional<RunOrigin> newOrigin,
            RunMap newMap) {
        return new RunReport(
                header,
                result,
                boats,
                locations,
                decisions,
                firings,
                interrupts,
                notes,
                newReadings,
                newTasks,
                newWaits,
                newOrigin,
                newMap,
                parts);
    }

    /** One of the parts that stand by themselves; empty where nobody filled it. */
    public <T extends ReportPart> Optional<T> part(Class<T> kind) {
        return parts.stream().filter(kind::isInstance).map(kind::cast).findFirst();
    }

    /** What went wrong that no plan heard of, oldest first. */
    public List<NoteResult> problems() {
        return notes.stream().filter(NoteResult::isProblem).toList();
    }

    /** Whether the mission ended and nothing went wrong that no plan heard of. */
    public boolean isGreen() {
        return result.outcome() == RunOutcome.ENDED && problems().isEmpty();
    }

    /** How many of the locations a boat has visited: truly where that is known, else by what boats reported. */
    public int locationsVisited() {
        return (int) locations.stream().filter(LocationResult::visited).count();
    }

    /** How many of the locations boats have reported to have visited. */
    public int locationsReported() {
        return (int) locations.stream()
                .filter(location -> location.reported().isPresent())
                .count();
    }

    /** How many of the locations a boat was the first to visit, counted as {@link #locationsVisited} does. */
    public long visitsBy(String boat) {
        return locations.stream()
                .filter(location -> location.visit()
                        .filter(visit -> visit.boat().equals(boat))
                        .isPresent())
                .count();
    }

    /** Metres travelled by all boats together. */
    public double distanceM() {
        return boats.stream().mapToDouble(BoatResult::distanceM).sum();
    }
}
