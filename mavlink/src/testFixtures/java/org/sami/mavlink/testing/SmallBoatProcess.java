package org.sami.mavlink.testing;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Small boats in a process of their own, so that what they need is not counted for a base. They report as often as a base asks for, and end with this process. */
public final class SmallBoatProcess implements AutoCloseable {
    /** Latitude of the pier along which they lie, in degrees. */
    public static final double LAT_DEG = 45.7;

    /** Its longitude, in degrees. */
    public static final double LON_DEG = 10.72;

    private static final double BERTH_DEG = 1e-4; // 11 m

    private final Process process;
    private final List<String> addresses = new ArrayList<>();

    /** Begins the process; the boats' system ids are 1 and so on. */
    public SmallBoatProcess(int boats) throws IOException {
        process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        SmallBoatProcess.class.getName(),
                        "" + boats)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        BufferedReader out =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        for (int i = 0; i < boats; i++) {
            String address = out.readLine();
            if (address == null) {
                throw new IOException("the boats' process has ended");
            }
            addresses.add(address);
        }
    }

    /** The boats' addresses for a base, in order. */
    public List<String> addresses() {
        return List.copyOf(addresses);
    }

    @Override
    public void close() throws InterruptedException {
        process.destroy();
        process.waitFor();
    }

    /** The boats' process, given their number: prints an address for each boat, and runs until its input ends. */
    public static void main(String[] args) throws IOException {
        int boats = Integer.parseInt(args[0]);
        for (int i = 1; i <= boats; i++) {
            SmallBoat boat = new SmallBoat(i, LAT_DEG + i * BERTH_DEG, LON_DEG, 1);
            boat.reports().seldom();
            System.out.println(boat.address() + "/" + i);
        }
        while (System.in.read() >= 0) {
            // nothing is expected: the end is
        }
        System.exit(0);
    }
}
