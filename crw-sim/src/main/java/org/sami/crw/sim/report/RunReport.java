package org.sami.crw.sim.report;

import java.util.List;
import java.util.Objects;

/** Everything that is told about one run. Immutable; all writers read only this. */
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
        List<TaskResult> tasks) {
    public RunReport {
        Objects.requireNonNull(header, "header");
        Objects.requireNonNull(result, "result");
        boats = List.copyOf(boats);
        locations = List.copyOf(locations);
        decisions = List.copyOf(decisions);
        firings = List.copyOf(firings);
        interrupts = List.copyOf(interrupts);
        notes = List.copyOf(notes);
        readings = List.copyOf(readings);
        tasks = List.copyOf(tasks);
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
        this(header, result, boats, locations, decisions, firings, interrupts, notes, List.of(), List.of());
    }

    /** The same with what the boats measured. */
    public RunReport withReadings(List<ReadingResult> measured) {
        return new RunReport(header, result, boats, locations, decisions, firings, interrupts, notes, measured, tasks);
    }

    /** The same with what became of the tasks. */
    public RunReport withTasks(List<TaskResult> told) {
        return new RunReport(header, result, boats, locations, decisions, firings, interrupts, notes, readings, told);
    }

    /** How many of the locations a boat has visited. */
    public int locationsVisited() {
        return (int) locations.stream().filter(LocationResult::visited).count();
    }

    /** Metres travelled by all boats together. */
    public double distanceM() {
        return boats.stream().mapToDouble(BoatResult::distanceM).sum();
    }
}
