package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.ConnectException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.command.VehicleCommand;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.testing.SimulatorTruth;
import org.sami.mavlink.testing.UdpFaultProxy;
import org.sami.mavlink.testing.WireMoments;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.spn.value.GeoPoint;

/**
 * One boat with ArduPilot's real firmware in its simulator whose link, process and power fail. Phases are reached by what passes between it and the base; where it
 * was is what its simulator says, over its restarts too. For one thread.
 */
final class RealFaultyBoat implements FaultyVehicle, AutoCloseable {
    private static final GeoPoint HOME = GeoPoint.of(45.7, 10.72);
    private static final double DEGREE_M = 111_319;
    private static final double NORTH_M = 33;
    private static final double EAST_M = 31;
    private static final double NEAR_M = 3;
    private static final double LEFT_M = 6; // from a place: it is passed again if it comes near once more
    private static final double STILL_MPS = 0.2; // with motors off it comes to rest by the water alone, in minutes
    private static final double MORE_MPS = 0.05; // than before: its motors have turned
    private static final int SECOND = 10; // reports
    private static final int HALF = 3; // of the six items of its mission

    private final int number;
    private final int speed;
    private final Path work;
    private final UdpFaultProxy link = new UdpFaultProxy(1);
    private final List<SimulatorTruth> lives = new ArrayList<>(); // one for each start of it
    private ArduPilotBoats process;
    private final AtomicInteger taken = new AtomicInteger(); // missions
    private List<GeoPoint> path = List.of();
    private int armedBefore; // this case
    private int uploadedBefore;
    private Place begin = new Place(0, 0); // of this case
    private Place mark = new Place(0, 0);
    private double markMps; // over the second before

    /** A report of its simulator: in which of its lives, and the number there. */
    private record Place(int life, int report) {}

    /**
     * Starts one.
     *
     * @param number gives its system id, which is one more, and its ports
     * @param speed factor of simulated to real time
     * @param work a folder for its memory and logs
     */
    RealFaultyBoat(int number, int speed, Path work) throws IOException {
        this.number = number;
        this.speed = speed;
        this.work = work;
        Predicate<Object> isTaken = WireMoments.missionIsTaken(number + 1);
        link.watch(message -> taken.addAndGet(isTaken.test(message) ? 1 : 0));
        start(HOME, 0);
    }

    private void start(GeoPoint at, double headingDeg) throws IOException {
        process = ArduPilotBoats.sending(link.vehiclePort(), at.latDeg(), at.lonDeg(), headingDeg, number, speed, work);
        Await.until("its simulator says where it is", this::isSeen);
        Await.until("its simulator says where it is", () -> truth().samples() > 0);
    }

    private boolean isSeen() {
        try {
            lives.add(new SimulatorTruth(ArduPilotBoats.secondPort(number), number + 1));
        } catch (ConnectException e) {
            return false;
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
        return true;
    }

    private SimulatorTruth truth() {
        return lives.get(lives.size() - 1);
    }

    private Place now() {
        return new Place(lives.size() - 1, truth().samples() - 1);
    }

    /** Where it was, from a report on. */
    private List<GeoPoint> track(Place from) {
        return track(from, lives.size() - 1);
    }

    private List<GeoPoint> track(Place from, int toLife) {
        List<GeoPoint> track = new ArrayList<>();
        for (int life = from.life; life <= toLife; life++) {
            lives.get(life).placesFrom(life == from.life ? from.report : 0).stream()
                    .map(at -> GeoPoint.of(at[0], at[1]))
                    .forEach(track::add);
        }
        return track;
    }

    /** Begins the next case: it lies still and disarmed where it is, without a mission, as another ground station has ordered. */
    void reset() throws Exception {
        link.letOn();
        link.cut(false);
        frozen(false);
        VehicleId id = new VehicleId(number + 1, 1);
        try (MavlinkBase other = new MavlinkBase(
                List.of(AddressText.parse("mavlink:tcp:127.0.0.1:" + ArduPilotBoats.thirdPort(number))),
                ProcessClock::ms)) {
            Await.until("it is heard", () -> !other.vehicles().join().isEmpty());
            other.command(id, VehicleCommand.disarmAtOnce()).join();
            other.setMode(id, "HOLD").join();
            other.replace(id, HeldKind.MISSION, List.of()).join();
        }
        Await.until("it is disarmed", () -> !isArmed());
        markPlace();
        begin = mark;
        armedBefore = said("Throttle armed");
        uploadedBefore = taken.get();
        GeoPoint at = track(begin).get(0);
        double eastDeg = EAST_M / (DEGREE_M * Math.cos(Math.toRadians(at.latDeg())));
        double northDeg = NORTH_M / DEGREE_M;
        path = List.of(
                GeoPoint.of(at.latDeg() + northDeg, at.lonDeg()),
                GeoPoint.of(at.latDeg() + northDeg, at.lonDeg() + eastDeg),
                GeoPoint.of(at.latDeg(), at.lonDeg() + eastDeg));
    }

    private int said(String words) {
        return lives.stream().mapToInt(life -> life.said(words)).sum();
    }

    @Override
    public String name() {
        return "mav" + (number + 1);
    }

    @Override
    public String address() {
        return "mavlink:udpout:127.0.0.1:" + link.basePort() + "/" + (number + 1);
    }

    @Override
    public List<GeoPoint> path() {
        return path;
    }

    @Override
    public void holdAt(FaultCase.Phase phase) {
        switch (phase) {
            case CONNECTING -> link.holdAt(WireMoments::isCommand);
            case UPLOAD_BEGUN -> link.holdAt(WireMoments.asksForItem(number + 1));
            case UPLOAD_HALF -> link.holdAt(WireMoments.itemIsSent(number + 1, HALF));
            case UPLOADED -> link.holdAt(WireMoments.missionIsTaken(number + 1));
            case STARTING -> link.holdAt(WireMoments::isArming);
            default -> {
                // it is reached without that
            }
        }
    }

    @Override
    public boolean isHeld() {
        return link.isHeld();
    }

    /** It is let on as soon as the fault has begun. */
    @Override
    public void letOn() {
        link.letOn();
    }

    @Override
    public void begin(FaultCase.Fault fault) throws Exception {
        switch (fault) {
            case LINK_CUT -> link.cut(true);
            case VEHICLE_STANDS_STILL -> frozen(true);
            case REBOOT -> restart();
            case BASE_KILLED -> throw new IllegalArgumentException("that is no fault of the vehicle");
        }
        link.letOn();
    }

    @Override
    public void end(FaultCase.Fault fault) throws Exception {
        link.cut(false);
        frozen(false);
    }

    @Override
    public void deaf(boolean now) {
        link.cut(now);
        link.letOn();
    }

    private void frozen(boolean now) throws IOException, InterruptedException {
        for (ProcessHandle firmware : process.firmware().toList()) {
            new ProcessBuilder("kill", now ? "-STOP" : "-CONT", Long.toString(firmware.pid()))
                    .start()
                    .waitFor();
        }
    }

    /** It loses its power, and starts again where it is: with what it keeps in its memory, and at rest. */
    private void restart() throws IOException, InterruptedException {
        process.firmware().forEach(ProcessHandle::destroyForcibly);
        process.awaitEnd();
        List<GeoPoint> last = track(now());
        double headingDeg = truth().headingDeg();
        truth().close();
        start(last.get(last.size() - 1), headingDeg);
    }

    @Override
    public boolean isArmed() {
        return truth().isArmed();
    }

    @Override
    public boolean isReady() {
        return truth().isReady();
    }

    @Override
    public int armings() {
        return said("Throttle armed") - armedBefore;
    }

    @Override
    public int uploads() {
        return taken.get() - uploadedBefore;
    }

    @Override
    public void markPlace() {
        Place first = now();
        Await.until("it lies still", () -> {
            List<Double> speeds = speedsMps(first, first.life);
            return !speeds.isEmpty() && speeds.get(speeds.size() - 1) < STILL_MPS;
        });
        mark = now();
        markMps =
                speedsMps(new Place(mark.life, mark.report - SECOND), mark.life).get(0);
    }

    /** How fast it was over each second of its own, one after each report. */
    private List<Double> speedsMps(Place from, int toLife) {
        List<GeoPoint> track = track(from, toLife);
        return IntStream.range(0, Math.max(0, track.size() - SECOND))
                .mapToObj(i -> metres(track.get(i), track.get(i + SECOND)))
                .toList();
    }

    @Override
    public void assertLiesStill() {
        for (int life = mark.life; life < lives.size(); life++) {
            List<Double> speeds = speedsMps(new Place(life, life == mark.life ? mark.report : 0), life);
            double firstMps = life == mark.life ? markMps : pushMps(speeds);
            assertThat(speeds).allMatch(mps -> mps < firstMps + MORE_MPS);
        }
    }

    /** How fast it is as it starts: its simulator gives it a push then, whatever the firmware does. */
    private static double pushMps(List<Double> speeds) {
        return speeds.stream().limit(SECOND).mapToDouble(mps -> mps).max().orElse(0);
    }

    private static double farthestM(List<GeoPoint> track) {
        return track.stream().mapToDouble(at -> metres(track.get(0), at)).max().orElse(0);
    }

    private static double metres(GeoPoint from, GeoPoint to) {
        double narrower = Math.cos(Math.toRadians(from.latDeg()));
        return Math.hypot(from.latDeg() - to.latDeg(), (from.lonDeg() - to.lonDeg()) * narrower) * DEGREE_M;
    }

    @Override
    public double movedM() {
        return farthestM(track(mark));
    }

    /** The places of its path that it has passed, in the order in which it did. */
    private List<Integer> passed() {
        List<Integer> passed = new ArrayList<>();
        boolean[] isNear = new boolean[path.size()];
        for (GeoPoint at : track(begin)) {
            for (int i = 0; i < path.size(); i++) {
                double metres = metres(path.get(i), at);
                if (!isNear[i] && metres < NEAR_M) {
                    passed.add(i);
                }
                isNear[i] = metres < (isNear[i] ? LEFT_M : NEAR_M);
            }
        }
        return passed;
    }

    @Override
    public int visits() {
        return passed().size();
    }

    @Override
    public void assertVisitedOnceInOrder() {
        assertThat(passed()).containsExactly(0, 1, 2);
        assertThat(lives).allSatisfy(life -> assertThat(life.longestStepM()).isLessThan(NEAR_M));
    }

    @Override
    public void close() throws IOException, InterruptedException {
        frozen(false);
        for (SimulatorTruth life : lives) {
            life.close();
        }
        process.close();
        link.close();
    }
}
