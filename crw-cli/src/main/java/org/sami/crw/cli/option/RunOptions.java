package org.sami.crw.cli.option;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Speed;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Vocabulary;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options that decide a run. */
public final class RunOptions {
    private static final Speed DEFAULT_SPEED = new Speed(20);

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private ScenarioOptions options;

    @Option(
            names = "--connect",
            paramLabel = "HOST:PORT,...",
            description = "Use the boats whose servers listen at these addresses ('crw boat'), or vehicles that speak"
                    + " MAVLink (mavlink:...), in real time and instead of simulated ones; with --boats, beside them. The"
                    + " area lies around them.")
    private @Nullable String connect;

    @Option(
            names = "--connect-within",
            paramLabel = "SECONDS",
            defaultValue = "30",
            converter = SecondsConverter.class,
            description = "How long such boats may take to answer at the start (default ${DEFAULT-VALUE}).")
    private long connectWithinMillis;

    @Mixin
    private LostLinkOption lostLink = new LostLinkOption();

    @Option(
            names = "--seed",
            paramLabel = "S",
            defaultValue = "1",
            description =
                    "Seed of the random numbers; equal seeds give equal runs at any speed (default ${DEFAULT-VALUE}).")
    private long seed;

    @Option(
            names = "--speed",
            paramLabel = "X|max",
            converter = SpeedConverter.class,
            description = "Simulated seconds in one second; 1 is real time, max waits for nothing "
                    + "(default 20; with --connect 1, and nothing else).")
    private @Nullable Speed speed;

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private ConditionsOptions conditions;

    @Option(
            names = "--near",
            description = "Use the boats that announce themselves on the local network and are paired, or need no "
                    + "pairing: they are looked for during 8 s, and used as those of --connect.")
    private boolean near;

    @Mixin
    private NetworkOption network = new NetworkOption();

    /** Where boats are looked for; empty where none are. */
    public Optional<NetworkOption> nearOn() {
        return near ? Optional.of(network) : Optional.empty();
    }

    /**
     * The settings of a run.
     *
     * @param found addresses of boats near, which are used besides those of {@code --connect}
     */
    public RunSettings settings(String plan, String mission, List<BoatAddress> found) {
        List<BoatAddress> addresses = addresses(connect, found);
        Speed usual = addresses.isEmpty() ? DEFAULT_SPEED : Speed.REAL;
        return options.settings(
                plan,
                mission,
                new ScenarioOptions.Rest(
                        seed,
                        water(!addresses.isEmpty()),
                        Optional.ofNullable(speed).orElse(usual),
                        addresses),
                Path.of(""));
    }

    private Conditions water(boolean isConnected) {
        try {
            if (isConnected && options.hasBoats()) {
                return conditions.ofSimulatedBesides();
            }
            return isConnected ? conditions.stated() : conditions.conditions();
        } catch (IllegalArgumentException e) {
            throw new UsageFault(String.valueOf(e.getMessage()));
        }
    }

    /**
     * The settings with a fleet of what a domain commands.
     *
     * @throws UsageFault for copters where the domain has none, or not in addition
     */
    public RunSettings withRobots(RunSettings settings, RobotKind robots) {
        return options.withRobots(settings, robots);
    }

    /**
     * The project that the run is of.
     *
     * @param name of a plan of the library, or of a file; null where the user gave none
     * @throws UsageFault if there is no such plan and no such file, or neither a name nor a script
     */
    public PlanSource source(@Nullable String name, DomainLibrary library) {
        return options.source(name, library);
    }

    /**
     * The plans of all missions of the run, the one that it is named after first.
     *
     * @param wanted the plan that the user named; empty text for none
     * @throws UsageFault if the project has no such plan, or a time or a line of the script makes no sense
     */
    public List<Plan> plans(PlanSource source, String wanted, Vocabulary vocabulary) {
        return options.plans(source, wanted, vocabulary, Path.of(""));
    }

    /**
     * Looks whether the interrupts of a script fit its missions.
     *
     * @throws UsageFault naming the line that does not
     */
    public void checkScript(RunPlan plan, RunSettings settings) {
        options.checkScript(plan, settings, Path.of(""));
    }

    /** What boats that are connected are to do when their link is lost; empty where nothing is wished. */
    public Optional<LostLinkAction> lostLink() {
        return lostLink.wish();
    }

    /** How long boats behind TCP may take to answer at the start. */
    public long connectWithinMillis() {
        return connectWithinMillis;
    }

    private List<BoatAddress> addresses(@Nullable String text, List<BoatAddress> found) {
        List<BoatAddress> named = addressesOf(text);
        checkConnected();
        List<BoatAddress> all = new ArrayList<>(named);
        found.stream().filter(address -> !named.contains(address)).forEach(all::add);
        if (!found.isEmpty()) {
            UsageFault.unlessWithin("--near: the number of boats", all.size(), 1, FleetSettings.MOST_BOATS);
        }
        return all;
    }

    /** Refuses what makes no sense with boats that are connected; before any is looked for. */
    public void checkConnected() {
        boolean connected = connect != null || near;
        if (!connected && lostLink.wish().isPresent()) {
            throw new UsageFault(
                    "--lost-link is of boats that are connected; of simulated ones: --radio lost-link=ACTION");
        }
        String option = connect == null ? "--near" : "--connect";
        if (connected && options.hasBoats() && !options.hasCentre()) {
            throw new UsageFault("--boats beside " + option
                    + ": say by --at where the area lies; the simulated boats lie 20 m south of it, or at --quay");
        }
        if (connected && options.hasQuay() && !options.hasBoats()) {
            throw new UsageFault("with " + option + " the boats lie where they were started: see 'crw boat --help'");
        }
        if (connected && speed != null && !speed.equals(Speed.REAL)) {
            throw new UsageFault("--speed: boats that are connected run at speed 1, not " + speed);
        }
    }

    /** Reads {@code --connect}; none for an option that was not given. */
    public static List<BoatAddress> addressesOf(@Nullable String text) {
        if (text == null) {
            return List.of();
        }
        try {
            List<BoatAddress> addresses = BoatAddress.parseAll(text);
            UsageFault.unlessWithin("--connect: the number of boats", addresses.size(), 1, FleetSettings.MOST_BOATS);
            return addresses;
        } catch (IllegalArgumentException e) {
            throw new UsageFault("--connect: " + e.getMessage());
        }
    }

    /** The answers file as it was named; the option's name where there is none. */
    public String answersFile() {
        return options.answersFile();
    }

    /** Where the answers file is; empty where none is named. */
    public Optional<Path> answersPath() {
        return options.answersPath(Path.of(""));
    }
}
