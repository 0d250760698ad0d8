package org.sami.mavlink.testing;

import io.dronefleet.mavlink.MavlinkConnection;
import io.dronefleet.mavlink.MavlinkMessage;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.minimal.Heartbeat;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * A companion computer on board of a copter, on a port of its autopilot: its camera looks down and follows each of some places as long as the copter is over it. The
 * autopilot passes on what it says, as to any link. Safe for use by several threads.
 */
public final class CameraDetector implements AutoCloseable {
    private static final int CAMERA = 100;
    private static final int AUTOPILOT = 1;
    private static final int POSITION = 33;
    private static final float EVERY_US = 250_000;
    private static final double SIGHT_M = 25;
    private static final double LEAST_HEIGHT_M = 10;
    private static final double METRES = 0.0111319; // of a ten millionth of a degree of latitude

    private final Socket socket;
    private final List<double[]> places;
    private final AtomicInteger said = new AtomicInteger();

    /**
     * Begins to look.
     *
     * @param places latitude and longitude of each, in degrees
     */
    public CameraDetector(int port, int system, List<double[]> places) throws IOException {
        this.places = List.copyOf(places);
        socket = new Socket(InetAddress.getLoopbackAddress(), port);
        MavlinkConnection codec = MavlinkConnection.create(socket.getInputStream(), socket.getOutputStream());
        Thread thread = new Thread(() -> look(codec, system), "camera of " + system);
        thread.setDaemon(true);
        thread.start();
    }

    private void look(MavlinkConnection codec, int system) {
        try {
            for (MavlinkMessage<?> message = codec.next(); message != null; message = codec.next()) {
                if (message.getOriginComponentId() == AUTOPILOT && message.getPayload() instanceof Heartbeat) {
                    codec.send2(system, CAMERA, where(system)); // again and again: while it starts it takes no orders
                } else if (message.getOriginComponentId() == AUTOPILOT
                        && message.getPayload() instanceof GlobalPositionInt at
                        && at.relativeAlt() > LEAST_HEIGHT_M * 1_000) {
                    for (double[] place : places) {
                        if (metres(at, place) < SIGHT_M) {
                            codec.send2(system, CAMERA, SensorMessages.target(place[0], place[1]));
                            said.incrementAndGet();
                        }
                    }
                }
            }
        } catch (IOException e) {
            // it was closed
        }
    }

    /** Asks it to say where it is. */
    private static CommandLong where(int system) {
        return CommandLong.builder()
                .targetSystem(system)
                .targetComponent(AUTOPILOT)
                .command(MavCmd.MAV_CMD_SET_MESSAGE_INTERVAL)
                .param1(POSITION)
                .param2(EVERY_US)
                .build();
    }

    private static double metres(GlobalPositionInt from, double[] place) {
        double narrower = Math.cos(Math.toRadians(place[0]));
        return Math.hypot((from.lat() - place[0] * 1e7) * METRES, (from.lon() - place[1] * 1e7) * METRES * narrower);
    }

    /** How often it has said that it follows something. */
    public int said() {
        return said.get();
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
