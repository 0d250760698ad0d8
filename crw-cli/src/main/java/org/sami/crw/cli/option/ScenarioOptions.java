package org.sami.crw.cli.option;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.run.settings.PlannedMission;
import org.sami.crw.sim.run.settings.RunInput;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Speed;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.FileTooLargeException;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options that decide a mission and its fleet, whatever its seed, its water and its speed are. */
public final class ScenarioOptions {
    @Mixin
    private FleetOptions fleet = new FleetOptions();

    @Option(
            names = "--for",
            paramLabel = "SECONDS",
            converter = SecondsConverter.class,
            description = "Stop after so much simulated time, whether or not the mission is over (default one day).")
    private @Nullable Long limitMillis;

    @Option(
            names = "--set",
            paramLabel = "NAME=VALUE",
            description =
                    "A value for what the plan would ask at its start: a field (event.field, or field where that is "
                            + "unique) or a variable (@name). May be given several times. 'crw plans' names them.")
    private Map<String, String> parameters = new LinkedHashMap<>();

    @Option(
            names = "--answer-after",
            paramLabel = "SECONDS",
            defaultValue = "5",
            converter = SecondsConverter.class,
            description = "Simulated seconds after which the simulated operator answers (default ${DEFAULT-VALUE}).")
    private long answerAfterMillis;

    @Option(
            names = "--answers",
            paramLabel = "FILE",
            description = "Answers of the simulated operator (JSON; see docs/answers-file.md). Default: all boats, "
                    + "drawn locations, the first option, yes, and default values.")
    private @Nullable Path answers;

    @Option(
            names = "--interrupt",
            paramLabel = "NAME[:BOAT]@SECONDS",
            description = "Press an interrupt so many simulated seconds after the mission's start; BOAT is a boat's "
                    + "name or a number from 1. One that no boat can take is pressed again until one can. With "
                    + "'battery' for SECONDS it is pressed for each boat whose battery turns critical. May be given "
                    + "several times. 'crw plans' names a plan's interrupts.")
    private List<String> interrupts = new ArrayList<>();

    @Option(
            names = "--also",
            paramLabel = "PLAN[@SECONDS]",
            description = "Start a mission of another plan of the project as well, or of the same once more, so many "
                    + "simulated seconds after the first (default 0). It asks the simulated operator for what it "
                    + "needs. The run is over when all missions are. May be given several times.")
    private List<String> also = new ArrayList<>();

    @Option(
            names = "--script",
            paramLabel = "FILE",
            description =
                    "Play this script in place of a plan, a command of the console a line: 'start PLAN [NAME=VALUE"
                            + " ...]', 'press INTERRUPT [BOAT ...]', 'wait SECONDS'. Its plans are those of PLAN|FILE,"
                            + " else of the library.")
    private @Nullable Path script;

    private Optional<RunScript> read = Optional.empty(); // the script, once it was needed

    /** What determines a run in addition to these options. */
    public record Rest(long seed, Conditions water, Speed speed, List<BoatAddress> addresses) {}

    /**
     * The settings of a run.
     *
     * @param plan its id
     * @param folder that the answers file and the script are looked for in
     * @throws UsageFault if they make no sense
     */
    public RunSettings settings(String plan, String mission, Rest rest, Path folder) {
        try {
            return RunSettings.of(
                            plan, mission, fleet.fleet(rest.addresses().size(), rest.seed(), rest.water(), folder))
                    .speed(rest.speed())
                    .limit(Optional.ofNullable(limitMillis)
                            .map(OptionalLong::of)
                            .orElse(OptionalLong.empty()))
                    .parameters(script(folder).map(RunScript::parameters).orElse(parameters))
                    .answerAfterMillis(answerAfterMillis)
                    .answers(answersText(folder))
                    .connect(rest.addresses())
                    .interrupts(script(folder).map(RunScript::interrupts).orElse(interrupts))
                    .also(script(folder).map(RunScript::also).orElse(also))
                    .build();
        } catch (IllegalArgumentException e) {
            throw new UsageFault(String.valueOf(e.getMessage()));
        }
    }

    /**
     * The project that a run is of.
     *
     * @param name of a plan of the library, or of a file; null where the user gave none
     * @throws UsageFault if there is no such plan and no such file, or neither a name nor a script
     */
    public PlanSource source(@Nullable String name, DomainLibrary library) {
        if (name != null) {
            return PlanSource.find(name, library);
        }
        if (script == null) {
            throw new UsageFault("Missing required parameter: 'PLAN|FILE'; a script (--script) can stand in its place");
        }
        return PlanSource.all(library);
    }

    /**
     * The plans of all missions of a run, the one that it is named after first.
     *
     * @param wanted the plan that the user named; empty text for none
     * @param folder that the script is looked for in
     * @throws UsageFault if the project has no such plan, or a time or a line of the script makes no sense
     */
    public List<Plan> plans(PlanSource source, String wanted, Vocabulary vocabulary, Path folder) {
        Project project = source.project().orElseThrow();
        Optional<RunScript> played = script(folder);
        if (played.isPresent()) {
            if (!wanted.isEmpty() || !parameters.isEmpty() || !also.isEmpty() || !interrupts.isEmpty()) {
                throw new UsageFault(
                        "--script: the script says which missions start, with which values and interrupts; "
                                + "leave out --plan, --set, --also and --interrupt");
            }
            return played.get().plans(vocabulary, project);
        }
        List<Plan> plans = new ArrayList<>(List.of(source.choose(wanted)));
        try {
            also.forEach(more ->
                    plans.add(PlannedMission.parse(more, vocabulary, project).plan()));
        } catch (IllegalArgumentException e) {
            throw new UsageFault("--also: " + e.getMessage());
        }
        return plans;
    }

    /**
     * Looks whether the interrupts of a script fit its missions.
     *
     * @throws UsageFault naming the line that does not
     */
    public void checkScript(RunPlan plan, RunSettings settings, Path folder) {
        script(folder)
                .ifPresent(played -> played.check(
                        RunInput.of(plan, settings, AnswersFile.EMPTY).interrupts(),
                        settings.isConnected() ? List.of() : settings.fleet().boatNames()));
    }

    private Optional<RunScript> script(Path folder) {
        if (script != null && read.isEmpty()) {
            read = Optional.of(RunScript.read(folder.resolve(script)));
        }
        return read;
    }

    /**
     * A fleet of what a domain commands.
     *
     * @throws UsageFault for copters where the domain has none, or not in addition
     */
    public RunSettings withRobots(RunSettings settings, RobotKind robots) {
        return fleet.withRobots(settings, robots);
    }

    /** Whether the number of boats was given. */
    boolean hasBoats() {
        return fleet.hasBoats();
    }

    /** Whether it was given where the boats lie. */
    boolean hasQuay() {
        return fleet.hasQuay();
    }

    /** Whether it was given where the area lies. */
    boolean hasCentre() {
        return fleet.hasCentre();
    }

    /** Whether a script stands in the place of a plan. */
    public boolean hasScript() {
        return script != null;
    }

    /** The answers file as it was named; the option's name where there is none. */
    public String answersFile() {
        return answers == null ? "--answers" : answers.toString();
    }

    /**
     * Where the answers file is.
     *
     * @param folder that it is looked for in
     */
    public Optional<Path> answersPath(Path folder) {
        return Optional.ofNullable(answers)
                .map(file -> folder.resolve(file).toAbsolutePath().normalize());
    }

    private String answersText(Path folder) {
        if (answers == null) {
            return "";
        }
        try {
            return BoundedFile.text(folder.resolve(answers), BoundedFile.DATA_BYTES);
        } catch (FileTooLargeException e) {
            throw new UsageFault("--answers: " + e.getMessage());
        } catch (IOException e) {
            throw new UsageFault("--answers: cannot read " + answers);
        }
    }
}
