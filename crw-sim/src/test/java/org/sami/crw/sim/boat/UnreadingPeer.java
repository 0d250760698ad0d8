package org.sami.crw.sim.boat;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.Progress;
import org.sami.boat.link.Role;
import org.sami.boat.link.Welcome;
import org.sami.boat.link.security.LinkSecurity;
import org.sami.boat.link.security.SecureLink;

/** A boat that talks and hardly listens: it welcomes whoever connects, says that it lives, and reads little or nothing. */
final class UnreadingPeer implements AutoCloseable {
    private final ServerSocket socket = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    private final Set<Socket> open = ConcurrentHashMap.newKeySet();
    private final CountDownLatch closing = new CountDownLatch(1);
    private final LinkCodec codec = new LinkCodec();
    private final String name;
    private final LinkSecurity security;
    private final int readsPerSecond;

    /** A boat that reads so many bytes a second. */
    UnreadingPeer(String name, LinkSecurity security, int readsPerSecond) throws IOException {
        this.name = name;
        this.security = security;
        this.readsPerSecond = readsPerSecond;
        socket.setReceiveBufferSize(16 << 10);
        start(this::accept);
    }

    InetSocketAddress address() {
        return (InetSocketAddress) socket.getLocalSocketAddress();
    }

    private static void start(Runnable work) {
        Thread thread = new Thread(work, "stuck-boat");
        thread.setDaemon(true);
        thread.start();
    }

    private void accept() {
        while (!socket.isClosed()) {
            try {
                Socket base = socket.accept();
                open.add(base);
                start(() -> talk(base));
            } catch (IOException e) {
                return; // closed
            }
        }
    }

    private void talk(Socket base) {
        try {
            SecureLink link = security.accept(base);
            OutputStream out = link.out();
            out.write(codec.encode(0, new Welcome(name, "boot", Role.OBSERVER, "")));
            out.write(codec.encode(1, new Welcome(name, "boot", Role.COMMANDER, "")));
            out.write(codec.encode(2, new Progress("", 0, false)));
            long sequence = 3;
            for (int times = 1; !closing.await(200, TimeUnit.MILLISECONDS); times++) {
                out.write(codec.encode(sequence++, new Heartbeat(sequence)));
                if (times % 5 == 0) {
                    link.in().readNBytes(readsPerSecond);
                }
            }
        } catch (IOException | InterruptedException e) {
            // dropped
        }
    }

    @Override
    public void close() throws IOException {
        closing.countDown();
        socket.close();
        for (Socket each : open) {
            each.close();
        }
    }
}
