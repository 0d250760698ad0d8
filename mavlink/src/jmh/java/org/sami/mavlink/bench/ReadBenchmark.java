package org.sami.mavlink.bench;

import io.dronefleet.mavlink.MavlinkConnection;
import io.dronefleet.mavlink.ardupilotmega.ArdupilotmegaDialect;
import io.dronefleet.mavlink.ardupilotmega.EkfStatusReport;
import io.dronefleet.mavlink.common.Attitude;
import io.dronefleet.mavlink.common.FenceStatus;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.GpsFixType;
import io.dronefleet.mavlink.common.GpsRawInt;
import io.dronefleet.mavlink.common.MissionCurrent;
import io.dronefleet.mavlink.common.SysStatus;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import io.dronefleet.mavlink.util.EnumValue;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.management.ManagementFactory;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.sami.figures.Figure;
import org.sami.mavlink.link.MessageReader;

/**
 * What a vehicle reports in 1,000 s, read from memory: by the library alone, by ours, and by ours where nobody listens to it. The three are measured in turn,
 * in messages for each second of processor time; bytes of a socket cost system calls besides.
 */
final class ReadBenchmark {
    static final String NAME = "mavlink.read";
    private static final int SECONDS = 1_000;

    private final int warmUps;
    private final int rounds;
    private int blackHole;

    ReadBenchmark(int warmUps, int rounds) {
        this.warmUps = warmUps;
        this.rounds = rounds;
    }

    /** Reads all messages of some bytes; how many. */
    private interface Reading {
        int read(byte[] bytes) throws IOException;
    }

    List<Figure> run() throws IOException {
        byte[] bytes = reports();
        List<Double> library = new ArrayList<>();
        List<Double> ours = new ArrayList<>();
        List<Double> unread = new ArrayList<>();
        for (int i = 0; i < warmUps + rounds; i++) {
            library.add(perSecond(bytes, this::byLibrary));
            ours.add(perSecond(bytes, these -> byOurs(these, kind -> true)));
            unread.add(perSecond(bytes, these -> byOurs(these, kind -> false)));
        }
        if (blackHole == 0) {
            throw new IllegalStateException("nothing was read");
        }
        double before = median(library);
        double after = median(ours);
        return List.of(
                figure(".library", before, "messages/s, by the library alone"),
                figure("", after, "messages/s"),
                figure(".ratio", after / before, "times the library's"),
                figure(".unread", median(unread), "messages/s that nobody listens to"));
    }

    private static Figure figure(String what, double value, String unit) {
        return new Figure(NAME + what, Map.of(), value, unit, 0);
    }

    private double median(List<Double> all) {
        List<Double> measured =
                all.subList(warmUps, all.size()).stream().sorted().toList();
        return measured.get(measured.size() / 2);
    }

    private static double perSecond(byte[] bytes, Reading reading) throws IOException {
        long before = cpuNanos();
        int messages = reading.read(bytes);
        return messages / ((cpuNanos() - before) / 1e9);
    }

    private static long cpuNanos() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }

    private int byLibrary(byte[] bytes) throws IOException {
        MavlinkConnection codec = MavlinkConnection.builder(
                        new ByteArrayInputStream(bytes), OutputStream.nullOutputStream())
                .defaultDialect(new ArdupilotmegaDialect())
                .build();
        int messages = 0;
        try {
            while (true) {
                blackHole += codec.next().getPayload().getClass().getName().length();
                messages++;
            }
        } catch (EOFException e) {
            return messages;
        }
    }

    private int byOurs(byte[] bytes, Predicate<Class<?>> isRead) throws IOException {
        MessageReader reader = new MessageReader(new ByteArrayInputStream(bytes), isRead);
        int messages = 0;
        try {
            while (true) {
                blackHole += reader.message(reader.next()).getClass().getName().length();
                messages++;
            }
        } catch (EOFException e) {
            return messages;
        }
    }

    /** What a vehicle sends that is asked as a base asks: positions four times a second, all else once. */
    private static byte[] reports() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        MavlinkConnection codec = MavlinkConnection.create(InputStream.nullInputStream(), bytes);
        for (int second = 0; second < SECONDS; second++) {
            for (int part = 0; part < 4; part++) {
                codec.send2(1, 1, position(second * 1_000 + part * 250));
            }
            for (Object rest : rest(second)) {
                codec.send2(1, 1, rest);
            }
        }
        return bytes.toByteArray();
    }

    private static Object position(int bootMs) {
        return GlobalPositionInt.builder()
                .timeBootMs(bootMs)
                .lat(457_000_000 + bootMs)
                .lon(107_200_000)
                .alt(65_000)
                .vx(120)
                .vy(-40)
                .hdg(9_000)
                .build();
    }

    private static List<Object> rest(int second) {
        return List.of(
                Heartbeat.builder()
                        .type(MavType.MAV_TYPE_SURFACE_BOAT)
                        .autopilot(MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA)
                        .baseMode(EnumValue.create(209))
                        .customMode(10)
                        .systemStatus(MavState.MAV_STATE_ACTIVE)
                        .mavlinkVersion(3)
                        .build(),
                SysStatus.builder().voltageBattery(12_600).batteryRemaining(87).build(),
                GpsRawInt.builder()
                        .timeUsec(BigInteger.valueOf(second * 1_000_000L))
                        .fixType(GpsFixType.GPS_FIX_TYPE_3D_FIX)
                        .satellitesVisible(9)
                        .build(),
                EkfStatusReport.builder().flags(EnumValue.create(831)).build(),
                FenceStatus.builder().build(),
                MissionCurrent.builder().seq(second % 400).total(400).build(),
                Attitude.builder().timeBootMs(second * 1_000L).yaw(1.5f).build());
    }
}
