package org.sami.boat.server.testing;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Ports on loopback for servers that must know theirs before they begin, or that begin again at the same one. A port that the system chose and that is
 * closed goes to the next program that lets the system choose, and to connections. These lie below the ports from which systems choose (from 32768 on Linux, from
 * 49152 elsewhere). One after another, so that no process draws one twice; processes begin in different places.
 */
public final class OwnPort {
    private static final int FIRST = 20_000;
    private static final int PORTS = 10_000;
    private static final AtomicInteger NEXT =
            new AtomicInteger(ThreadLocalRandom.current().nextInt(PORTS));

    private OwnPort() {}

    /** A port that nothing listens on. */
    public static int draw() {
        for (int i = 0; i < PORTS; i++) {
            int port = FIRST + Math.floorMod(NEXT.getAndIncrement(), PORTS);
            if (isFree(port)) {
                return port;
            }
        }
        throw new IllegalStateException("none of the ports from " + FIRST + " is free");
    }

    private static boolean isFree(int port) {
        try (ServerSocket socket = new ServerSocket(port, 1, InetAddress.getLoopbackAddress())) {
            return socket.isBound();
        } catch (IOException taken) {
            return false;
        }
    }
}
