package org.sami.crw.cli.vehicle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.server.testing.Await;
import org.sami.crw.cli.CommandResult;
import org.sami.mavlink.testing.ArduPilotBoats;

/**
 * Plans of the library on boats with the real firmware, in a session with a no-go area between the locations. All but {@code clv} on three boats only with
 * {@code -PvehicleMissions}, on a machine that does nothing else: they take minutes.
 */
@Tag("long")
@Timeout(1200)
class ArduPilotMissionTest {
    private static final int FIRST = 80;
    private static final int SPEED = 5;
    private static final double RADIUS_M = 3;
    private static final double WAIT_S = 600;
    private static final double MARGIN_M = 12; // so far ways stay from no-go areas at most
    private static final double LANES_M = 10;
    private static final String ANSWERED = "wait decision within 120";

    @TempDir
    private Path work;

    private final long beganMs = System.currentTimeMillis();

    private TrueTeam team(int boats) throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        return new TrueTeam(FIRST, boats, SPEED, work);
    }

    private static void assumeAsked() {
        assumeTrue(Boolean.getBoolean("crw.vehicleMissions"), "minutes on real firmware: only with -PvehicleMissions");
    }

    /** Places in rows to the south and to the north of the no-go area. */
    private static List<double[]> rows(List<Integer> eastM, List<Integer> northM) {
        return northM.stream()
                .flatMap(north -> eastM.stream().map(east -> new double[] {east, north}))
                .toList();
    }

    private static final List<double[]> PLACES = rows(List.of(-48, -24, 0, 24, 48), List.of(12, 65));

    private void assertEndedOutsideNoGo(CommandResult led, String plan, int boats, TrueTeam team, double greatestM) {
        long[] reports = team.allAndInside();
        String row = String.format(
                Locale.ROOT,
                "%s, %d boats: at most %.2f m away, %d of %d reports in the no-go area, %.0f s%n",
                plan,
                boats,
                greatestM,
                reports[1],
                reports[0],
                (System.currentTimeMillis() - beganMs) / 1e3);
        System.out.print(row);
        assertThat(led.exitCode()).as(led.out() + led.err()).isZero();
        assertThat(led.out()).contains("mission 1 of " + plan + ": ended");
        assertThat(team.gaps())
                .as("where the boats were is known for all of the time")
                .isEmpty();
        assertThat(reports[1]).as(row + led.out()).isZero();
    }

    private static double greatestM(List<double[]> places, TrueTeam team) {
        return places.stream().mapToDouble(team::nearestM).max().orElseThrow();
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 5})
    void boatsOfClvVisitEachLocation(int boats) throws Exception {
        if (boats > 3) {
            assumeAsked();
        }
        try (TrueTeam team = team(boats)) {
            CommandResult led = team.lead(
                    "clv",
                    List.of(
                            "start clv",
                            ANSWERED,
                            "answer all",
                            ANSWERED,
                            "answer " + team.typed(PLACES),
                            ANSWERED,
                            "answer 1"));

            assertEndedOutsideNoGo(led, "clv", boats, team, greatestM(PLACES, team));
            assertThat(greatestM(PLACES, team)).isLessThan(RADIUS_M);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 5})
    void boatsOfMeasureStayAtEachLocation(int boats) throws Exception {
        assumeAsked();
        try (TrueTeam team = team(boats)) {
            CommandResult led = team.lead(
                    "measure",
                    List.of(
                            "start measure taskClass=Temperature measuring.duration=1s",
                            ANSWERED,
                            "answer " + team.typed(PLACES))); // autonomy chooses the allocation

            assertEndedOutsideNoGo(led, "measure", boats, team, greatestM(PLACES, team));
            assertThat(greatestM(PLACES, team)).isLessThan(RADIUS_M);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 5})
    void boatsOfStationKeepComeToTheirStationsAndStay(int boats) throws Exception {
        assumeAsked();
        try (TrueTeam team = team(boats)) {
            CommandResult led = team.lead(
                    "station-keep",
                    List.of(
                            "start station-keep location=" + team.typed(0, 90)
                                    + " spacing=20 watch-time.duration=60s wait.duration=4s ask-distance.distance=8",
                            ANSWERED,
                            "answer all",
                            "wait decision within 300",
                            "answer yes"));

            Map<String, double[]> stations = team.stations();
            double greatestM = 0;
            double strayedM = 0;
            for (int boat = 0; boat < boats; boat++) {
                double[] station = stations.get(team.name(boat));
                greatestM = Math.max(greatestM, team.nearestM(boat, station));
                strayedM = Math.max(strayedM, strayedM(team.track(boat, 0), station));
            }
            System.out.printf(Locale.ROOT, "strayed %.2f m%n", strayedM);
            assertEndedOutsideNoGo(led, "station-keep", boats, team, greatestM);
            assertThat(greatestM).isLessThan(RADIUS_M);
            assertThat(strayedM).isLessThan(8);
        }
    }

    /** How far it was from its station at most, once it was there. */
    private static double strayedM(List<double[]> track, double[] station) {
        return track.stream()
                .mapToDouble(at -> Math.hypot(at[0] - station[0], at[1] - station[1]))
                .dropWhile(metres -> metres > RADIUS_M)
                .max()
                .orElse(Double.MAX_VALUE);
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 5})
    void boatsOfExploreAreaComeNearEachOfItsPlaces(int boats) throws Exception {
        assumeAsked();
        try (TrueTeam team = team(boats)) {
            List<double[]> corners = List.of(
                    new double[] {-50, 12}, new double[] {50, 12}, new double[] {50, 72}, new double[] {-50, 72});
            CommandResult led = team.lead(
                    "explore-area",
                    List.of(
                            "start explore-area @spacing=" + (int) LANES_M,
                            ANSWERED,
                            "answer " + team.typed(corners),
                            ANSWERED,
                            "answer all"));

            List<double[]> open = IntStream.range(-24, 25)
                    .boxed()
                    .flatMap(east -> IntStream.range(7, 36).mapToObj(north -> new double[] {2 * east, 2 * north}))
                    .filter(at -> fromNoGoM(at) > MARGIN_M)
                    .toList();
            assertEndedOutsideNoGo(led, "explore-area", boats, team, greatestM(open, team));
            assertThat(greatestM(open, team)).isLessThan(LANES_M / 2 + RADIUS_M);
        }
    }

    private static double fromNoGoM(double[] at) {
        double eastM = Math.max(0, Math.max(TrueTeam.NO_GO.get(0) - at[0], at[0] - TrueTeam.NO_GO.get(2)));
        double northM = Math.max(0, Math.max(TrueTeam.NO_GO.get(1) - at[1], at[1] - TrueTeam.NO_GO.get(3)));
        return Math.hypot(eastM, northM);
    }

    /** The first boat's battery fails and it is recharged, the last one is taken out of the mission, and all others assemble in an alarm. */
    @ParameterizedTest
    @ValueSource(ints = {3, 5})
    void boatsOfClvInterruptsVisitEachLocationThatIsNotOfTheOneTakenOut(int boats) throws Exception {
        assumeAsked();
        try (TrueTeam team = team(boats)) {
            List<double[]> places = rows(List.of(-75, -50, -25, 0, 25, 50, 75), List.of(12, 65, 95, 125, 155));
            double[] station = {-70, -20};
            String recharged = team.name(0);
            String taken = team.name(boats - 1);
            CompletableFuture<CommandResult> session = CompletableFuture.supplyAsync(() -> lead(
                    team,
                    List.of(
                            "start clv-interrupts",
                            ANSWERED,
                            "answer all",
                            ANSWERED,
                            "answer " + team.typed(places),
                            ANSWERED,
                            "answer 1",
                            "wait alarm within 300",
                            "alarms",
                            "press recharge " + recharged,
                            ANSWERED,
                            "answer 4 " + team.typed(station[0], station[1]),
                            "drop " + taken + " 1",
                            ANSWERED,
                            "wait 3", // the battery is swapped
                            "answer 5",
                            "wait 1",
                            "press alarm",
                            ANSWERED,
                            "answer 6 " + team.typed(60, 100),
                            ANSWERED,
                            "answer 7 yes")));
            until(
                    session,
                    "it has visited a location",
                    () -> places.stream().anyMatch(place -> team.nearestM(0, place) < RADIUS_M));
            team.charge(0, 12); // critical, and enough for the way to the station
            until(session, "it is at the station", () -> team.nearestM(0, station) < RADIUS_M);
            team.charge(0, 100);
            CommandResult led = session.join();

            List<double[]> its = team.paths().get(taken);
            List<double[]> others = places.stream()
                    .filter(place -> its.stream().noneMatch(at -> Math.hypot(at[0] - place[0], at[1] - place[1]) < 0.5))
                    .toList();
            assertThat(led.out())
                    .contains("The battery of " + recharged + " is critical", "pressed recharge for " + recharged)
                    .contains("pressed alarm", taken + " is out of mission 1", "All boats have finished");
            assertEndedOutsideNoGo(led, "clv-interrupts", boats, team, greatestM(others, team));
            assertThat(others).hasSizeGreaterThan(places.size() / 2);
            assertThat(greatestM(others, team)).isLessThan(RADIUS_M);
        }
    }

    private static void until(CompletableFuture<CommandResult> session, String what, BooleanSupplier condition) {
        Await.until(what, WAIT_S, () -> session.isDone() || condition.getAsBoolean());
        if (session.isDone()) {
            throw new AssertionError("the session has ended before " + what + ": " + session.join());
        }
    }

    private static CommandResult lead(TrueTeam team, List<String> commands) {
        try {
            return team.lead("clv-interrupts", new ArrayList<>(commands));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
