package org.sami.crw.sim.session;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Predicate;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionRuntime;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.crw.session.fault.FaultPolicy;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Flow;
import org.sami.crw.sim.hull.SensorSetting;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.host.InputJournal;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Decision;
import org.sami.spn.value.GeoPoint;

/** Sessions over real sockets on the loopback address, and boats for them; all closed together. */
final class TestSession implements AutoCloseable {
    static final GeoPoint PIER = GeoPoint.of(45.4, 10.9);

    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private final Path folder;
    private final List<AutoCloseable> opened = new ArrayList<>();

    TestSession(Path folder) {
        this.folder = folder;
    }

    /** A project of the library. */
    static Project library(String plan) {
        return LIBRARY.projectOf(plan).orElseThrow();
    }

    /** A project of its text. */
    static Project project(String text) {
        return new ProjectReader(LIBRARY.vocabulary()).read(text).orThrow();
    }

    /** A session of a project that has not begun, without a journal. */
    Session opened(Project project) throws IOException {
        return keep(Session.open(setup(project)));
    }

    /** A session that has not begun, with inputs that somebody else keeps, and with what is to happen when that fails. */
    Session opened(Project project, InputJournal inputs, FaultPolicy onFault) throws IOException {
        return keep(
                Session.open(setup(project).with(SessionJournal.over(inputs)).with(onFault)));
    }

    /** A session with a journal that has not begun. */
    Session opened(Project project, Path journal) throws IOException {
        JournalHeader header = JournalHeader.of(
                new ProjectWriter(LIBRARY.vocabulary()).text(project),
                LIBRARY.files().texts(),
                Map.of());
        return keep(Session.open(setup(project).with(SessionJournal.create(journal, header))));
    }

    /** A session that goes on with a journal and has not begun. */
    Session resumed(Path journal) throws IOException {
        return keep(
                Session.open(SessionSetup.resumed(SessionJournal.open(journal)).with(runtime())));
    }

    /** A plan that connects to a boat's server, then asks whether all is well. */
    static String connecting(BoatAddress address) {
        return """
                {"formatVersion": 1, "id": "p", "name": "boats", "domain": "crw",
                 "globals": [{"name": "@meeting", "type": "point", "initial": {"lat": 45.7, "lon": 10.72}}],
                 "plans": [{"id": "p", "name": "boats",
                 "places": [
                  {"id": "a", "start": true, "outputs": [{"id": "o", "type": "ConnectExistingProxy",
                   "fields": {"name": {"value": "RED SQ"}, "server": {"value": "%s"}}}]},
                  {"id": "b", "outputs": [{"id": "q", "type": "OperatorApprove",
                   "fields": {"question": {"value": "Is all well?"}}}]},
                  {"id": "c", "end": true}],
                 "transitions": [{"id": "t", "inputs": [{"id": "i", "type": "ProxyCreated"}]},
                  {"id": "u", "inputs": [{"id": "y", "type": "YesOption"}]}],
                 "inEdges": [{"id": "e1", "place": "a", "transition": "t",
                   "requirements": [{"kind": "generic", "match": "at-least", "n": 1}]},
                  {"id": "e3", "place": "b", "transition": "u",
                   "requirements": [{"kind": "generic", "match": "at-least", "n": 1}]}],
                 "outEdges": [{"id": "e2", "transition": "t", "place": "b",
                   "requirements": [{"kind": "generic", "action": "take", "n": "all"},
                    {"kind": "relevant", "action": "add", "n": "all"}]},
                  {"id": "e4", "transition": "u", "place": "c",
                   "requirements": [{"kind": "generic", "action": "take", "n": "all"}]}]}]}
                """.formatted(address);
    }

    private static SessionSetup setup(Project project) {
        return SessionSetup.of(LIBRARY.vocabulary(), project).with(runtime());
    }

    private static SessionRuntime runtime() {
        return SessionRuntime.RealTime.named(SessionRuntime.RealTime.newClientId(), clock())
                .withSimulatedBoats(new SimulatedBoatsOnTcp(1));
    }

    private static SteadyClock clock() {
        return new SteadyClock(ProcessClock::ms);
    }

    /** A boat that logs into the folder. */
    BoatOnTcp boat(String name, SensorSetting... sensors) throws IOException {
        InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        Conditions water = new Conditions(0, 0, Flow.NONE, Flow.NONE, List.of(sensors));
        BoatSettings settings =
                BoatSettings.of(name, anyPort, PIER, 1).on(water).loggingTo(folder);
        return keep(new BoatOnTcp(settings, clock(), TcpServerListener.NONE));
    }

    static BoatAddress address(BoatOnTcp boat) {
        return new BoatAddress("127.0.0.1", boat.address().getPort());
    }

    private <T extends AutoCloseable> T keep(T one) {
        opened.add(one);
        return one;
    }

    /** The ids of a session's running missions, the oldest first. */
    static List<Long> missions(Session session) {
        return get(session.ask(
                view -> view.missions().stream().map(MissionView::id).toList()));
    }

    /** What a stage gives, soon. */
    static <T> T get(CompletionStage<T> stage) {
        try {
            return stage.toCompletableFuture().get((long) Await.AT_MOST_S, TimeUnit.SECONDS);
        } catch (ExecutionException failed) {
            throw new CompletionException(failed.getCause());
        } catch (InterruptedException | TimeoutException late) {
            throw new AssertionError(late);
        }
    }

    /** Waits until the engine's state is so. */
    static void until(String what, Session session, Predicate<EngineView> state) {
        Await.until(what, () -> session.host().ask(state::test));
    }

    /** The decision of that type, when it is asked. */
    static Decision decision(Session session, String type) {
        until(
                type + " is asked",
                session,
                view -> view.decisions().stream()
                        .anyMatch(decision -> decision.type().equals(type)));
        return session.host()
                .ask(view -> view.decisions().stream()
                        .filter(decision -> decision.type().equals(type))
                        .findFirst())
                .orElseThrow();
    }

    @Override
    public void close() throws Exception {
        for (int i = opened.size() - 1; i >= 0; i--) {
            opened.get(i).close();
        }
    }
}
