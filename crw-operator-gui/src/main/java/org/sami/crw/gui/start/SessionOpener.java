package org.sami.crw.gui.start;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.LostLinkWish;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionRuntime;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;
import org.sami.crw.sim.boat.WaterAround;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.spn.finding.Finding;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;
import org.sami.ui.EventThread;

/** Opens the session of a window: with the built-in fleet or with real boats, again or where an earlier window's ended. */
public final class SessionOpener {
    private static final String DOMAINS = "/org/sami/domain/";
    private static final String BEACH = DOMAINS + StartOptions.BOATS + "/deployments/katara-beach.json";
    /** The plan that is offered first, where the project has it. */
    public static final String OFFERED_PLAN = "explore-team";

    private static final String FLEET = "fleet";
    private static final String BUILT_IN = "built-in";

    private final DataDirectory data;
    private final List<BoatAddress> boats;
    private final Optional<Path> projectFile;
    private final Optional<NamedConditions> conditions;
    private final boolean beginsBuiltIn;
    private final String domain;
    private WaterAround around = WaterAround.NONE;
    private Optional<LostLinkAction> lostLinkWish = Optional.empty();
    private Optional<NamedConditions> named = Optional.empty();
    private Optional<SimulatedBoatsOnTcp> simulated = Optional.empty();

    /** An opener that states nothing about boats. */
    public SessionOpener(DataDirectory data, List<BoatAddress> boats, Optional<Path> projectFile) {
        this(data, boats, projectFile, Optional.empty());
    }

    /** An opener of what the window's options say. */
    public SessionOpener(DataDirectory data, StartOptions options) {
        this(
                data,
                options.boats(),
                options.project(),
                options.conditions(),
                options.hasBuiltInFleet(),
                options.domain());
        around = new WaterAround(options.vessels(), options.layers());
        lostLinkWish = options.lostLinkWish();
    }

    /**
     * An opener.
     *
     * @param boats servers to connect to; none = the built-in fleet
     * @param projectFile of the plans; empty = Katara Beach
     * @param conditions how simulated boats fare, and boats that do not say it; empty = calm and field, or as the session that is gone on with
     *     had it
     */
    public SessionOpener(
            DataDirectory data,
            List<BoatAddress> boats,
            Optional<Path> projectFile,
            Optional<NamedConditions> conditions) {
        this(data, boats, projectFile, conditions, boats.isEmpty(), StartOptions.BOATS);
    }

    private SessionOpener(
            DataDirectory data,
            List<BoatAddress> boats,
            Optional<Path> projectFile,
            Optional<NamedConditions> conditions,
            boolean beginsBuiltIn,
            String domain) {
        this.domain = domain;
        this.beginsBuiltIn = beginsBuiltIn;
        this.data = data;
        this.boats = List.copyOf(boats);
        this.projectFile = projectFile;
        this.conditions = conditions;
    }

    /**
     * Opens a session that begins.
     *
     * @throws IOException if the project has errors, which the message names, or the journal cannot be made
     */
    public Session openNew() throws IOException {
        DomainLibrary library = DomainLibrary.fromClassPath(DOMAINS + domain).orThrow();
        Project project = project(library);
        NamedConditions stated = conditions.orElse(NamedConditions.FIELD);
        Map<String, String> settings = new HashMap<>(stated.settings());
        conditions.ifPresent(named -> settings.putAll(named.waterSettings()));
        settings.putAll(around.settings());
        LostLinkWish.note(lostLinkWish, settings);
        settings.put("kind", "session");
        settings.put(FLEET, beginsBuiltIn ? BUILT_IN : "real");
        JournalHeader header = JournalHeader.of(
                new ProjectWriter(library.vocabulary()).text(project),
                library.files().texts(),
                settings);
        SessionSetup setup =
                SessionSetup.of(library.vocabulary(), project).with(SessionJournal.create(data.newJournal(), header));
        return opened(setup.with(stated.services()), beginsBuiltIn, conditions, around);
    }

    private Project project(DomainLibrary library) throws IOException {
        ProjectReader reader = new ProjectReader(library.vocabulary());
        Reading<Project> reading;
        if (projectFile.isPresent()) {
            Path file = projectFile.get();
            reading = BoundedFile.making(file, () -> reader.readAndCheck(file));
        } else if (!domain.equals(StartOptions.BOATS)) {
            return library.combined();
        } else {
            reading = reader.readAndCheck(beach());
        }
        Optional<Finding> wrong =
                reading.findings().stream().filter(Finding::isError).findFirst();
        if (wrong.isPresent()) {
            throw new IOException(projectFile.map(Path::toString).orElse(BEACH) + " has errors, the first: "
                    + (wrong.get().pointer().isEmpty() ? "" : wrong.get().pointer() + ": ")
                    + wrong.get().message() + " (all of them: crw check)");
        }
        return reading.orThrow();
    }

    private static String beach() throws IOException {
        try (InputStream text = SessionOpener.class.getResourceAsStream(BEACH)) {
            if (text == null) {
                throw new IOException("this program lacks its project " + BEACH);
            }
            return new String(text.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    /**
     * Opens the session of a journal, where it ended.
     *
     * @throws IOException if it cannot be read, or another process writes it
     */
    public Session resume(Path file) throws IOException {
        SessionJournal journal = SessionJournal.open(file);
        try {
            Map<String, String> settings =
                    journal.header().map(JournalHeader::settings).orElse(Map.of());
            boolean builtIn = BUILT_IN.equals(settings.get(FLEET));
            NamedConditions stated = conditions.orElse(NamedConditions.of(settings));
            return opened(
                    SessionSetup.resumed(journal).with(stated.services()),
                    builtIn && boats.isEmpty(),
                    conditions.or(() -> NamedConditions.ofWater(settings)),
                    around.orAsBefore(WaterAround.of(settings)));
        } catch (IOException | RuntimeException fault) {
            journal.close();
            throw fault;
        }
    }

    /** The conditions of simulated boats, and of those that do not say it, where somebody has named them; for the session that was opened. */
    public Optional<NamedConditions> named() {
        return named;
    }

    /** The simulated boats of the session that was opened. */
    public Optional<SimulatedBoatsOnTcp> simulated() {
        return simulated;
    }

    private Session opened(SessionSetup setup, boolean builtIn, Optional<NamedConditions> water, WaterAround also)
            throws IOException {
        named = water;
        RobotKind robots = HandlerModules.robotsOf(setup.vocabulary());
        SimulatedBoatsOnTcp launcher = new SimulatedBoatsOnTcp(
                1, water.map(NamedConditions::conditions).orElse(Conditions.CALM), robots);
        also.under(launcher);
        simulated = Optional.of(launcher);
        SessionRuntime runtime = SessionRuntime.RealTime.ofThisProcess()
                .withFront(EventThread.executor())
                .withSimulatedBoats(launcher);
        Session session = Session.open(setup.with(runtime));
        session.fleet().wish(lostLinkWish);
        List<BoatAddress> addresses = boats;
        if (builtIn) {
            addresses =
                    BuiltInFleet.launch(launcher, robots, session.earlierBoats().lastPositions());
        }
        if (setup.journal().resumedFrom().isPresent()) {
            session.earlierBoats().reconnectWithout(builtIn ? Set.copyOf(BuiltInFleet.names(robots)) : Set.of());
        }
        addresses.forEach(session.fleet()::connect);
        return session;
    }
}
