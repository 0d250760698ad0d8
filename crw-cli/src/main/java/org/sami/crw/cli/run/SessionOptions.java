package org.sami.crw.cli.run;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.sami.boat.mavlink.StationAddress;
import org.sami.crw.cli.option.ConditionsConverter;
import org.sami.crw.cli.option.DomainOption;
import org.sami.crw.cli.option.JournalConverter;
import org.sami.crw.cli.option.LayerOptions;
import org.sami.crw.cli.option.LinkOptions;
import org.sami.crw.cli.option.LostLinkOption;
import org.sami.crw.cli.option.NetworkOption;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.option.VesselsFile;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.FindingsText;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.cli.station.StationLinks;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.LostLinkWish;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.crw.session.fault.BoatsAtFault;
import org.sami.crw.session.fault.FaultPolicy;
import org.sami.crw.sim.boat.WaterAround;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.crw.sim.vessel.ForeignVessels;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** The options with which a session is opened; {@code crw session} and {@code crw serve} have them alike. */
final class SessionOptions {
    @Spec(Spec.Target.MIXEE)
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
            description =
                    "Boats' servers to connect to, or mavlink:... for ArduPilot boats; more can be connected later.")
    private List<String> connect = new ArrayList<>();

    @Option(
            names = "--near",
            description = "Look for boats on the local network for 8 s, and connect to all that are found and paired.")
    private boolean near;

    @Mixin
    private LostLinkOption lostLink = new LostLinkOption();

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
            names = "--vessels",
            paramLabel = "FILE",
            description = "Other vessels and drifting objects on the water of simulated boats (JSON; see"
                    + " docs/command-line.md), from the launch of the first boat on.")
    private @Nullable Path vessels;

    @Mixin
    private LayerOptions layers = new LayerOptions();

    @Option(
            names = "--mavlink",
            paramLabel = "ADDRESS",
            description =
                    "Show the simulated boats that are added to a ground station of another maker, each as a vehicle"
                            + " of its own: " + StationAddress.FORMS + ".")
    private @Nullable String mavlink;

    @Option(
            names = "--on-fault",
            paramLabel = "ACTION",
            description =
                    "What boats of missions do while the engine or its journal does not work, such as on a full disk:"
                            + " hold their places, or stop as by the fleet stop (hold or stop; default: hold).")
    private BoatsAtFault onFault = BoatsAtFault.HOLD;

    /**
     * Has the session be kept in a journal that no option names.
     *
     * @throws UsageFault if an option names one
     */
    void keepIn(JournalAddress place) {
        if (journal != null) {
            throw new UsageFault("--pair says where the session is kept; leave out --journal");
        }
        journal = place;
    }

    /**
     * Opens the session that the options name, and closes it when it has been used.
     *
     * @param attended whether somebody sits at it
     * @return the exit code
     * @throws UsageFault if the options do not fit
     */
    int open(boolean attended, SessionOpening.Use use) throws IOException, InterruptedException {
        return open(attended, Optional.empty(), use);
    }

    /**
     * The same, once another base's lease of the session is over; waits until then.
     *
     * @param lines what is waited for, for people
     * @throws java.io.InterruptedIOException if the thread is interrupted while it waits
     */
    int takeOver(Consumer<String> lines, SessionOpening.Use use) throws IOException, InterruptedException {
        if (journal == null || journal.file().isPresent()) {
            throw new UsageFault(
                    "--standby needs a database that both bases reach: --journal postgresql://HOST:PORT/DATABASE");
        }
        return open(false, Optional.of(EarlierSession.ofAnotherBase(journal, lines)), use);
    }

    private int open(boolean attended, Optional<EarlierSession> later, SessionOpening.Use use)
            throws IOException, InterruptedException {
        links.use();
        List<BoatAddress> addresses = addresses();
        Optional<String> unfit = Optional.ofNullable(mavlink).flatMap(StationLinks::whyNot);
        if (unfit.isPresent()) {
            throw new UsageFault("--mavlink: " + unfit.get());
        }
        Optional<SessionOpening.Asked> asked = later.isPresent() ? Optional.of(resumed(later.get())) : asked();
        if (asked.isEmpty()) {
            return ExitCode.FINDINGS;
        }
        FaultPolicy policy = (attended ? FaultPolicy.ATTENDED : FaultPolicy.ALONE).with(onFault);
        return new SessionOpening(asked.get(), addresses, policy, Optional.ofNullable(mavlink)).run(use);
    }

    private Optional<SessionOpening.Asked> asked() throws IOException {
        JournalAddress from = journal;
        return from != null && EarlierSession.isThere(from) ? Optional.of(resumed(EarlierSession.at(from))) : fresh();
    }

    private List<BoatAddress> addresses() throws IOException, InterruptedException {
        List<BoatAddress> addresses = new ArrayList<>();
        for (String text : connect) {
            try {
                addresses.addAll(BoatAddress.parseAll(text));
            } catch (IllegalArgumentException unfit) {
                throw new UsageFault("--connect: " + unfit.getMessage());
            }
        }
        if (near) {
            for (BoatAddress found :
                    BoatSearch.connectable(network, spec.commandLine().getErr())) {
                if (!addresses.contains(found)) {
                    addresses.add(found);
                }
            }
        }
        return addresses;
    }

    private SessionOpening.Asked resumed(EarlierSession earlier) throws IOException {
        if (name != null) {
            throw new UsageFault("the project is that of " + journal + "; leave out '" + name + "'");
        }
        SessionJournal opened = earlier.open();
        Map<String, String> settings =
                opened.header().map(JournalHeader::settings).orElse(Map.of());
        return new SessionOpening.Asked(
                SessionSetup.resumed(opened),
                conditions == null ? NamedConditions.of(settings) : conditions,
                Optional.ofNullable(conditions).or(() -> NamedConditions.ofWater(settings)),
                around().orAsBefore(WaterAround.of(settings)),
                lostLink.wish(),
                Optional.ofNullable(journal));
    }

    /** A new session; empty where its project has errors, which are printed. */
    private Optional<SessionOpening.Asked> fresh() throws IOException {
        Optional<DomainLibrary> words = domain.library(spec.commandLine().getErr());
        if (words.isEmpty()) {
            return Optional.empty();
        }
        DomainLibrary library = words.get();
        Project project = library.combined();
        if (name != null) {
            PlanSource source = PlanSource.find(name, library);
            if (source.project().isEmpty() || source.hasErrors()) {
                PrintWriter err = spec.commandLine().getErr();
                FindingsText.print(err, name, source.findings());
                err.flush();
                return Optional.empty();
            }
            project = source.project().get();
        }
        NamedConditions stated = conditions == null ? NamedConditions.FIELD : conditions;
        Map<String, String> settings = new HashMap<>(stated.settings());
        Optional.ofNullable(conditions).ifPresent(water -> settings.putAll(water.waterSettings()));
        WaterAround around = around();
        settings.putAll(around.settings());
        LostLinkWish.note(lostLink.wish(), settings);
        settings.put("kind", "session");
        JournalHeader header = JournalHeader.of(
                new ProjectWriter(library.vocabulary()).text(project),
                library.files().texts(),
                settings);
        SessionJournal kept = journal == null ? SessionJournal.none(header) : SessionJournal.create(journal, header);
        SessionSetup setup = SessionSetup.of(library.vocabulary(), project).with(kept);
        return Optional.of(new SessionOpening.Asked(
                setup, stated, Optional.ofNullable(conditions), around, lostLink.wish(), Optional.empty()));
    }

    /** What the options name; nothing where they name nothing. */
    private WaterAround around() {
        return new WaterAround(
                vessels == null ? ForeignVessels.NONE : VesselsFile.read(vessels, "--vessels"),
                layers.layers(Path.of("")));
    }
}
