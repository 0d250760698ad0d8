package org.sami.crw.cli.pair;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;

/** The address of this machine in a network of several. */
final class OwnAddress {
    private static final int ANY_PORT = 9;

    private OwnAddress() {}

    /**
     * That from which it reaches another machine.
     *
     * @throws IllegalArgumentException in words, if it has no way there
     */
    static String towards(String other) {
        try (DatagramSocket socket = new DatagramSocket()) {
            socket.connect(new InetSocketAddress(InetAddress.getByName(other), ANY_PORT)); // sends nothing
            return socket.getLocalAddress().getHostAddress();
        } catch (IOException | UncheckedIOException unreached) {
            throw new IllegalArgumentException(
                    "this base has no way to " + other + " (" + unreached.getMessage() + "); --here names its address");
        }
    }
}
