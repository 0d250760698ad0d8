package org.sami.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static java.util.stream.Collectors.toList;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;

/**
 * The module map: which packages are whose, and who may know whom. This is the one place to enter a new module or a new
 * package of the boats domain; ARCHITECTURE.md shows the same map in words.
 */
enum SamiModule {
    /** Values, vocabulary, plans, their JSON, and what is said of them: checks and repairs. */
    SPN_LANGUAGE(
            "spn-language",
            430,
            List.of(
                    "org.sami.spn.analysis..",
                    "org.sami.spn.component..",
                    "org.sami.spn.edit..",
                    "org.sami.spn.finding..",
                    "org.sami.spn.flow..",
                    "org.sami.spn.json..",
                    "org.sami.spn.model..",
                    "org.sami.spn.naming..",
                    "org.sami.spn.phase..",
                    "org.sami.spn.protocol..",
                    "org.sami.spn.sequence..",
                    "org.sami.spn.value..",
                    "org.sami.spn.vocabulary.."),
            List.of()),
    /** The engine, its host and journal. Who embeds it gets no library of layouts and no wizard. */
    SPN_CORE(
            "spn-core",
            215,
            List.of(
                    "org.sami.spn.engine..",
                    "org.sami.spn.host..",
                    "org.sami.spn.journal..",
                    "org.sami.spn.replay..",
                    "org.sami.spn.sqlite..",
                    "org.sami.spn.stepping..",
                    "org.sami.spn.testcase.."),
            List.of(SPN_LANGUAGE)),
    /** Journals in PostgreSQL. */
    JOURNAL_POSTGRES("journal-postgres", 31, List.of("org.sami.journal.postgres.."), List.of(SPN_CORE, SPN_LANGUAGE)),
    /** Work that several machines divide, in PostgreSQL: at the addresses, and by the connections, of journals there. */
    WORK_POSTGRES("work-postgres", 10, List.of("org.sami.work.postgres.."), List.of(JOURNAL_POSTGRES)),
    /** Two bases of which one replicates the other. */
    PAIR_POSTGRES("pair-postgres", 26, List.of("org.sami.pair.postgres.."), List.of(JOURNAL_POSTGRES)),
    /** Place/transition nets and their analysis: no plan and no boat. */
    PETRI("petri", 140, List.of("org.sami.petri.."), List.of()),
    /** What helps to write plans. */
    SPN_AUTHORING(
            "spn-authoring",
            230,
            List.of(
                    "org.sami.spn.advice..",
                    "org.sami.spn.drawing..",
                    "org.sami.spn.geotext..",
                    "org.sami.spn.legacy..",
                    "org.sami.spn.pattern..",
                    "org.sami.spn.plannet..",
                    "org.sami.spn.planspace..",
                    "org.sami.spn.statespace..",
                    "org.sami.spn.suggestion..",
                    "org.sami.spn.wiring..",
                    "org.sami.spn.wizard.."),
            List.of(SPN_CORE, SPN_LANGUAGE, PETRI)),
    BOAT_LINK("boat-link", 90, List.of("org.sami.boat.link.."), List.of()),
    BOAT_SERVER("boat-server-android/server", 95, List.of("org.sami.boat.server.."), List.of(BOAT_LINK)),
    /** Control board, position and motors of a real hull, on streams. */
    BOAT_HULL("boat-server-android/hull", 45, List.of("org.sami.boat.hull.."), List.of(BOAT_SERVER, BOAT_LINK)),
    /** The app on the phone of a hull: Android around server and hull. */
    BOAT_APP("boat-server-android/app", 60, List.of("org.sami.boat.app.."), List.of(BOAT_HULL, BOAT_SERVER, BOAT_LINK)),
    /** Planning over values: no engine and no boat. */
    CRW_SERVICES("crw-services", 116, List.of("org.sami.crw.event..", "org.sami.crw.service.."), List.of(SPN_LANGUAGE)),
    CRW_DOMAIN(
            "crw-domain",
            340,
            List.of(
                    "org.sami.crw.area..",
                    "org.sami.crw.decision..",
                    "org.sami.crw.fleet..",
                    "org.sami.crw.handler..",
                    "org.sami.crw.manipulation..",
                    "org.sami.crw.markup..",
                    "org.sami.crw.message..",
                    "org.sami.crw.proxy..",
                    "org.sami.crw.task.."),
            List.of(CRW_SERVICES, SPN_CORE, SPN_LANGUAGE, BOAT_LINK)),
    /** The aircraft domain: its handlers, over the proxies of the base. */
    UAV_DOMAIN(
            "uav-domain",
            38,
            List.of("org.sami.uav.."),
            List.of(CRW_DOMAIN, CRW_SERVICES, SPN_CORE, SPN_LANGUAGE, BOAT_LINK)),
    /** What a front may ask a session and see of it, wherever it runs: no session, no transport. */
    SESSION_API(
            "session-api",
            190,
            List.of(
                    "org.sami.crw.operator..",
                    "org.sami.session.api..",
                    "org.sami.session.follow..",
                    "org.sami.session.record.."),
            List.of(CRW_DOMAIN, CRW_SERVICES, SPN_CORE, SPN_LANGUAGE, BOAT_LINK)),
    CRW_SESSION(
            "crw-session",
            120,
            List.of("org.sami.crw.judgement..", "org.sami.crw.replay..", "org.sami.crw.session.."),
            List.of(SESSION_API, CRW_DOMAIN, CRW_SERVICES, SPN_CORE, SPN_LANGUAGE, BOAT_LINK)),
    /** Colours, and pictures of nets, for windows, command and reports. */
    NET_PICTURE(
            "net-picture",
            37,
            List.of("org.sami.palette..", "org.sami.picture.."),
            List.of(SPN_AUTHORING, SPN_LANGUAGE)),
    /** A session for several people. */
    SESSION_SERVER(
            "session-server",
            67,
            List.of(
                    "org.sami.session.map..",
                    "org.sami.session.person..",
                    "org.sami.session.rows..",
                    "org.sami.session.server.."),
            List.of(
                    CRW_SESSION,
                    SESSION_API,
                    CRW_DOMAIN,
                    CRW_SERVICES,
                    NET_PICTURE,
                    SPN_CORE,
                    SPN_LANGUAGE,
                    BOAT_LINK)),
    /** A session in another process, for fronts here. */
    SESSION_CLIENT(
            "session-client",
            28,
            List.of("org.sami.session.client.."),
            List.of(SESSION_API, CRW_DOMAIN, SPN_CORE, SPN_LANGUAGE, BOAT_LINK)),
    /** The course: its content, the grading of quizzes and jobs, and what learners have done. No window, no boat. */
    LESSONS("lessons", 180, List.of("org.sami.lessons.."), List.of(NET_PICTURE, SPN_AUTHORING, SPN_CORE, SPN_LANGUAGE)),
    /** Reports of runs and logs of boats. Of the boat server it uses the geometry of its local frame. */
    CRW_REPORT(
            "crw-report",
            118,
            List.of("org.sami.crw.log..", "org.sami.crw.report.."),
            List.of(
                    CRW_SESSION,
                    SESSION_API,
                    CRW_DOMAIN,
                    CRW_SERVICES,
                    NET_PICTURE,
                    BOAT_SERVER,
                    SPN_CORE,
                    SPN_LANGUAGE)),
    /** Knows the link too: both ends that its pipe joins, the proxy and the server, have the link's types in their signatures. */
    CRW_SIM(
            "crw-sim",
            280,
            List.of("org.sami.crw.sim.."),
            List.of(
                    CRW_REPORT,
                    CRW_SESSION,
                    SESSION_API,
                    CRW_DOMAIN,
                    CRW_SERVICES,
                    BOAT_HULL,
                    BOAT_SERVER,
                    BOAT_LINK,
                    SPN_CORE,
                    SPN_LANGUAGE)),
    /** Vehicles of other makers: links, what they report, what they hold. No boats of ours, no plans. */
    MAVLINK("mavlink", 160, List.of("org.sami.mavlink.."), List.of()),
    /** Our boats in ground stations of other makers: a client of the boat's server that speaks MAVLink for it. */
    BOAT_MAVLINK("boat-mavlink", 24, List.of("org.sami.boat.mavlink.."), List.of(MAVLINK, BOAT_SERVER, BOAT_LINK)),
    /** Vehicles of other makers as boats of a base: speaks the boat link for them. */
    CRW_MAVLINK(
            "crw-mavlink",
            62,
            List.of("org.sami.crw.mavlink.."),
            List.of(CRW_DOMAIN, CRW_SERVICES, MAVLINK, BOAT_SERVER, BOAT_LINK, SPN_LANGUAGE)),
    /** The command crw. */
    CRW_CLI(
            "crw-cli",
            230,
            List.of("org.sami.crw.cli..", "org.sami.crw.console.."),
            List.of(
                    CRW_SIM,
                    WORK_POSTGRES,
                    PAIR_POSTGRES,
                    JOURNAL_POSTGRES,
                    SESSION_CLIENT,
                    SESSION_SERVER,
                    CRW_REPORT,
                    CRW_SESSION,
                    SESSION_API,
                    CRW_DOMAIN,
                    CRW_SERVICES,
                    LESSONS,
                    BOAT_MAVLINK,
                    MAVLINK,
                    NET_PICTURE,
                    PETRI,
                    BOAT_HULL,
                    BOAT_SERVER,
                    BOAT_LINK,
                    SPN_AUTHORING,
                    SPN_CORE,
                    SPN_LANGUAGE)),
    /** What both windows share: looks, actions, the drawing of nets and maps, value components. */
    UI_KIT("ui-kit", 305, List.of("org.sami.ui.."), List.of(NET_PICTURE, SPN_AUTHORING, SPN_CORE, SPN_LANGUAGE)),
    /** The plan editor: what it says of events, tasks and markups it has from the domain's files alone. */
    DREAMM_IDE(
            "dreamm-ide",
            370,
            List.of("org.sami.dreamm.."),
            List.of(UI_KIT, LESSONS, NET_PICTURE, SPN_AUTHORING, PETRI, SPN_CORE, SPN_LANGUAGE)),
    /** The operator's window; it knows the simulator for its built-in fleet, the command for where there is no display and for what it shows to ground stations, and the link for words of snapshots such as modes. */
    OPERATOR_WINDOW(
            "crw-operator-gui",
            215,
            List.of("org.sami.crw.gui.."),
            List.of(
                    UI_KIT,
                    NET_PICTURE,
                    CRW_CLI,
                    CRW_SIM,
                    SESSION_CLIENT,
                    CRW_SESSION,
                    SESSION_API,
                    CRW_DOMAIN,
                    CRW_SERVICES,
                    BOAT_LINK,
                    SPN_AUTHORING,
                    SPN_CORE,
                    SPN_LANGUAGE));

    private static final Map<SamiModule, JavaClasses> IMPORTED = new ConcurrentHashMap<>();

    private final String folder;
    private final int leastClasses;
    private final List<String> packages;
    private final List<SamiModule> mayKnow;

    SamiModule(String folder, int leastClasses, List<String> packages, List<SamiModule> mayKnow) {
        this.folder = folder;
        this.leastClasses = leastClasses;
        this.packages = packages;
        this.mayKnow = mayKnow;
    }

    /** The modules that the build has today. */
    static Stream<SamiModule> built() {
        return Stream.of(values()).filter(module -> Files.isDirectory(Path.of(module.folder, "src", "main", "java")));
    }

    /** How many classes the module has at least: a test that saw fewer did not look. Raised as the module grows. */
    int leastClasses() {
        return leastClasses;
    }

    /** The packages that are the module's own, as ArchUnit writes them. */
    String[] packages() {
        return packages.toArray(String[]::new);
    }

    /** The packages of SAMI that the module's classes may use: its own, and those of the modules it may know. */
    String[] knownPackages() {
        List<String> known = new ArrayList<>(packages);
        mayKnow.forEach(module -> known.addAll(module.packages));
        return known.toArray(String[]::new);
    }

    /** The modules that this one may know and does not reach through another that it may know: the arrows of a diagram. */
    Stream<SamiModule> neighbours() {
        return mayKnow.stream().filter(known -> mayKnow.stream().noneMatch(other -> other.reaches(known)));
    }

    private boolean reaches(SamiModule other) {
        return mayKnow.stream().anyMatch(known -> known == other || known.reaches(other));
    }

    /** The module's name in the diagram of ARCHITECTURE.md. */
    String diagramName() {
        return folder.replace('/', '-');
    }

    /** The module's compiled main classes, all of them, imported once for all tests: fewer than its least number is a failure. */
    JavaClasses classes() {
        JavaClasses classes = IMPORTED.computeIfAbsent(this, SamiModule::ofAllThatWereImported);
        assertThat(classes.size()).as("classes seen in %s", this).isGreaterThanOrEqualTo(leastClasses);
        return classes;
    }

    private static JavaClasses ofAllThatWereImported(SamiModule module) {
        Path folder = module.classesFolder().toAbsolutePath();
        return AllModules.IMPORTED.that(describe(
                "in " + module,
                (JavaClass type) -> type.getSource()
                        .filter(source -> Path.of(source.getUri()).startsWith(folder))
                        .isPresent()));
    }

    /** Most tests ask for all modules: one import reads each class once, also those of other modules and of the JDK that classes use. */
    private static final class AllModules {
        static final JavaClasses IMPORTED = new ClassFileImporter()
                .importPaths(built().map(SamiModule::classesFolder).toList());
    }

    /** Where the build puts the module's compiled main classes. */
    Path classesFolder() {
        return Path.of(folder, "build", "classes", "java", "main");
    }

    /** The Java sources below the module's {@code src/main/java}, in the order of their paths. */
    List<Path> mainSources() {
        return Sources.below(Path.of(folder, "src", "main", "java"));
    }

    /** The Java sources below the module's {@code src/test/java} and {@code src/testFixtures/java}, in the order of their paths. */
    List<Path> testSources() {
        List<Path> sources = new ArrayList<>(Sources.below(Path.of(folder, "src", "test", "java")));
        sources.addAll(Sources.below(Path.of(folder, "src", "testFixtures", "java")));
        return sources;
    }

    @Override
    public String toString() {
        return folder;
    }

    /** Reads the trees of sources. */
    static final class Sources {
        private Sources() {}

        /** Every Java file below a folder, in the order of their paths; none where the folder is absent. */
        static List<Path> below(Path folder) {
            if (!Files.isDirectory(folder)) {
                return List.of();
            }
            try (Stream<Path> all = Files.walk(folder)) {
                return all.filter(path -> path.toString().endsWith(".java"))
                        .sorted()
                        .collect(toList());
            } catch (IOException e) {
                throw new UncheckedIOException("cannot walk " + folder, e);
            }
        }
    }
}
