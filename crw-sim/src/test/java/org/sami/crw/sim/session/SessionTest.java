package org.sami.crw.sim.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.sami.boat.link.BoatMode;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.service.Geodesy;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionOperator;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.session.api.RefusedException;
import org.sami.spn.engine.EngineView;
import org.sami.spn.json.GlobalsFile;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.value.GeoPoint;

/** What a window, a console and a run do with a session, on boats that are reached over TCP. */
@Timeout(900)
@Execution(ExecutionMode.CONCURRENT)
class SessionTest {
    private static final String SELECT = "OperatorSelectBoatList";

    @TempDir
    private Path folder;

    private TestSession world;

    @BeforeEach
    void open() {
        world = new TestSession(folder);
    }

    @AfterEach
    void close() throws Exception {
        world.close();
    }

    private Session begun(String plan) throws Exception {
        Session session = world.opened(TestSession.library(plan));
        session.begin();
        return session;
    }

    private static void awaitMode(Session session, String boat, BoatMode mode) {
        Await.until(
                boat + " is in mode " + mode,
                () -> TestSession.get(session.fleet().boats()).stream()
                        .anyMatch(status ->
                                status.boatId().equals(boat) && status.mode().equals(Optional.of(mode))));
    }

    @Test
    void opensWithNoBoatAndRunsMissionsOnBoatsThatComeLater() throws Exception {
        Session session = begun("clv");
        BoatOnTcp anna = world.boat("anna");

        assertThat(TestSession.get(session.fleet().boats())).isEmpty();
        assertThat(TestSession.get(session.fleet().connect(TestSession.address(anna))))
                .isEqualTo("anna");
        TestSession.until("anna has joined", session, view -> view.proxies().contains("anna"));
        long first = TestSession.get(session.start("clv", "first", Map.of()));
        long second = TestSession.get(session.start("clv", "second", Map.of()));

        assertThat(TestSession.missions(session)).containsExactly(first, second);
        TestSession.get(session.abort(first));
        assertThat(TestSession.missions(session)).containsExactly(second);
    }

    @Test
    void refusalSaysWhyNot() throws Exception {
        Session session = begun("clv");

        assertThatThrownBy(() -> TestSession.get(session.start("clw", "first", Map.of())))
                .hasCauseInstanceOf(RefusedException.class)
                .hasMessageContaining("clw");
        assertThatThrownBy(() -> TestSession.get(session.abort(17))).hasMessageContaining("no running mission 17");
        assertThatThrownBy(() -> TestSession.get(session.answer(9, new Answer.YesNo(true), "window")))
                .hasMessageContaining("decision 9 is not open");
        assertThatThrownBy(() -> TestSession.get(session.press("alarm", Ids.NONE, List.of())))
                .hasMessageContaining("'alarm'");
        assertThatThrownBy(() -> TestSession.get(session.fleet().teleoperate("anna", 0.5, 0)))
                .hasMessageContaining("there is no boat 'anna'; there is none");
        assertThatThrownBy(() -> TestSession.get(session.fleet().teleoperate("anna", 2, 0)))
                .hasMessageContaining("-1 to 1, not 2.0");
    }

    @Test
    void resultsThatAreOpenFailWhenTheSessionCloses() throws Exception {
        Session session = begun("clv");
        CompletionStage<String> never = session.fleet().connect(BoatAddress.parse("127.0.0.1:1"));

        session.close();

        assertThatThrownBy(() -> TestSession.get(never)).hasMessageContaining("the session is closed");
        assertThatThrownBy(() -> TestSession.get(session.start("clv", "late", Map.of())))
                .hasMessageContaining("closed");
    }

    /** An operator who writes down what it hears. */
    private static final class Listening implements SessionOperator {
        private final String name;
        private final List<String> heard = new CopyOnWriteArrayList<>();

        Listening(String name) {
            this.name = name;
        }

        @Override
        public String name() {
            return name;
        }

        @Override
        public void asked(Asked asked) {
            heard.add("asked in " + asked.plan() + ": " + asked.decision().type());
        }

        @Override
        public void settled(long decision, Optional<Answer> answer, String by) {
            heard.add("answered by " + by);
        }
    }

    @Test
    void firstAnswerOfSeveralOperatorsCountsAndAllAreTold() throws Exception {
        Session session = world.opened(TestSession.library("clv"));
        Listening window = new Listening("window");
        Listening file = new Listening("answers file");
        session.addOperator(window);
        session.addOperator(file);
        session.begin();
        TestSession.get(session.fleet().connect(TestSession.address(world.boat("anna"))));
        TestSession.until("anna has joined", session, view -> view.proxies().contains("anna"));
        TestSession.get(session.start("clv", "first", Map.of()));
        Decision select = TestSession.decision(session, SELECT);

        TestSession.get(session.answer(select.id(), new Answer.Proxies(List.of("anna")), window.name()));
        assertThatThrownBy(() ->
                        TestSession.get(session.answer(select.id(), new Answer.Proxies(List.of("anna")), file.name())))
                .hasMessageContaining("is not open");

        assertThat(file.heard).startsWith("asked in clv: " + SELECT, "answered by window");
        Await.until("all are told the same", () -> List.copyOf(window.heard).equals(List.copyOf(file.heard)));
    }

    @Test
    void boatThatWasDroppedJoinsAgainWhenItIsConnected() throws Exception {
        Session session = begun("clv");
        BoatOnTcp anna = world.boat("anna");
        TestSession.get(session.fleet().connect(TestSession.address(anna)));
        TestSession.until("anna has joined", session, view -> view.proxies().contains("anna"));

        TestSession.get(session.drop("anna"));

        List<String> left = session.host().ask(EngineView::proxies);
        assertThat(left).isEmpty();
        assertThat(TestSession.get(session.fleet().boats())).isEmpty();
        TestSession.get(session.fleet().connect(TestSession.address(anna)));
        TestSession.until(
                "anna has joined again", session, view -> view.proxies().contains("anna"));
    }

    @Test
    void fleetStopHoldsBoatsThatAreFoundLater() throws Exception {
        Session session = begun("clv");
        TestSession.get(session.fleet().connect(TestSession.address(world.boat("anna"))));
        awaitMode(session, "anna", BoatMode.STOPPED);

        assertThat(TestSession.get(session.fleet().stopAll())).containsExactly("anna");
        awaitMode(session, "anna", BoatMode.FLEET_STOP);
        TestSession.get(session.fleet().connect(TestSession.address(world.boat("bert"))));
        awaitMode(session, "bert", BoatMode.FLEET_STOP);

        assertThat(TestSession.get(session.fleet().why("bert")).text()).contains("it is stopped until it is released");
        assertThat(TestSession.get(session.fleet().releaseAll())).containsExactly("anna", "bert");
        awaitMode(session, "anna", BoatMode.STOPPED);
        awaitMode(session, "bert", BoatMode.STOPPED);
    }

    @Test
    void planConnectsToABoatWhileTheSessionRuns() throws Exception {
        BoatAddress anna = TestSession.address(world.boat("anna"));
        Session session = world.opened(TestSession.project(TestSession.connecting(anna)));
        session.begin();

        TestSession.get(session.start("p", "first", Map.of()));

        TestSession.decision(session, "OperatorApprove");
        List<String> joined = session.host().ask(EngineView::proxies);
        assertThat(joined).containsExactly("anna");
        TestSession.get(session.start("p", "second", Map.of())); // the boat is there already
        TestSession.until("both ask", session, view -> view.decisions().size() == 2);
    }

    @Test
    void simulatedBoatsAreReachedAsAnyOther() throws Exception {
        Session session = begun("clv");

        List<String> boats = TestSession.get(session.fleet().addSimulated("sim", TestSession.PIER, 2));

        assertThat(boats).containsExactly("sim1", "sim2");
        TestSession.until("both have joined", session, view -> view.proxies().containsAll(boats));
        assertThat(TestSession.get(session.fleet().boats()))
                .map(BoatStatus::boatId)
                .containsAll(new ArrayList<>(boats));
        TestSession.until(
                "both say where they are",
                session,
                view -> boats.stream()
                        .allMatch(boat -> session.fleet().history().boat(boat).isPresent()));
        assertThat(Geodesy.distanceM(position(session, "sim1"), position(session, "sim2")))
                .as("they do not lie on one spot")
                .isBetween(4.0, 6.0);
    }

    private static GeoPoint position(Session session, String boat) {
        return session.fleet().history().boat(boat).orElseThrow().report().position();
    }

    @Test
    void globalsAreSavedToTheProjectsFileAndLoadedFromIt() throws Exception {
        Path file = folder.resolve("project.json");
        Project project = TestSession.project(TestSession.connecting(TestSession.address(world.boat("anna"))));
        Session session = world.opened(project);
        session.begin();
        Files.writeString(file, new ProjectWriter(session.setup().vocabulary()).text(project));
        TestSession.get(session.setVariable(Ids.NONE, "@meeting", TestSession.PIER));

        assertThat(TestSession.get(session.project().saveGlobals(file)).changes())
                .extracting(GlobalsFile.Change::name)
                .containsExactly("@meeting");

        assertThat(Files.readString(file)).contains("45.4").doesNotContain("45.7");
        assertThat(TestSession.get(session.project().saveGlobals(file)).changes())
                .isEmpty();
        assertThat(TestSession.get(session.project().load(file))).isEqualTo(2);
        assertThatThrownBy(() -> TestSession.get(session.project().saveGlobals(folder.resolve("none.json"))))
                .hasRootCauseInstanceOf(RefusedException.class)
                .hasMessageContaining("nothing is saved");
        Files.writeString(file, "{");
        assertThatThrownBy(() -> TestSession.get(session.project().load(file)))
                .hasMessageContaining("the project is not loaded");
    }
}
