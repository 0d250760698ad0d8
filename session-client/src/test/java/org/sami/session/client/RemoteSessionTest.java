package org.sami.session.client;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalTime;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.security.Identity;
import org.sami.crw.operator.OperatorLogEntry;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.session.Session;
import org.sami.session.api.FrontSession;
import org.sami.session.client.testing.FrontNotices;
import org.sami.session.person.PeopleFile;
import org.sami.session.person.PersonRole;
import org.sami.session.server.ServerAddress;
import org.sami.session.server.SessionServer;
import org.sami.session.server.testing.ServedSession;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** Fronts in another process than their session's: real servers on loopback, real keys, sockets that are cut. */
class RemoteSessionTest {
    private static final String PLAN = "station-keep";

    @TempDir
    private Path folder;

    private final ExecutorService front = Executors.newSingleThreadExecutor();
    private final List<RemoteSession> opened = new ArrayList<>();
    private ServedSession served;
    private Session session;
    private PeopleFile people;
    private SessionServer server;

    @BeforeEach
    void serve() throws Exception {
        served = ServedSession.ofPlan(PLAN, folder)
                .with("anna", PersonRole.OPERATOR)
                .with("ben", PersonRole.OPERATOR)
                .with("otto", PersonRole.OBSERVER);
        session = served.session();
        people = served.people();
        server = served.serve();
        served.begin();
    }

    @AfterEach
    void end() throws Exception {
        opened.forEach(RemoteSession::close);
        served.close();
        front.shutdown();
    }

    private RemoteSession open(int port, String name, String key, RemoteListener listener) throws Exception {
        return open(SessionAddress.parse("ws://127.0.0.1:" + port), name, key, listener, print -> false);
    }

    private RemoteSession open(
            SessionAddress address, String name, String key, RemoteListener listener, Predicate<String> compared)
            throws Exception {
        ServerTrust trust = new ServerTrust(
                new KnownServers(folder.resolve("servers")), (authority, print) -> compared.test(print));
        RemoteSession one = RemoteSession.open(
                List.of(address), new Login(name, key), trust, front, listener, () -> LocalTime.of(14, 2, 31));
        opened.add(one);
        return one;
    }

    private RemoteSession open(String name) throws Exception {
        return open(server.listensAt().getPort(), name, "key of " + name, new FrontNotices());
    }

    private static <T> T get(CompletionStage<T> stage) throws Exception {
        return stage.toCompletableFuture().get();
    }

    private static String refusal(CompletionStage<?> stage) throws InterruptedException {
        try {
            stage.toCompletableFuture().get();
            return "";
        } catch (ExecutionException refused) {
            return String.valueOf(refused.getCause().getMessage());
        }
    }

    private static PendingDecision asked(RemoteSession of) throws Exception {
        get(of.caughtUp());
        return of.models().decisions().pending().get(0);
    }

    private static Answer answer(PendingDecision asked) {
        Map<String, Value> values = new LinkedHashMap<>();
        for (Question.Item item : ((Question.FillIn) asked.presentation().question()).items()) {
            Value other = item.type() == ValueType.Simple.POINT ? GeoPoint.of(45.7, 10.72) : new RealValue(1);
            values.put(item.key(), item.defaultValue().orElse(other));
        }
        return new Answer.Fields(values);
    }

    @Test
    void seesTheQuestionOfAMissionThatItStartsAndAnswersIt() throws Exception {
        RemoteSession anna = open("anna");

        long mission = get(anna.start(PLAN, "Keep here", Map.of()));
        PendingDecision asked = asked(anna);
        get(anna.answerJudged(asked.decision(), answer(asked), "console"));
        get(anna.caughtUp());

        assertThat(anna.models().missions().snapshot().mission(mission).map(MissionSnapshot::words))
                .contains("Keep here");
        assertThat(anna.models().decisions().pending())
                .extracting(one -> one.decision().id())
                .doesNotContain(asked.decision().id());
        assertThat(marking(anna, mission)).isEqualTo(marking(session, mission));
        assertThat(anna.models().log().snapshot())
                .extracting(OperatorLogEntry::text)
                .anyMatch(text ->
                        text.startsWith("anna answered [" + asked.decision().id() + "]"));
    }

    private static Map<String, List<Token>> marking(FrontSession of, long mission) throws Exception {
        return get(of.ask(view -> view.mission(mission).orElseThrow().marking()));
    }

    @Test
    void showsWhatWasBeforeItCame() throws Exception {
        long mission = get(session.start(PLAN, PLAN, Map.of()));
        RemoteSession anna = open("anna");

        PendingDecision asked = asked(anna);

        assertThat(asked.decision().mission()).isEqualTo(mission);
        assertThat(asked.presentation())
                .isEqualTo(session.models()
                        .decisions()
                        .find(asked.decision().id())
                        .orElseThrow()
                        .presentation());
    }

    @Test
    void whoAnswersSecondIsToldWhoAnsweredWhat() throws Exception {
        FrontNotices notices = new FrontNotices();
        RemoteSession anna = open("anna");
        RemoteSession ben = open(server.listensAt().getPort(), "ben", "key of ben", notices);
        get(anna.start(PLAN, PLAN, Map.of()));
        PendingDecision asked = asked(ben);

        get(anna.answerJudged(asked(anna).decision(), answer(asked), "console"));
        String second = refusal(ben.answerJudged(asked.decision(), answer(asked), "console"));

        assertThat(second)
                .startsWith("anna has answered decision " + asked.decision().id() + " already: ");
        assertThat(notices.next()).isEqualTo("anna started " + PLAN + " as mission 1");
        assertThat(notices.next())
                .startsWith("anna answered [" + asked.decision().id() + "]");
    }

    @Test
    void goesOnAfterItsConnectionWasCut() throws Exception {
        FrontNotices notices = new FrontNotices();
        try (CuttableRelay relay = new CuttableRelay(new InetSocketAddress(
                InetAddress.getLoopbackAddress(), server.listensAt().getPort()))) {
            RemoteSession anna = open(relay.port(), "anna", "key of anna", notices);
            get(anna.start(PLAN, PLAN, Map.of()));
            PendingDecision first = asked(anna);
            DecisionChanges changes = new DecisionChanges();
            anna.models().decisions().addListener(changes);

            relay.cut();
            String lost = notices.next();
            get(session.start(PLAN, "meanwhile", Map.of()));
            String back = notices.next();
            get(anna.caughtUp());

            assertThat(lost).startsWith("connection lost (").endsWith(", last seen 14:02:31; it is tried again");
            assertThat(back).isEqualTo("back at " + anna.address());
            assertThat(anna.models().missions().snapshot().missions())
                    .extracting(MissionSnapshot::name)
                    .contains("meanwhile");
            assertThat(anna.models().decisions().find(first.decision().id())).isPresent();
            assertThat(changes.lines()).hasSize(1).first().asString().startsWith("opened ");
            get(anna.answerJudged(first.decision(), answer(first), "console"));
        }
    }

    @Test
    void goesOnOpeningWhenTheServerIsLostWhileItOpens() throws Exception {
        FrontNotices notices = new FrontNotices();
        try (CuttableRelay relay = new CuttableRelay(new InetSocketAddress(
                InetAddress.getLoopbackAddress(), server.listensAt().getPort()))) {
            relay.cutAfter("\"welcome\"");

            RemoteSession anna = open(relay.port(), "anna", "key of anna", notices);

            assertThat(notices.next("connection lost (")).contains("last seen");
            assertThat(anna.rights().role()).isEqualTo("operator");
            get(anna.start(PLAN, PLAN, Map.of()));
        }
    }

    @Test
    void observerIsRefusedInWordsAndMayStopTheFleet() throws Exception {
        RemoteSession otto = open("otto");

        assertThat(refusal(otto.start(PLAN, PLAN, Map.of())))
                .isEqualTo("The role observer of otto does not have the right 'start'");
        get(otto.fleet().stopAll());
        get(otto.caughtUp());

        assertThat(session.models().fleetStop().snapshot().everyBoat()).isTrue();
    }

    @Test
    void whatIsWishedOfBoatsWithoutALinkIsKnownHereAndChangedFromHere() throws Exception {
        session.fleet().wish(Optional.of(LostLinkAction.HOLD));
        RemoteSession anna = open("anna");
        RemoteSession ben = open("ben");
        assertThat(anna.fleet().lostLinkWish()).contains(LostLinkAction.HOLD);

        get(anna.fleet().wishLostLink(Optional.of(LostLinkAction.RETURN)));

        assertThat(anna.fleet().lostLinkWish()).contains(LostLinkAction.RETURN);
        assertThat(session.fleet().lostLinkWish()).contains(LostLinkAction.RETURN);
        get(ben.caughtUp());
        assertThat(ben.fleet().lostLinkWish()).contains(LostLinkAction.RETURN);

        get(ben.fleet().wishLostLink(Optional.empty()));
        get(anna.caughtUp());

        assertThat(anna.fleet().lostLinkWish()).isEmpty();
        assertThat(open("otto").fleet().lostLinkWish()).isEmpty();
    }

    @Test
    void observerKnowsWhatIsWishedAndDoesNotChangeIt() throws Exception {
        RemoteSession otto = open("otto");

        assertThat(refusal(otto.fleet().wishLostLink(Optional.of(LostLinkAction.DRIFT))))
                .isEqualTo("The role observer of otto does not have the right 'setup'");

        assertThat(session.fleet().lostLinkWish()).isEmpty();
        get(session.fleet().wishLostLink(Optional.of(LostLinkAction.RETURN)));
        get(otto.caughtUp());
        assertThat(otto.fleet().lostLinkWish()).contains(LostLinkAction.RETURN);
    }

    @Test
    void boatIsDrivenByOneHandAtATime() throws Exception {
        RemoteSession anna = open("anna");

        assertThat(refusal(anna.fleet().teleoperate("nobody", 0.1, 0))).isEqualTo("there is no boat 'nobody'");
        assertThat(refusal(anna.fleet().handBack("nobody"))).isEqualTo("there is no boat 'nobody'");
    }

    @Test
    void wrongKeyIsRefusedInWords() {
        assertThatThrownBy(() -> open(server.listensAt().getPort(), "anna", "guessed", new FrontNotices()))
                .isInstanceOf(IOException.class)
                .hasMessage("no such name and key");
    }

    @Test
    void nobodyAtTheAddressIsSaidInWords() {
        assertThatThrownBy(() -> open(1, "anna", "key of anna", new FrontNotices()))
                .isInstanceOf(IOException.class)
                .hasMessage("no server answers at ws://127.0.0.1:1");
    }

    @Test
    void whoIsRemovedIsOutAndTriesNoLonger() throws Exception {
        FrontNotices notices = new FrontNotices();
        open(server.listensAt().getPort(), "anna", "key of anna", notices);

        people.remove("anna");

        assertThat(notices.next()).isEqualTo("ended: anna was removed from this session");
    }

    @Test
    void rightsAreThoseOfTheRoleThatIsListedNow() throws Exception {
        FrontNotices notices = new FrontNotices();
        RemoteSession anna = open(server.listensAt().getPort(), "anna", "key of anna", notices);
        assertThat(anna.rights().has("start")).isTrue();

        Path file = people.file();
        Files.writeString(file, Files.readString(file).replaceFirst("\"operator\"", "\"pilot\"")); // anna's is first

        assertThat(notices.next()).isEqualTo("role: pilot");
        assertThat(anna.rights().rights()).containsExactlyInAnyOrder("stop", "answer", "press", "drive");
    }

    @Test
    void serverIsTrustedByTheCertificateThatWasCompared() throws Exception {
        ServerAddress secured =
                new ServerAddress(InetAddress.getLoopbackAddress(), 0, Optional.of(Identity.generate()));
        try (SessionServer first = SessionServer.start(session, people, secured)) {
            int port = first.listensAt().getPort();
            SessionAddress address = SessionAddress.parse("wss://127.0.0.1:" + port);
            assertThatThrownBy(() -> open(address, "anna", "key of anna", new FrontNotices(), print -> false))
                    .hasMessageStartingWith("nobody has compared the certificate of 127.0.0.1:" + port);
            String print = first.certificate().orElseThrow();
            get(open(address, "anna", "key of anna", new FrontNotices(), print::equals)
                    .caughtUp());
            get(open(address, "anna", "key of anna", new FrontNotices(), unasked -> false)
                    .caughtUp());

            new KnownServers(folder.resolve("servers")).add("127.0.0.1:" + port, "AB:CD");
            assertThatThrownBy(() -> open(address, "anna", "key of anna", new FrontNotices(), unasked -> true))
                    .hasMessageStartingWith("another server is at 127.0.0.1:" + port);
        }
    }

    @Test
    void addressesWithKeysOrInPlainTextToElsewhereAreRefused() {
        assertThatThrownBy(() -> SessionAddress.parse("wss://anna:key@10.0.0.5:8443"))
                .hasMessageContaining("without a name or key");
        assertThatThrownBy(() -> SessionAddress.parse("wss://10.0.0.5:8443?key=x"))
                .hasMessageContaining("without a name or key");
        assertThatThrownBy(() -> SessionAddress.parse("ws://10.0.0.5:8080"))
                .hasMessage("keys are sent by TLS only: wss://10.0.0.5:8080");
        assertThat(SessionAddress.parse("wss://10.0.0.5:8443/")).hasToString("wss://10.0.0.5:8443");
        assertThat(new Login("anna", "secret")).hasToString("anna");
    }
}
