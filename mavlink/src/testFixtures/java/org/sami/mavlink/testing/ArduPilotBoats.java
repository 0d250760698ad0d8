package org.sami.mavlink.testing;

import java.io.File;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** Processes of ArduPilot's simulator with the real firmware of boats, or of copters, if it is installed next to the project. Their numbers give system ids and ports. */
public final class ArduPilotBoats implements AutoCloseable {
    private static final Path PEERS = Path.of("../../shared/peers/ardupilot");
    private static final int FIRST_PORT = 5760;
    private static final int APART = 10;
    private static final int SECOND_LINK = 2;
    private static final double NEXT_DEG = 0.0003; // of longitude, between two
    private static final int ALTITUDE_M = 65;
    private static final String CALM = "SIM_WIND_SPD 0\nSIM_WAVE_ENABLE 0\n";

    /** Beginning a log holds up a simulated boat as it is armed, so that it disarms itself; after a start it refuses to be armed until its log has begun. */
    private static final String WITHOUT_LOGS = "LOG_BACKEND_TYPE 0\n";

    private final Process process;

    /**
     * Starts some.
     *
     * @param first the number of the first; its system id is one more
     * @param speed factor of simulated to real time
     * @param work a folder for their parameters and logs
     */
    public ArduPilotBoats(int first, int count, int speed, Path work) throws IOException {
        this("boat", first, count, speed, work, "", Map.of());
    }

    /**
     * Starts one boat without logs at a place on calm water, where a boat that is not driven does not drift for long. It sends to a port of UDP on this machine in place of its
     * first link.
     *
     * @param headingDeg from north clockwise
     */
    public static ArduPilotBoats sending(
            int udpPort, double latDeg, double lonDeg, double headingDeg, int number, int speed, Path work)
            throws IOException {
        double westDeg = number * NEXT_DEG; // where the first of them would be
        String home = String.format(
                Locale.ROOT, "%.7f,%.7f,%d,%.1f", latDeg, lonDeg - westDeg, ALTITUDE_M, (headingDeg + 360) % 360);
        requireFree(secondPort(number)); // else the boat of another one would be heard there
        String calm = Files.writeString(work.resolve("calm.parm"), CALM + WITHOUT_LOGS)
                .toAbsolutePath()
                .toString();
        return new ArduPilotBoats(
                "boat", number, 1, speed, work, calm, Map.of("UDP", "127.0.0.1:" + udpPort, "HOME_AT", home));
    }

    /**
     * Starts boats that differ from the usual ones, as the constructor starts those.
     *
     * @param parameters their parameters that differ, each a line of a name and a value
     */
    public static ArduPilotBoats with(String parameters, int first, int count, int speed, Path work)
            throws IOException {
        Path file = Files.writeString(work.resolve("other.parm"), parameters);
        return new ArduPilotBoats(
                "boat", first, count, speed, work, file.toAbsolutePath().toString(), Map.of());
    }

    /** Starts copters, as the constructor starts boats. */
    public static ArduPilotBoats copters(int first, int count, int speed, Path work) throws IOException {
        return new ArduPilotBoats("copter", first, count, speed, work, "", Map.of());
    }

    /**
     * Starts one boat or copter with parameters of its owner.
     *
     * @param kind {@code boat} or {@code copter}
     * @param parameters a file with a name and a value in each line
     */
    public static ArduPilotBoats of(String kind, int number, int speed, Path work, Path parameters) throws IOException {
        return new ArduPilotBoats(
                kind, number, 1, speed, work, parameters.toAbsolutePath().toString(), Map.of());
    }

    private ArduPilotBoats(
            String kind, int first, int count, int speed, Path work, String parameters, Map<String, String> further)
            throws IOException {
        for (int number = first; number < first + count; number++) {
            requireFree(firstPort(number));
        }
        ProcessBuilder builder = new ProcessBuilder(
                        "bash", "run.sh", kind, Integer.toString(count), Integer.toString(speed))
                .directory(PEERS.toFile())
                .redirectErrorStream(true)
                .redirectOutput(new File(work.toFile(), kind + "s.txt"));
        builder.environment().put("FIRST", Integer.toString(first));
        builder.environment().put("WORK", work.toAbsolutePath().toString());
        builder.environment().put("PARAMS", parameters);
        builder.environment().putAll(further);
        process = builder.start();
    }

    /** Else a test would command the vehicles of another one, whose processes are left or run beside it. */
    private static void requireFree(int port) throws IOException {
        try (ServerSocket free = new ServerSocket(port, 1, InetAddress.getLoopbackAddress())) {
            // it is free again once this is closed
        } catch (IOException e) {
            throw new IOException("a simulated vehicle is there already: port " + port + " is in use", e);
        }
    }

    /** Whether the firmware is there. */
    public static boolean areThere() {
        return Files.isExecutable(PEERS.resolve("run.sh"));
    }

    /** What to say where it is not. */
    public static String missing() {
        return "no autopilot is here to try: " + PEERS.toAbsolutePath().normalize() + " is missing";
    }

    /** The address of the first link of a boat, by its number. */
    public static String address(int number) {
        return "mavlink:tcp:127.0.0.1:" + firstPort(number);
    }

    /** The port of its first link. */
    public static int firstPort(int number) {
        return FIRST_PORT + APART * number;
    }

    /** The port of its second link. */
    public static int secondPort(int number) {
        return firstPort(number) + SECOND_LINK;
    }

    /** The port of its third link. */
    public static int thirdPort(int number) {
        return secondPort(number) + 1;
    }

    /** The processes of their firmware. */
    public Stream<ProcessHandle> firmware() {
        return process.children()
                .filter(each -> Path.of(each.info().command().orElse("none"))
                        .getFileName()
                        .toString()
                        .startsWith("ardu"));
    }

    /** Waits until all of them have ended, as after the end of their firmware. */
    public void awaitEnd() throws InterruptedException {
        process.waitFor();
    }

    /** Ends them. */
    @Override
    public void close() throws InterruptedException {
        process.destroy();
        if (!process.waitFor(30, TimeUnit.SECONDS)) {
            process.destroyForcibly();
        }
    }
}
