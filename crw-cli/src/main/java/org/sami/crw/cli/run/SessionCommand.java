package org.sami.crw.cli.run;

import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.boat.mavlink.StationAddress;
import org.sami.crw.cli.option.ConditionsConverter;
import org.sami.crw.cli.option.DomainOption;
import org.sami.crw.cli.option.JournalConverter;
import org.sami.crw.cli.option.LinkOptions;
import org.sami.crw.cli.option.NetworkOption;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.FindingsText;
import org.sami.crw.cli.output.Terminal;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.cli.station.StationLinks;
import org.sami.crw.console.Console;
import org.sami.crw.console.LineSource;
import org.sami.crw.console.PlainLines;
import org.sami.crw.console.TerminalLines;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionRuntime;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.crw.session.fault.BoatsAtFault;
import org.sami.crw.session.fault.FaultPolicy;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw session}: a session that a person runs by typed commands, or a script does (docs/console.md). */
@Command(
        name = "session",
        mixinStandardHelpOptions = true,
        description = {
            "Opens a session and reads commands from standard input: any number of missions of the project's plans, on"
                    + " one fleet.",
            "Boats can be connected, added and dropped meanwhile. At a terminal lines are edited and completed (Tab); "
                    + "'help' lists the commands.",
            "Ends with 'quit' or the end of the input; the boats of all missions are stopped then."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:it was ended, and every command was carried out",
            "1:the project has errors",
            "2:wrong usage, or there is no such file",
            "4:an internal fault: the engine stopped, its journal could not be written, memory ran out; boats were"
                    + " stopped then",
            "6:it was ended, but commands were not carried out"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw session --connect 10.0.0.11:11411,10.0.0.12:11411 --journal today.journal",
            "  crw session --near                               all boats near that are paired",
            "  crw session my-project.json",
            "  echo 'add boat 45.70,10.72 3' | crw session station-keep"
        })
public final class SessionCommand implements Callable<Integer> {
    private static final int WITH_FAULTS = 6;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private DomainOption domain = new DomainOption();

    @Mixin
    private LinkOptions links = new LinkOptions();

    @Parameters(
            paramLabel = "FILE|PLAN",
            arity = "0..1",
            description = "A project's file or folder, or a plan of the library, whose project is taken; else the whole"
                    + " library.")
    private @Nullable String name;

    @Option(
            names = "--connect",
            paramLabel = "HOST:PORT",
            split = ",",
            description = "Boats' servers to connect to; more can be connected later.")
    private List<String> connect = new ArrayList<>();

    @Option(
            names = "--near",
            description = "Look for boats on the local network for 8 s, and connect to all that are found and paired.")
    private boolean near;

    @Mixin
    private NetworkOption network = new NetworkOption();

    @Option(
            names = "--journal",
            paramLabel = "FILE",
            converter = JournalConverter.class,
            description = "Keep the session in this file, or in a database: postgresql://HOST:PORT/DATABASE. If it is"
                    + " there, its session is resumed: its project, missions, variables and boats.")
    private @Nullable JournalAddress journal;

    @Option(
            names = "--conditions",
            paramLabel = "NAME",
            converter = ConditionsConverter.class,
            description =
                    "The water of simulated boats, and the errors of boats that do not report theirs: calm, field or"
                            + " rough; paths keep that distance from no-go areas (default: calm for simulated boats, else"
                            + " field; of a session that is resumed, its own).")
    private @Nullable NamedConditions conditions;

    @Option(
            names = "--mavlink",
            paramLabel = "ADDRESS",
            description =
                    "Show the simulated boats that are added to a ground station of another maker, each as a vehicle"
                            + " of its own: " + StationAddress.FORMS + ".")
    private @Nullable String mavlink;

    @Option(
            names = "--script",
            paramLabel = "FILE",
            description = "Read commands from this file instead of standard input.")
    private @Nullable Path script;

    @Option(
            names = "--on-fault",
            paramLabel = "ACTION",
            description =
                    "What boats of missions do while the engine or its journal does not work, such as on a full disk:"
                            + " hold their places, or stop as by the fleet stop (hold or stop; default: hold).")
    private BoatsAtFault onFault = BoatsAtFault.HOLD;

    @Override
    public Integer call() throws IOException, InterruptedException {
        links.use();
        List<BoatAddress> addresses = new ArrayList<>();
        for (String text : connect) {
            try {
                addresses.addAll(BoatAddress.parseAll(text));
            } catch (IllegalArgumentException unfit) {
                throw new UsageFault("--connect: " + unfit.getMessage());
            }
        }
        if (script != null && !Files.isReadable(script)) {
            throw new UsageFault("--script: " + script + " cannot be read");
        }
        if (near) {
            for (BoatAddress found :
                    BoatSearch.connectable(network, spec.commandLine().getErr())) {
                if (!addresses.contains(found)) {
                    addresses.add(found);
                }
            }
        }
        Optional<String> unfit = Optional.ofNullable(mavlink).flatMap(StationLinks::whyNot);
        if (unfit.isPresent()) {
            throw new UsageFault("--mavlink: " + unfit.get());
        }
        if (journal != null && isThere(journal)) {
            if (name != null) {
                throw new UsageFault("the project is that of " + journal + "; leave out '" + name + "'");
            }
            SessionJournal opened = opened(journal);
            Map<String, String> settings =
                    opened.header().map(JournalHeader::settings).orElse(Map.of());
            return run(
                    SessionSetup.resumed(opened),
                    conditions == null ? NamedConditions.of(settings) : conditions,
                    Optional.ofNullable(conditions).or(() -> NamedConditions.ofWater(settings)),
                    addresses,
                    true);
        }
        Optional<DomainLibrary> words = domain.library(spec.commandLine().getErr());
        if (words.isEmpty()) {
            return ExitCode.FINDINGS;
        }
        DomainLibrary library = words.get();
        Project project = library.combined();
        if (name != null) {
            PlanSource source = PlanSource.find(name, library);
            if (source.project().isEmpty() || source.hasErrors()) {
                PrintWriter err = spec.commandLine().getErr();
                FindingsText.print(err, name, source.findings());
                err.flush();
                return ExitCode.FINDINGS;
            }
            project = source.project().get();
        }
        NamedConditions stated = conditions == null ? NamedConditions.FIELD : conditions;
        SessionSetup setup = SessionSetup.of(library.vocabulary(), project);
        if (journal != null) {
            Map<String, String> settings = new HashMap<>(stated.settings());
            Optional.ofNullable(conditions).ifPresent(water -> settings.putAll(water.waterSettings()));
            settings.put("kind", "session");
            JournalHeader header = JournalHeader.of(
                    new ProjectWriter(library.vocabulary()).text(project),
                    library.files().texts(),
                    settings);
            setup = setup.with(SessionJournal.create(journal, header));
        }
        return run(setup, stated, Optional.ofNullable(conditions), addresses, false);
    }

    /** A name that is taken by anything is no new journal. */
    private static boolean isThere(JournalAddress journal) throws IOException {
        return journal.file().isPresent() ? Files.exists(journal.file().get()) : journal.exists();
    }

    private static SessionJournal opened(JournalAddress file) throws IOException {
        SessionJournal opened = SessionJournal.open(file);
        String kind = opened.header()
                .map(header -> header.settings().getOrDefault("kind", ""))
                .orElse("");
        if (!kind.equals("session")) {
            opened.close();
            throw new UsageFault(file + " is the journal of a run; go on with it by: crw resume " + file);
        }
        return opened;
    }

    private int run(
            SessionSetup setup,
            NamedConditions stated,
            Optional<NamedConditions> water,
            List<BoatAddress> addresses,
            boolean goesOn)
            throws IOException {
        Conditions ofSimulated = water.map(NamedConditions::conditions).orElse(Conditions.CALM);
        SimulatedBoatsOnTcp simulated =
                new SimulatedBoatsOnTcp(1, ofSimulated, HandlerModules.robotsOf(setup.vocabulary()));
        StationLinks stations = new StationLinks(simulated);
        if (mavlink != null && simulated.robots() != RobotKind.BOAT) {
            throw new UsageFault("--mavlink shows boats, and this session has none");
        } else if (mavlink != null) {
            stations.start(mavlink);
        }
        SessionRuntime runtime = SessionRuntime.RealTime.ofThisProcess().withSimulatedBoats(simulated);
        boolean attended = script == null && Terminal.onStandardInputAndOutput();
        FaultPolicy policy = (attended ? FaultPolicy.ATTENDED : FaultPolicy.ALONE).with(onFault);
        try (Session session =
                        Session.open(setup.with(stated.services()).with(runtime).with(policy));
                Console console = new Console(session);
                LineSource lines = lines(console)) {
            Thread.setDefaultUncaughtExceptionHandler(session.faults().guard());
            ConsoleEnd end = new ConsoleEnd(console, lines, attended);
            session.addListener(end);
            if (goesOn) {
                Set<BoatAddress> anew = new HashSet<>(addresses);
                List<String> boats = session.earlierBoats().reconnect(anew);
                lines.print("going on with " + journal + (boats.isEmpty() ? "" : ", with " + String.join(", ", boats)));
                String damage = setup.journal().damage();
                if (!damage.isEmpty()) {
                    lines.print("crw: " + journal + " is damaged: " + damage);
                }
            }
            addresses.forEach(session.fleet()::connect);
            session.begin();
            int faults = end.run();
            boolean stoodStill = session.models().health().snapshot().missionsStandStill(); // waiting for its journal
            session.leave().forEach(lines::print);
            if (stoodStill || session.faults().failure().isPresent()) {
                return ExitCode.FAILED;
            }
            return faults == 0 ? ExitCode.OK : WITH_FAULTS;
        } finally {
            stations.stop();
            Thread.setDefaultUncaughtExceptionHandler(null);
        }
    }

    private LineSource lines(Console console) throws IOException {
        PrintWriter out = spec.commandLine().getOut();
        if (script != null) {
            return new PlainLines("--script: " + script, Files.newBufferedReader(script), out);
        }
        if (Terminal.onStandardInputAndOutput()) {
            return new TerminalLines("crw> ", console::completions, history());
        }
        return new PlainLines("standard input", new InputStreamReader(System.in, StandardCharsets.UTF_8), out);
    }

    /** Where typed lines are kept, in the folder of the command's configuration. */
    private static Path history() {
        return Path.of(System.getProperty("user.home"), ".config", "sami", "crw-session-history");
    }
}
