package org.sami.session.client.testing;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/** Two networks of this machine, of which nothing leads out, joined by a virtual cable that can be cut in each direction. Needs root and {@code ip}. */
public final class TwoNetworks implements AutoCloseable {
    public static final String FIRST_ADDRESS = "10.77.0.1";
    public static final String SECOND_ADDRESS = "10.77.0.2";

    /** What they are after {@link #giveOtherAddresses}. */
    public static final String FIRST_LATER = "10.89.74.5";

    public static final String SECOND_LATER = "10.89.74.6";

    private static final String NOBODYS = "02:00:00:00:00:99";

    private static final AtomicInteger MADE = new AtomicInteger();

    private final String name = ProcessHandle.current().pid() + "-" + MADE.incrementAndGet(); // tests run side by side
    private final String first = "sami-a-" + name;
    private final String second = "sami-b-" + name;

    public TwoNetworks() {
        assumeTrue(
                ip("netns", "add", first),
                "networks of their own need root and the program ip: sudo apt install iproute2, then run as root");
        must("netns", "add", second);
        must("link", "add", "va", "netns", first, "type", "veth", "peer", "name", "vb", "netns", second);
        must("-n", first, "addr", "add", FIRST_ADDRESS + "/24", "dev", "va");
        must("-n", second, "addr", "add", SECOND_ADDRESS + "/24", "dev", "vb");
        for (String network : List.of(first, second)) {
            must("-n", network, "link", "set", "lo", "up");
            must("-n", network, "link", "set", network.equals(first) ? "va" : "vb", "up");
        }
    }

    public List<String> inFirst() {
        return List.of("ip", "netns", "exec", first);
    }

    public List<String> inSecond() {
        return List.of("ip", "netns", "exec", second);
    }

    /** Gives both other addresses, as another network does. */
    public void giveOtherAddresses() {
        must("-n", first, "addr", "flush", "dev", "va");
        must("-n", second, "addr", "flush", "dev", "vb");
        must("-n", first, "addr", "add", FIRST_LATER + "/24", "dev", "va");
        must("-n", second, "addr", "add", SECOND_LATER + "/24", "dev", "vb");
    }

    /** What the first sends is lost from now on: it goes to a card that nobody has. */
    public void cutFromFirst() {
        must("-n", first, "neigh", "replace", SECOND_ADDRESS, "lladdr", NOBODYS, "dev", "va", "nud", "permanent");
    }

    /** What the second sends is lost from now on. */
    public void cutFromSecond() {
        must("-n", second, "neigh", "replace", FIRST_ADDRESS, "lladdr", NOBODYS, "dev", "vb", "nud", "permanent");
    }

    /** Both reach one another again, whatever was cut. */
    public void heal() {
        must("-n", first, "neigh", "flush", "nud", "permanent", "dev", "va");
        must("-n", second, "neigh", "flush", "nud", "permanent", "dev", "vb");
    }

    /**
     * Some of the packets are lost from now on, in both directions.
     *
     * @param share 0 to 1
     */
    public void lose(double share) {
        for (String network : List.of(first, second)) {
            assumeTrue(
                    List.of("iptables", "iptables-legacy").stream().anyMatch(program -> drop(program, network, share)),
                    "packets are dropped by iptables: sudo apt install iptables, then run as root");
        }
    }

    private boolean drop(String program, String network, double share) {
        String device = network.equals(first) ? "va" : "vb";
        return ip(
                "netns",
                "exec",
                network,
                program,
                "-A",
                "INPUT",
                "-i",
                device,
                "-m",
                "statistic",
                "--mode",
                "random",
                "--probability",
                Double.toString(share),
                "-j",
                "DROP");
    }

    private static void must(String... arguments) {
        if (!ip(arguments)) {
            throw new IllegalStateException("failed: ip " + String.join(" ", arguments));
        }
    }

    private static boolean ip(String... arguments) {
        List<String> command = new ArrayList<>(List.of("ip"));
        command.addAll(List.of(arguments));
        try {
            Process process = new ProcessBuilder(command)
                    .redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start();
            return process.waitFor(10, TimeUnit.SECONDS) && process.exitValue() == 0;
        } catch (IOException notInstalled) {
            return false;
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    @Override
    public void close() {
        ip("netns", "del", first);
        ip("netns", "del", second);
    }
}
