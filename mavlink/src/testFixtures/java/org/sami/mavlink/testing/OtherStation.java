package org.sami.mavlink.testing;

import io.dronefleet.mavlink.MavlinkConnection;
import io.dronefleet.mavlink.MavlinkMessage;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.Socket;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/** Another ground station than the base's, with a system id of its own, on a port of a vehicle: says twice a second that it is there, and commands. */
public final class OtherStation implements AutoCloseable {
    private static final int COMPONENT = 190;
    private static final long HEARTBEAT_MS = 500;
    private static final float CUSTOM_MODE = 1;

    private final int id;
    private final Socket socket;
    private final MavlinkConnection codec;
    private volatile int mode = -1;
    private volatile int beatsInMode;
    private final ScheduledExecutorService beats =
            Executors.newSingleThreadScheduledExecutor(task -> new Thread(task, "other station"));

    /** Connects, and begins to say that it is there. */
    public OtherStation(int id, int port) throws IOException {
        this.id = id;
        socket = new Socket(InetAddress.getLoopbackAddress(), port);
        codec = MavlinkConnection.create(socket.getInputStream(), socket.getOutputStream());
        Thread reading = new Thread(this::read, "other station's reading");
        reading.setDaemon(true);
        reading.start();
        var unused = beats.scheduleAtFixedRate(this::beat, 0, HEARTBEAT_MS, TimeUnit.MILLISECONDS);
    }

    private void read() {
        try {
            for (MavlinkMessage<?> message = codec.next(); message != null; message = codec.next()) {
                if (message.getPayload() instanceof Heartbeat beat
                        && beat.type().entry() != MavType.MAV_TYPE_GCS) {
                    beatsInMode = mode == beat.customMode() ? beatsInMode + 1 : 1;
                    mode = (int) beat.customMode();
                }
            }
        } catch (IOException e) {
            // the link has ended
        }
    }

    /** The number of the mode that the vehicle has said last; -1 before. */
    public int mode() {
        return mode;
    }

    /** How many heartbeats of the vehicle have had that mode, one after the other. */
    public int beatsInMode() {
        return beatsInMode;
    }

    private void beat() {
        send(Heartbeat.builder()
                .type(MavType.MAV_TYPE_GCS)
                .autopilot(MavAutopilot.MAV_AUTOPILOT_INVALID)
                .systemStatus(MavState.MAV_STATE_ACTIVE)
                .mavlinkVersion(3)
                .build());
    }

    /** Orders a vehicle into a mode by its number. */
    public void setMode(int vehicle, int mode) {
        send(CommandLong.builder()
                .targetSystem(vehicle)
                .targetComponent(1)
                .command(MavCmd.MAV_CMD_DO_SET_MODE)
                .param1(CUSTOM_MODE)
                .param2(mode)
                .build());
    }

    private synchronized void send(Object message) {
        try {
            codec.send2(id, COMPONENT, message);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public void close() throws IOException {
        beats.shutdownNow();
        socket.close();
    }
}
