package org.sami.pair.postgres;

import java.util.regex.Pattern;

/**
 * How one base of a pair sees it.
 *
 * @param here address or name of this machine, as the other reaches it
 * @param other address or name of the other machine
 * @param port of both databases
 * @param whenCut which of both goes on by itself where they do not reach one another
 */
public record PairSettings(String here, String other, int port, WhenCut whenCut) {
    private static final Pattern HOST = Pattern.compile("[A-Za-z0-9.:-]+");
    private static final Pattern LOOPBACK = Pattern.compile("127\\.\\d+\\.\\d+\\.\\d+|::1|localhost");
    private static final int MOST_PORT = 65_535;

    public PairSettings {
        checkHost(here);
        checkHost(other);
        if (here.equals(other)) {
            throw new IllegalArgumentException("a pair is two machines, and both addresses are " + here);
        }
        if (port < 1 || port > MOST_PORT) {
            throw new IllegalArgumentException("a port is 1 to " + MOST_PORT + ", not " + port);
        }
    }

    private static void checkHost(String host) {
        if (!HOST.matcher(host).matches()) {
            throw new IllegalArgumentException("'" + host + "' is no address and no name of a machine");
        }
    }

    /** As the other base sees it. */
    public PairSettings seenByOther() {
        return new PairSettings(/* here= */ other, /* other= */ here, port, whenCut);
    }

    /** The same pair where its bases have other addresses. */
    PairSettings at(String newHere, String newOther) {
        return new PairSettings(newHere, newOther, port, whenCut);
    }

    /** Where this machine's programs reach its own database. */
    String loopback() {
        return LOOPBACK.matcher(here).matches() ? here : "127.0.0.1";
    }

    /** At which addresses the database listens. */
    String listenAt() {
        return here.equals(loopback()) ? here : loopback() + "," + here;
    }
}
