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
import org.sami.crw.sim.hull.Energy;
import org.sami.crw.sim.link.Radio;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.InitialCharges;
import org.sami.crw.sim.run.settings.PlannedMission;
import org.sami.crw.sim.run.settings.RunInput;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Site;
import org.sami.crw.sim.run.settings.Speed;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.FileTooLargeException;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.vocabulary.Vocabulary;
import picocli.CommandLine.Option;

/** The options that decide a mission and its fleet, whatever its seed, its water and its speed are. */
public final class ScenarioOptions {
    private static final int DEFAULT_BOATS = 3;
    private static final int DEFAULT_COPTERS = 2;

    @Option(
            names = "--boats",
            paramLabel = "N",
            description = "How many boats, named boat1, boat2, ...; 1 to 250 (default 3).")
    private @Nullable Integer boats;

    @Option(
            names = "--copters",
            paramLabel = "N",
            description = "How many copters, named copter1, copter2, ..., in addition to the boats; with --domain team "
                    + "(default 2 there).")
    private @Nullable Integer copters;

    @Option(
            names = "--locations",
            paramLabel = "N",
            defaultValue = "12",
            description = "How many locations the simulated operator gives; 1 to 10000 (default ${DEFAULT-VALUE}).")
    private int locations;

    @Option(
            names = "--area",
            paramLabel = "METRES",
            defaultValue = "600",
            description = "Side of the square in which they lie; 10 to 20000 (default ${DEFAULT-VALUE}).")
    private double areaM;

    @Option(
            names = "--at",
            paramLabel = "LAT,LON",
            converter = PositionConverter.class,
            description =
                    "Where its centre lies, in degrees (default 45.7,10.72; with --connect the middle of the boats). "
                            + "Nothing else moves it.")
    private @Nullable GeoPoint centre;

    @Option(
            names = "--quay",
            paramLabel = "LAT,LON",
            converter = PositionConverter.class,
            description =
                    "Where the boats of this process lie at the start and get full batteries, the middle of their "
                            + "line (default 20 m south of the square).")
    private @Nullable GeoPoint quay;

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

    @Option(
            names = "--battery",
            paramLabel = "PERCENT[,PERCENT...]",
            description = "Charge of the boats' batteries at the start, one for all or one for each (default: full).")
    private @Nullable String battery;

    @Option(
            names = "--range",
            paramLabel = "METRES",
            description =
                    "How far a full battery takes each boat of this process on average; 100 to 1000000 (default 3500).")
    private @Nullable Double rangeM;

    @Option(
            names = "--energy",
            paramLabel = "drag,hotel=WATTS,battery=WH|MPS:WATTS,...,battery=WH",
            description = "What boats of this process use: drag for a metre that costs four times as much at twice the"
                    + " speed, with a hotel load while afloat; or their own curve of power by speed, from 0 m/s"
                    + " (default: a metre costs the same at any speed, rest nothing; a battery has 148 Wh).")
    private @Nullable String energy;

    @Option(
            names = "--radio",
            paramLabel = "loss=PERCENT,range=METRES,lost-link=ACTION",
            description = "The radio of the boats of this process, all of it or parts: how many messages are lost, how"
                    + " far from the quay it reaches, and what boats do without a link: hold, return, continue or"
                    + " drift (default: nothing is lost, it reaches everywhere, hold).")
    private @Nullable String radio;

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
        int count = rest.addresses().isEmpty()
                ? Optional.ofNullable(boats).orElse(DEFAULT_BOATS)
                : rest.addresses().size();
        within("--boats", count, 1, FleetSettings.MOST_BOATS);
        int more = rest.addresses().isEmpty() && copters != null ? copters : 0;
        within("--copters", more, 0, FleetSettings.MOST_BOATS - count);
        within("--locations", locations, 1, FleetSettings.MOST_LOCATIONS);
        within("--area", areaM, FleetSettings.SHORTEST_AREA_M, FleetSettings.LONGEST_AREA_M);
        try {
            return RunSettings.of(plan, mission, fleet(count + more, rest))
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

    private FleetSettings fleet(int count, Rest rest) {
        FleetSettings fleet = new FleetSettings(count, locations, areaM, rest.seed())
                .on(rest.water())
                .with(charges())
                .at(site());
        FleetSettings ranging = rangeM == null ? fleet : fleet.withRangeM(rangeM);
        FleetSettings using = energy == null ? ranging : ranging.with(energy(energy));
        return radio == null ? using : using.over(radio(radio));
    }

    private static Energy energy(String text) {
        try {
            return Energy.parse(text);
        } catch (IllegalArgumentException e) {
            throw new UsageFault("--energy: " + e.getMessage());
        }
    }

    private static Radio radio(String text) {
        try {
            return Radio.parse(text);
        } catch (IllegalArgumentException e) {
            throw new UsageFault("--radio: " + e.getMessage());
        }
    }

    /**
     * A fleet of what a domain commands.
     *
     * @throws UsageFault for copters where the domain has none, or not in addition
     */
    public RunSettings withRobots(RunSettings settings, RobotKind robots) {
        if (copters != null && (robots != RobotKind.ROBOT || settings.isConnected())) {
            throw new UsageFault(
                    settings.isConnected()
                            ? "--copters is for simulated copters, not for robots that are connected"
                            : "--copters is for --domain team; with one kind of robots --boats says how many");
        }
        if (robots != RobotKind.ROBOT || settings.isConnected()) {
            return settings.withFleet(settings.fleet().of(robots));
        }
        FleetSettings fleet = settings.fleet();
        int ofBoats = fleet.boats() - (copters == null ? 0 : copters);
        try {
            return settings.withFleet(fleet.team(ofBoats, copters == null ? DEFAULT_COPTERS : copters));
        } catch (IllegalArgumentException e) {
            throw new UsageFault(String.valueOf(e.getMessage()));
        }
    }

    private Site site() {
        return new Site(Optional.ofNullable(centre), Optional.ofNullable(quay));
    }

    private InitialCharges charges() {
        return battery == null ? InitialCharges.FULL : InitialCharges.parse(battery);
    }

    /** Whether a script stands in the place of a plan. */
    public boolean hasScript() {
        return script != null;
    }

    /** Whether the number of boats was given. */
    boolean hasBoats() {
        return boats != null;
    }

    /** Whether it was given where the boats lie. */
    boolean hasQuay() {
        return quay != null;
    }

    public static void within(String option, double value, double least, double most) {
        if (!(value >= least && value <= most)) {
            throw new UsageFault(option + " is " + number(least) + " to " + number(most) + ", not " + number(value));
        }
    }

    private static String number(double value) {
        return value == Math.rint(value) ? String.valueOf((long) value) : String.valueOf(value);
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
