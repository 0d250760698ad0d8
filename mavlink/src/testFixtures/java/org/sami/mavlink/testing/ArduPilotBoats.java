package org.sami.mavlink.testing;

import java.io.File;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;

/** Processes of ArduPilot's simulator with the real firmware of boats, or of copters, if it is installed next to the project. Their numbers give system ids and ports. */
public final class ArduPilotBoats implements AutoCloseable {
    private static final Path PEERS = Path.of("../../shared/peers/ardupilot");
    private static final int FIRST_PORT = 5760;
    private static final int APART = 10;
    private static final int SECOND_LINK = 2;

    private final Process process;

    /**
     * Starts some.
     *
     * @param first the number of the first; its system id is one more
     * @param speed factor of simulated to real time
     * @param work a folder for their parameters and logs
     */
    public ArduPilotBoats(int first, int count, int speed, Path work) throws IOException {
        this("boat", first, count, speed, work, "");
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
                "boat", first, count, speed, work, file.toAbsolutePath().toString());
    }

    /** Starts copters, as the constructor starts boats. */
    public static ArduPilotBoats copters(int first, int count, int speed, Path work) throws IOException {
        return new ArduPilotBoats("copter", first, count, speed, work, "");
    }

    /**
     * Starts one boat or copter with parameters of its owner.
     *
     * @param kind {@code boat} or {@code copter}
     * @param parameters a file with a name and a value in each line
     */
    public static ArduPilotBoats of(String kind, int number, int speed, Path work, Path parameters) throws IOException {
        return new ArduPilotBoats(
                kind, number, 1, speed, work, parameters.toAbsolutePath().toString());
    }

    private ArduPilotBoats(String kind, int first, int count, int speed, Path work, String parameters)
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

    /** Ends them. */
    @Override
    public void close() throws InterruptedException {
        process.destroy();
        if (!process.waitFor(30, TimeUnit.SECONDS)) {
            process.destroyForcibly();
        }
    }
}
