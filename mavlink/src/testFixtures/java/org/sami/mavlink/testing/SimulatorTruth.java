package org.sami.mavlink.testing;

import io.dronefleet.mavlink.MavlinkConnection;
import io.dronefleet.mavlink.MavlinkMessage;
import io.dronefleet.mavlink.ardupilotmega.ArdupilotmegaDialect;
import io.dronefleet.mavlink.ardupilotmega.Simstate;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavSysStatusSensor;
import io.dronefleet.mavlink.common.Statustext;
import io.dronefleet.mavlink.common.SysStatus;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavModeFlag;
import io.dronefleet.mavlink.util.EnumValue;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Where a simulated vehicle truly was, as its simulator says on a link of its own ten times a second of simulated time. Between two reports it is taken to have
 * gone straight; where they are too far apart for that, or none come any longer, nothing is said of where it was ({@link #gap}). Safe for use by several threads.
 */
public final class SimulatorTruth implements AutoCloseable {
    private static final int SIMSTATE = 164;
    private static final float EVERY_US = 100_000;
    private static final double METRES = 0.0111319; // of a ten millionth of a degree of latitude
    private static final int GROUND = 250;
    private static final int CHECKS =
            EnumValue.of(MavSysStatusSensor.MAV_SYS_STATUS_PREARM_CHECK).value();
    private static final int AUTOPILOT = 1;
    private static final double GAP_M = 5; // reports of a vehicle at 3 m/s are 0.3 m apart

    private final Socket socket;
    private final List<int[]> track = new ArrayList<>();
    private final List<String> texts = new ArrayList<>();
    private final List<Long> heardNs = new ArrayList<>(); // when each was heard, on this process's clock
    private double headingRad;
    private boolean armed;
    private boolean isReady;
    private volatile boolean isClosed;
    private volatile String ended = ""; // why nothing is heard any longer

    /** Begins to listen on a vehicle's port. */
    public SimulatorTruth(int port, int system) throws IOException {
        socket = new Socket(InetAddress.getLoopbackAddress(), port);
        MavlinkConnection codec = MavlinkConnection.builder(socket.getInputStream(), socket.getOutputStream())
                .defaultDialect(new ArdupilotmegaDialect())
                .dialect(MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA, new ArdupilotmegaDialect())
                .build();
        ask(codec, system);
        Thread thread = new Thread(() -> read(codec, system), "truth of " + system);
        thread.setDaemon(true);
        thread.start();
    }

    private static void ask(MavlinkConnection codec, int system) throws IOException {
        codec.send2(
                GROUND,
                1,
                CommandLong.builder()
                        .targetSystem(system)
                        .targetComponent(1)
                        .command(MavCmd.MAV_CMD_SET_MESSAGE_INTERVAL)
                        .param1(SIMSTATE)
                        .param2(EVERY_US)
                        .build());
    }

    private void read(MavlinkConnection codec, int system) {
        try {
            for (MavlinkMessage<?> message = codec.next(); message != null; message = codec.next()) {
                if (message.getPayload() instanceof Heartbeat && samples() == 0) {
                    ask(codec, system); // a vehicle that starts forgets what it was asked before
                }
                if (message.getOriginSystemId() == system && message.getOriginComponentId() == AUTOPILOT) {
                    take(message.getPayload());
                }
            }
            ended = "its simulator has ended the link";
        } catch (IOException | RuntimeException e) {
            ended = isClosed ? "" : String.valueOf(e);
        }
    }

    private void take(Object message) {
        synchronized (track) {
            if (message instanceof Simstate state) {
                track.add(new int[] {state.lat(), state.lng()});
                heardNs.add(System.nanoTime());
                headingRad = state.yaw();
            } else if (message instanceof Heartbeat beat) {
                armed = beat.baseMode().flagsEnabled(MavModeFlag.MAV_MODE_FLAG_SAFETY_ARMED);
            } else if (message instanceof SysStatus status) {
                isReady = (status.onboardControlSensorsHealth().value() & CHECKS) != 0;
            } else if (message instanceof Statustext text) {
                texts.add(text.text());
            }
        }
    }

    /** How often its autopilot has said a text that begins so since this began to listen. */
    public int said(String words) {
        synchronized (track) {
            return (int) texts.stream().filter(text -> text.startsWith(words)).count();
        }
    }

    /** Whether its motors may turn, by its last heartbeat, which comes once a second of its own time. */
    public boolean isArmed() {
        synchronized (track) {
            return armed;
        }
    }

    /** Whether its own checks before arming pass, as it has said last. */
    public boolean isReady() {
        synchronized (track) {
            return isReady;
        }
    }

    /** Its heading in its last report, in degrees from north clockwise. */
    public double headingDeg() {
        synchronized (track) {
            return Math.toDegrees(headingRad);
        }
    }

    /**
     * Why nothing can be said of where it was for a part of the time: its reports have ended, or two are too far apart. A test that finds a place not visited says
     * this first.
     */
    public Optional<String> gap() {
        synchronized (track) {
            if (!ended.isEmpty()) {
                return Optional.of("after " + track.size() + " reports no more could be heard: " + ended);
            }
            for (int i = 1; i < track.size(); i++) {
                double metres = metres(track.get(i - 1), track.get(i));
                if (metres > GAP_M) {
                    return Optional.of(String.format(
                            Locale.ROOT,
                            "report %d of %d is %.1f m from the one before, heard %.1f s after it",
                            i,
                            track.size(),
                            metres,
                            (heardNs.get(i) - heardNs.get(i - 1)) * 1e-9));
                }
            }
            return Optional.empty();
        }
    }

    /** The greatest distance between two reports that follow one another, in metres. */
    public double longestStepM() {
        synchronized (track) {
            double longest = 0;
            for (int i = 1; i < track.size(); i++) {
                longest = Math.max(longest, metres(track.get(i - 1), track.get(i)));
            }
            return longest;
        }
    }

    /** How near it came to a place, in metres. */
    public double nearestM(double latDeg, double lonDeg) {
        return nearestM(0, latDeg, lonDeg);
    }

    /** How near it came to a place from one report on, in metres. */
    public double nearestM(int fromSample, double latDeg, double lonDeg) {
        double narrower = Math.cos(Math.toRadians(latDeg));
        double nearest = Double.MAX_VALUE;
        synchronized (track) {
            double[] before = null;
            for (int[] at : track.subList(Math.min(fromSample, track.size()), track.size())) {
                double[] now = {(at[1] - lonDeg * 1e7) * METRES * narrower, (at[0] - latDeg * 1e7) * METRES};
                nearest = Math.min(nearest, fromOriginM(before == null ? now : before, now));
                before = now;
            }
        }
        return nearest;
    }

    /** How near the way from one place to another comes to where both are counted from; of places too far apart, the nearer one. */
    private static double fromOriginM(double[] from, double[] to) {
        double eastM = to[0] - from[0];
        double northM = to[1] - from[1];
        double squared = eastM * eastM + northM * northM;
        double part = squared == 0 ? 0 : -(from[0] * eastM + from[1] * northM) / squared;
        double along =
                squared > GAP_M * GAP_M ? Math.rint(Math.max(0, Math.min(1, part))) : Math.max(0, Math.min(1, part));
        return Math.hypot(from[0] + along * eastM, from[1] + along * northM);
    }

    /** How near it came to another vehicle at one time, in metres; of vehicles at the speed of real time. */
    public double closestM(SimulatorTruth other) {
        List<int[]> others;
        List<Long> othersNs;
        synchronized (other.track) {
            others = List.copyOf(other.track);
            othersNs = List.copyOf(other.heardNs);
        }
        double closest = Double.MAX_VALUE;
        int next = 0;
        synchronized (track) {
            for (int i = 0; i < track.size() && !others.isEmpty(); i++) {
                while (next < others.size() - 1 && othersNs.get(next) < heardNs.get(i)) {
                    next++;
                }
                closest = Math.min(closest, metres(track.get(i), others.get(next)));
            }
        }
        return closest;
    }

    /** How many reports of its place have come. */
    public int samples() {
        synchronized (track) {
            return track.size();
        }
    }

    /** Its places from one report on: latitude and longitude in degrees. */
    public List<double[]> placesFrom(int sample) {
        synchronized (track) {
            return track.stream()
                    .skip(sample)
                    .map(at -> new double[] {at[0] / 1e7, at[1] / 1e7})
                    .toList();
        }
    }

    /** The longest time for which it stayed within a radius of where it was, in seconds of its own clock, from one report to another. */
    public double longestStayS(int fromSample, int toSample, double radiusM) {
        synchronized (track) {
            int longest = 0;
            int first = fromSample;
            for (int last = fromSample; last < Math.min(toSample, track.size()); last++) {
                while (metres(track.get(first), track.get(last)) > radiusM) {
                    first++;
                }
                longest = Math.max(longest, last - first);
            }
            return longest * EVERY_US * 1e-6;
        }
    }

    private static double metres(int[] from, int[] to) {
        double narrower = Math.cos(Math.toRadians(from[0] * 1e-7));
        return Math.hypot((from[0] - to[0]) * METRES, (from[1] - to[1]) * METRES * narrower);
    }

    @Override
    public void close() throws IOException {
        isClosed = true;
        socket.close();
    }
}
