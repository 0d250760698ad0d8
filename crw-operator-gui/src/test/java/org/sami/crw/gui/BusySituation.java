package org.sami.crw.gui;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.sami.boat.server.testing.Await;
import org.sami.crw.gui.mission.DividedTasks;
import org.sami.crw.gui.start.StartOptions;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.session.Session;
import org.sami.palette.Theme;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;

/**
 * The real window over a session in which much goes on: 20 simulated boats behind loopback sockets, missions that run and that have ended, 40 tasks, 14 decisions
 * that wait and 50 messages, all by the session's public operations. Nothing is answered any longer once it is open, so that what waits stays.
 */
public final class BusySituation implements AutoCloseable {
    public static final int BOATS = 20;
    public static final int DECISIONS = 14;
    public static final int MESSAGES = 50;

    private static final List<Priority> PRIORITIES = List.of(Priority.values());
    private static final GeoArea BAY = new GeoArea(
            List.of(
                    GeoPoint.of(25.3594, 51.5288),
                    GeoPoint.of(25.3594, 51.5318),
                    GeoPoint.of(25.3608, 51.5318),
                    GeoPoint.of(25.3608, 51.5288)),
            List.of());
    private static final int PASSES = 8; // boats of the team that explores
    private static final int IN_A_ROW = 8;
    private static final int WITHIN_S = 300;

    private OpenedWindow opened;
    private final LoopbackFleet fleet;
    private final OperatorWindow window;

    /**
     * Opens it, and waits until all of it is so.
     *
     * @param folder for the window's data and its project
     */
    public BusySituation(Path folder, Theme theme, int percent) throws Exception {
        fleet = new LoopbackFleet(boats());
        Path project = OpenedWindow.writeBeachWithLibrary(folder.resolve("busy.json"));
        StartOptions options = new StartOptions(
                fleet.addresses(), Optional.of(project), Optional.of(theme), Optional.of(percent), Optional.of(false));
        opened = OpenedWindow.open(options, folder.resolve("data"));
        window = opened.window();
        try {
            fill();
        } catch (Exception | Error fault) {
            close();
            throw fault;
        }
    }

    /** The names of the boats: boat1 to boat20. */
    public static List<String> boats() {
        return IntStream.rangeClosed(1, BOATS).mapToObj(i -> "boat" + i).toList();
    }

    public OperatorWindow window() {
        return window;
    }

    public Session session() {
        return window.session();
    }

    /** Starts the plan whose first question autonomy answers after 40 s; gives its mission. */
    public long bringHome() throws Exception {
        return start("bring-home", "Squall from the north");
    }

    /** Ends a boat: nothing comes from it any longer. */
    public void end(String boat) throws IOException {
        fleet.end(boat);
    }

    /** Brings five faults at once, and waits until the window's health has them. */
    public void bringFaults() throws Exception {
        FiveFaults.bring(session(), fleet);
    }

    private void fill() throws Exception {
        Await.until(
                "all boats have joined",
                () -> session()
                                .ask(view -> view.proxies().size())
                                .toCompletableFuture()
                                .join()
                        == BOATS);
        DividedTasks.of(session(), locations());
        long resent = start("resend-waypoints", "Resend to all");
        get(session().abort(resent));
        long connected = start("connect-boat", "Connect a spare boat");
        get(session().abort(connected));
        explore("Explore the bay", boats().subList(0, PASSES));
        press("battery swap", List.of("boat3"));
        press("battery swap", List.of("boat5"));
        start("connect-boat", "Connect amber");
        start("connect-boat", "Connect blue");
        start("connect-boat", "Connect coral");
        start("deploy-and-station-keep", "Station north");
        start("deploy-and-station-keep", "Station south");
        start("explore-team", "Explore the western shore");
        start("explore-team", "Explore the harbour's mouth");
        start("explore-area", "Look once more");
        start("resend-waypoints", "Resend after the gust");
        start("communications-monitoring", "Watch the links");
        start("clv", "Visit the buoys");
        start("station-keep", "Wait off the quay");
        for (int i = 0; i < MESSAGES; i++) {
            session().models().tell(message(i));
        }
        Await.until(
                "all of it waits",
                () -> session().models().decisions().snapshot().size() == DECISIONS
                        && session().models().messages().snapshot().size() >= MESSAGES);
    }

    /** Starts a mission, and waits until it asks something. */
    private long start(String plan, String name) throws Exception {
        long mission = get(session().start(plan, name, Map.of()));
        decision(mission);
        return mission;
    }

    private PendingDecision decision(long mission) {
        Await.until(
                "mission " + mission + " asks",
                () -> session().models().decisions().snapshot().stream()
                        .anyMatch(one -> one.decision().mission() == mission));
        return session().models().decisions().snapshot().stream()
                .filter(one -> one.decision().mission() == mission)
                .findFirst()
                .orElseThrow();
    }

    private void explore(String name, List<String> team) throws Exception {
        long mission = start("explore-team", name);
        PendingDecision area = decision(mission);
        get(session().answer(area.decision().id(), new Answer.Fields(Map.of("area", BAY)), "situation"));
        Await.until(
                "boats are asked for",
                () -> decision(mission).decision().id() != area.decision().id());
        get(session().answer(decision(mission).decision().id(), new Answer.Proxies(team), "situation"));
        Await.until(
                name + " offers its interrupts",
                () -> session().models().interrupts().snapshot().stream()
                        .anyMatch(choice -> choice.mission() == mission && choice.isEnabled()));
    }

    private void press(String interrupt, List<String> boats) throws Exception {
        int waiting = session().models().decisions().snapshot().size();
        long mission = session().models().interrupts().snapshot().stream()
                .filter(choice -> choice.name().equals(interrupt))
                .findFirst()
                .orElseThrow()
                .mission();
        get(session().press(interrupt, mission, boats));
        Await.until(
                interrupt + " asks",
                () -> session().models().decisions().snapshot().size() > waiting);
    }

    private static ListValue locations() {
        return new ListValue(IntStream.range(0, 2 * BOATS)
                .<Value>mapToObj(BusySituation::location)
                .toList());
    }

    private static GeoPoint location(int number) {
        int row = number / IN_A_ROW;
        return GeoPoint.of(25.3590 - row * 0.0002, 51.5290 + number % IN_A_ROW * 0.0004);
    }

    private static OperatorMessage message(int number) {
        String boat = "boat" + (number % BOATS + 1);
        return new OperatorMessage(
                0,
                number * 1000L,
                OperatorMessage.Source.PLAN,
                PRIORITIES.get(number % PRIORITIES.size()),
                boat + " has measured " + (number + 12) + " °C at its location",
                List.of(boat),
                "");
    }

    private static <T> T get(CompletionStage<T> stage) throws Exception {
        return stage.toCompletableFuture().get(WITHIN_S, TimeUnit.SECONDS);
    }

    @Override
    public void close() throws Exception {
        opened.end();
        fleet.close();
    }
}
