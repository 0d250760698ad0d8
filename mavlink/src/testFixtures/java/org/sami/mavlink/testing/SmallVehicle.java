package org.sami.mavlink.testing;

import io.dronefleet.mavlink.MavlinkConnection;
import io.dronefleet.mavlink.MavlinkMessage;
import io.dronefleet.mavlink.ardupilotmega.EkfStatusReport;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.GpsFixType;
import io.dronefleet.mavlink.common.GpsRawInt;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavFrame;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MavSeverity;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.common.MissionRequestList;
import io.dronefleet.mavlink.common.Statustext;
import io.dronefleet.mavlink.common.SysStatus;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import io.dronefleet.mavlink.util.EnumValue;
import java.io.IOException;
import java.io.OutputStream;
import java.math.BigInteger;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/**
 * A boat with an autopilot that lies still on TCP on loopback: it reports itself ten times a second, and sends its mission of a few points to whoever asks. One
 * client at a time, as an autopilot's port has.
 */
public final class SmallVehicle implements AutoCloseable {
    private static final int LAT = 457_000_000;
    private static final int LON = 107_200_000;
    private static final int APART = 1_000;
    private static final int FILTER_IS_LOCATED = 16;
    private static final int AUTOPILOT = 1;

    private final int system;
    private final int points;
    private final boolean firstVersion;
    private final ServerSocket server;
    private final Thread thread;
    private volatile Socket client = new Socket();
    private final ScheduledExecutorService reports = Executors.newSingleThreadScheduledExecutor(work -> {
        Thread made = new Thread(work, "small vehicle reports");
        made.setDaemon(true);
        return made;
    });

    /**
     * Begins to listen on a free port.
     *
     * @param points how many items its mission has
     * @param firstVersion whether it speaks MAVLink 1
     */
    public SmallVehicle(int system, int points, boolean firstVersion) throws IOException {
        this(system, points, firstVersion, 0);
    }

    /** The same on a given port; 0 for a free one. */
    public SmallVehicle(int system, int points, boolean firstVersion, int port) throws IOException {
        this.system = system;
        this.points = points;
        this.firstVersion = firstVersion;
        server = new ServerSocket();
        server.setReuseAddress(true);
        server.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), 1);
        thread = new Thread(this::serve, "small vehicle " + system);
        thread.setDaemon(true);
        thread.start();
    }

    /** Its address for a base. */
    public String address() {
        return "mavlink:tcp:127.0.0.1:" + server.getLocalPort();
    }

    private void serve() {
        while (!server.isClosed()) {
            try (Socket socket = server.accept()) {
                client = socket;
                socket.setTcpNoDelay(true);
                OutputStream out = socket.getOutputStream();
                MavlinkConnection codec = MavlinkConnection.create(socket.getInputStream(), out);
                var reporting = reports.scheduleAtFixedRate(() -> report(codec), 0, 100, TimeUnit.MILLISECONDS);
                try {
                    for (MavlinkMessage<?> message = codec.next(); message != null; message = codec.next()) {
                        answer(codec, message.getPayload());
                    }
                } finally {
                    reporting.cancel(false);
                }
            } catch (IOException e) {
                // this client is gone; the next may come
            }
        }
    }

    private void report(MavlinkConnection codec) {
        try {
            send(
                    codec,
                    Heartbeat.builder()
                            .type(MavType.MAV_TYPE_SURFACE_BOAT)
                            .autopilot(MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA)
                            .customMode(4)
                            .systemStatus(MavState.MAV_STATE_STANDBY)
                            .mavlinkVersion(3)
                            .build());
            send(
                    codec,
                    GlobalPositionInt.builder()
                            .lat(LAT)
                            .lon(LON)
                            .vx(30)
                            .vy(40)
                            .hdg(9_000)
                            .build());
            send(
                    codec,
                    SysStatus.builder()
                            .voltageBattery(12_600)
                            .batteryRemaining(87)
                            .build());
            send(
                    codec,
                    GpsRawInt.builder()
                            .timeUsec(BigInteger.ZERO)
                            .fixType(GpsFixType.GPS_FIX_TYPE_3D_FIX)
                            .satellitesVisible(9)
                            .build());
            send(
                    codec,
                    EkfStatusReport.builder()
                            .flags(EnumValue.create(FILTER_IS_LOCATED))
                            .build());
            send(
                    codec,
                    Statustext.builder()
                            .severity(MavSeverity.MAV_SEVERITY_WARNING)
                            .text("PreArm: safety switch")
                            .build());
        } catch (IOException e) {
            // its reading thread finds out
        }
    }

    private void answer(MavlinkConnection codec, Object message) throws IOException {
        if (message instanceof MissionRequestList list) {
            send(
                    codec,
                    MissionCount.builder()
                            .count(isMission(list.missionType()) ? points : 0)
                            .missionType(list.missionType())
                            .build());
        } else if (message instanceof MissionRequestInt item) {
            send(
                    codec,
                    MissionItemInt.builder()
                            .seq(item.seq())
                            .frame(MavFrame.MAV_FRAME_GLOBAL_INT)
                            .command(MavCmd.MAV_CMD_NAV_WAYPOINT)
                            .x(LAT + item.seq() * APART)
                            .y(LON)
                            .missionType(item.missionType())
                            .build());
        }
    }

    private static boolean isMission(EnumValue<MavMissionType> type) {
        return type.entry() == MavMissionType.MAV_MISSION_TYPE_MISSION;
    }

    private void send(MavlinkConnection codec, Object payload) throws IOException {
        synchronized (codec) {
            if (!firstVersion) {
                codec.send2(system, AUTOPILOT, payload);
            } else if (payload instanceof Heartbeat) {
                codec.send1(system, AUTOPILOT, payload);
            }
        }
    }

    /** Ends it: its port is free, and its client is cut off. */
    @Override
    public void close() throws IOException {
        server.close();
        client.close();
        reports.shutdownNow();
    }
}
