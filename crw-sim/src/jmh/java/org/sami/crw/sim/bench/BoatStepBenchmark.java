package org.sami.crw.sim.bench;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.Frame;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Role;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.BoatServer;
import org.sami.boat.server.ServerConfig;
import org.sami.boat.server.ServerSession;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.crw.sim.hull.Instruments;
import org.sami.crw.sim.hull.SimulatedHull;
import org.sami.figures.Figure;

/**
 * A boat's server at ten steps a second for hours of simulated time: it follows lists, and sends its pose to a commander with each step, in bytes. What the
 * simulated hull needs is measured apart from the server.
 */
final class BoatStepBenchmark {
    private static final String NAME = "boat.step";
    private static final double LAT_DEG = 45.4;
    private static final double LON_DEG = 10.9;
    private static final int HZ = 10;
    private static final int STEP_MS = 1000 / HZ;
    private static final int STEPS_AN_HOUR = 3600 * HZ;
    private static final int POINTS = 100;

    private final int hours;
    private final SimulatedHull hull;
    private final Instruments instruments;
    private final BoatServer boat;
    private final ServerSession session;
    private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private final long thread = Thread.currentThread().getId();
    private String term = "";
    private long sequence;
    private long acknowledged;
    private long sentBytes;

    /** What one hour took. */
    private record Hour(double serverBytes, double serverMicros, double hullBytes, double heapMiB) {}

    BoatStepBenchmark(int hours) {
        this.hours = hours;
        hull = new SimulatedHull(HullConfig.DEFAULT, Conditions.CALM, new LocalFrame(LAT_DEG, LON_DEG), 0, 0, 1);
        instruments = new Instruments(hull, Conditions.CALM, 2, 3);
        boat = new BoatServer(ServerConfig.of("boat1", "boot1").build(), instruments);
        session = boat.connect(this::take);
    }

    /** The base's side reads only what it needs to command the boat. */
    private void take(byte[] frame) {
        sentBytes += frame.length;
        if (term.isEmpty() || acknowledged == 0) {
            read(frame);
        }
    }

    private void read(byte[] frame) {
        try {
            LinkMessage message = LinkCodec.STANDARD.decode(frame).message();
            if (message instanceof Welcome welcome) {
                term = welcome.term();
            } else if (message instanceof Ack) {
                acknowledged++;
            }
        } catch (LinkException e) {
            throw new IllegalStateException(e);
        }
    }

    private void say(LinkMessage message, long nowMs) {
        session.receive(LinkCodec.STANDARD.encode(new Frame(sequence++, term, message)), nowMs);
    }

    private void command(CommandMessage command, long nowMs) {
        acknowledged = 0;
        say(command, nowMs);
        if (acknowledged == 0) {
            throw new IllegalStateException(command.commandId() + " was not acknowledged");
        }
    }

    private static List<Waypoint> round() {
        List<Waypoint> points = new ArrayList<>();
        for (int i = 1; i <= POINTS; i++) {
            double turn = 2 * Math.PI * i / POINTS;
            points.add(new Waypoint(LAT_DEG + 1e-3 * Math.sin(turn), LON_DEG + 1e-3 * Math.cos(turn), 1.5));
        }
        return points;
    }

    /** Bytes allocated and processor time of a step, and how the live heap grows. */
    List<Figure> run() {
        say(new Hello("boat1", "base", Role.COMMANDER, HZ, "", "base.0", 1), 0);
        command(new UploadWaypoints("u", "round", round()), 0);
        command(new StartWaypoints("s0", "round", 0), 0);
        System.out.printf(
                Locale.ROOT,
                "%n%6s %14s %14s %14s %10s%n",
                "hour",
                "server B/step",
                "server us/step",
                "hull B/step",
                "heap MiB");
        List<Hour> measured = new ArrayList<>();
        for (int hour = 0; hour < hours; hour++) {
            measured.add(hour(hour));
        }
        Hour first = measured.get(Math.min(1, hours - 1)); // by then all is compiled
        Hour last = measured.get(hours - 1);
        double growth = hours < 3 ? 0 : (last.heapMiB - first.heapMiB) / (hours - 2);
        Map<String, Integer> params = Map.of("hours", hours, "hz", HZ);
        return List.of(
                new Figure(NAME + ".allocation", params, last.serverBytes, "bytes a step, server", 0),
                new Figure(NAME + ".cpu", params, last.serverMicros, "us CPU a step, server", 0),
                new Figure(NAME + ".sent", params, (double) sentBytes / hours / STEPS_AN_HOUR, "bytes a step, sent", 0),
                new Figure(NAME + ".heap", params, growth, "MiB live per hour", 0));
    }

    private Hour hour(int hour) {
        long serverBytes = 0;
        long hullBytes = 0;
        long serverNanos = 0;
        for (int step = 1; step <= STEPS_AN_HOUR; step++) {
            long nowMs = ((long) hour * STEPS_AN_HOUR + step) * STEP_MS;
            long before = threads.getThreadAllocatedBytes(thread);
            hull.setUnderWay(boat.mode().isUnderWay());
            hull.step(1.0 / HZ);
            instruments.step(1.0 / HZ);
            long between = threads.getThreadAllocatedBytes(thread);
            long cpu = threads.getCurrentThreadCpuTime();
            if (step % HZ == 0) {
                say(new Heartbeat(nowMs), nowMs);
            }
            boat.tick(nowMs);
            serverNanos += threads.getCurrentThreadCpuTime() - cpu;
            serverBytes += threads.getThreadAllocatedBytes(thread) - between;
            hullBytes += between - before;
            if (boat.mode() != BoatMode.PATH) {
                hull.setBatteryPercent(100);
                command(new StartWaypoints("s" + nowMs, "round", 0), nowMs);
            }
        }
        Hour measured = new Hour(
                (double) serverBytes / STEPS_AN_HOUR,
                serverNanos / 1e3 / STEPS_AN_HOUR,
                (double) hullBytes / STEPS_AN_HOUR,
                EndlessRun.liveHeapMiB());
        System.out.printf(
                Locale.ROOT,
                "%6d %14.0f %14.1f %14.0f %10.2f%n",
                hour + 1,
                measured.serverBytes,
                measured.serverMicros,
                measured.hullBytes,
                measured.heapMiB);
        return measured;
    }
}
