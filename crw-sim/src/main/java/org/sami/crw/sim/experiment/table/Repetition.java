package org.sami.crw.sim.experiment.table;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.BooleanSupplier;
import org.sami.crw.sim.experiment.table.ConfigurationScripts.Incidents;
import org.sami.crw.sim.experiment.table.ExperimentFile.Configuration;
import org.sami.crw.sim.run.incident.IncidentKind;
import org.sami.crw.sim.run.incident.IncidentKind.PlannedIncident;
import org.sami.crw.sim.run.incident.IncidentRun;
import org.sami.crw.sim.run.incident.IncidentRunInput;
import org.sami.crw.sim.run.incident.IncidentRunResult;
import org.sami.crw.sim.run.incident.IncidentScript;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * One repetition of a configuration: every version once, with equal locations, batteries and incidents. Where incidents come too late, or never, all are drawn
 * again; the attempts before the last do not count.
 */
final class Repetition {
    /** The name of the run that says when incidents can happen. */
    static final String UNDISTURBED = "undisturbed";

    private static final int MOST_ATTEMPTS = 20;
    private static final long NEXT_ATTEMPT = 1_000_003;

    private final ExperimentFile file;
    private final Configuration configuration;
    private final int number;
    private final long seed;
    private final Vocabulary vocabulary;
    private final Project project;
    private final ConfigurationScripts scripts;

    /**
     * A repetition.
     *
     * @param number from 1
     * @param firstSeed seed of the first repetition
     */
    Repetition(
            ExperimentFile file,
            Configuration configuration,
            int number,
            long firstSeed,
            Vocabulary vocabulary,
            Project project) {
        this.file = file;
        this.configuration = configuration;
        this.number = number;
        seed = firstSeed + number - 1;
        this.vocabulary = vocabulary;
        Project divided = AllocationCriterion.inAll(
                project, AllocationCriterion.constant(ScenarioVariables.text(configuration.variables(), "allocation")));
        scripts = ScriptsReader.read(file, configuration.variables(), vocabulary, divided)
                .orThrow();
        this.project =
                scripts.incidents().kind() == Incidents.Kind.NONE ? divided : ChargeForWaysHome.keptByNone(divided);
    }

    String configuration() {
        return configuration.key();
    }

    int number() {
        return number;
    }

    /** Number of rows of one attempt. */
    int runs() {
        return scripts.versions().size() + (isAtTimes() ? 1 : 0);
    }

    /** Its rows where it is never made: failed runs. */
    List<RunRow> failed(String reason) {
        List<RunRow> rows = new ArrayList<>();
        if (isAtTimes()) {
            rows.add(failed(UNDISTURBED, reason));
        }
        scripts.versions().keySet().forEach(version -> rows.add(failed(version, reason)));
        return rows;
    }

    private RunRow failed(String version, String reason) {
        return RunRow.failed(new RunRow.Place(configuration.key(), number, 1, true, version, seed), reason);
    }

    private boolean isAtTimes() {
        return scripts.incidents().kind() == Incidents.Kind.TIMES;
    }

    /** Makes its runs; empty where it was stopped. */
    Optional<List<RunRow>> run(BooleanSupplier stop) {
        List<RunRow> rows = new ArrayList<>();
        for (int attempt = 1; ; attempt++) {
            Optional<List<RunRow>> made = attempt(attempt, stop);
            if (made.isEmpty()) {
                return made;
            }
            boolean isRedrawn = made.get().stream().anyMatch(this::lacksIncidents) && attempt < MOST_ATTEMPTS;
            made.get().forEach(row -> rows.add(row.counted(!isRedrawn)));
            if (!isRedrawn) {
                return Optional.of(rows);
            }
        }
    }

    private boolean lacksIncidents(RunRow row) {
        boolean isDisturbed = !row.at().version().equals(UNDISTURBED);
        return isDisturbed
                && (row.notPlaced() > 0
                        || (scripts.incidents().kind() == Incidents.Kind.INSIDE
                                && row.incidents().isEmpty()));
    }

    private Optional<List<RunRow>> attempt(int attempt, BooleanSupplier stop) {
        boolean drawsLocations = scripts.incidents().kind() == Incidents.Kind.INSIDE;
        long worldSeed = drawsLocations ? seed + (attempt - 1) * NEXT_ATTEMPT : seed;
        FleetSettings fleet = ScenarioVariables.fleet(configuration.variables(), worldSeed);
        List<RunRow> rows = new ArrayList<>();
        IncidentKind kind = kind();
        if (isAtTimes()) {
            IncidentScript script =
                    Objects.requireNonNull(scripts.versions().get(file.undisturbed()), file.undisturbed());
            Optional<RunRow> undisturbed = row(UNDISTURBED, attempt, fleet, script, new IncidentKind.None(), stop);
            if (undisturbed.isEmpty()) {
                return Optional.empty();
            }
            rows.add(undisturbed.get());
            kind = drawn(undisturbed.get().seconds(), attempt, fleet.boatNames());
        }
        for (Map.Entry<String, IncidentScript> version : scripts.versions().entrySet()) {
            Optional<RunRow> made = row(version.getKey(), attempt, fleet, version.getValue(), kind, stop);
            if (made.isEmpty()) {
                return Optional.empty();
            }
            rows.add(made.get());
            if (lacksIncidents(made.get()) && attempt < MOST_ATTEMPTS) {
                break; // drawn again
            }
        }
        return Optional.of(rows);
    }

    private IncidentKind kind() {
        Incidents incidents = scripts.incidents();
        return switch (incidents.kind()) {
            case BATTERY -> new IncidentKind.CriticalBattery();
            case INSIDE -> new IncidentKind.BoatsInside(incidents.inside(), incidents.area());
            case NONE, TIMES -> new IncidentKind.None();
        };
    }

    /** Times drawn uniformly over the undisturbed mission, in order, and boats where they concern one. */
    private IncidentKind drawn(double seconds, int attempt, List<String> boats) {
        SplittableRandom random = new SplittableRandom(seed * 31 + attempt);
        List<Long> times = new ArrayList<>();
        for (int i = 0; i < scripts.incidents().count(); i++) {
            times.add(Math.round(random.nextDouble() * seconds * 1000));
        }
        return new IncidentKind.AtTimes(times.stream()
                .sorted()
                .map(time -> new PlannedIncident(
                        time,
                        scripts.incidents().ofOneBoat() ? List.of(boats.get(random.nextInt(boats.size()))) : List.of()))
                .toList());
    }

    private Optional<RunRow> row(
            String version,
            int attempt,
            FleetSettings fleet,
            IncidentScript script,
            IncidentKind kind,
            BooleanSupplier stop) {
        RunRow.Place place = new RunRow.Place(configuration.key(), number, attempt, true, version, fleet.seed());
        String of = version.equals(UNDISTURBED) ? file.undisturbed() : version;
        IncidentRunInput input = new IncidentRunInput(
                vocabulary,
                EventCriterion.inAll(project, scripts.criteria().getOrDefault(of, List.of())),
                fleet,
                ScenarioVariables.answerAfterMillis(configuration.variables()),
                ScenarioVariables.limitMillis(configuration.variables()),
                script,
                kind,
                scripts.resolution());
        try {
            Optional<IncidentRunResult> result = new IncidentRun(input).run(stop);
            return result.map(known -> RunRow.of(place, known));
        } catch (RuntimeException fault) { // a row that says so, among those of the other runs
            return Optional.of(RunRow.broken(place, fault));
        }
    }
}
