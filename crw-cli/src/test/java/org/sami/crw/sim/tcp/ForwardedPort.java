package org.sami.crw.sim.tcp;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;

/** An address on loopback that is known before the process behind it has one. While nothing listens there, a connection is closed at once. */
final class ForwardedPort implements Closeable {
    private final ServerSocket listening = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    private final List<Socket> open = new CopyOnWriteArrayList<>();
    private volatile int behind;

    ForwardedPort() throws IOException {
        start(this::accept);
    }

    private static void start(Runnable work) {
        Thread one = new Thread(work, "forwarded port");
        one.setDaemon(true);
        one.start();
    }

    /** Leads from now on to a port. */
    void leadTo(int port) {
        behind = port;
    }

    /** Closes all connections; nobody comes through from now on. */
    void shut() throws IOException {
        behind = 0;
        for (Socket one : open) {
            one.close();
        }
    }

    /** Its port. */
    int port() {
        return listening.getLocalPort();
    }

    /** The address of a session there. */
    String address() {
        return "ws://127.0.0.1:" + listening.getLocalPort();
    }

    private void accept() {
        try {
            while (true) {
                Socket from = listening.accept();
                start(() -> lead(from));
            }
        } catch (IOException closed) {
            // the test is over
        }
    }

    private void lead(Socket from) {
        try (from;
                Socket to = new Socket(InetAddress.getLoopbackAddress(), behind)) {
            open.addAll(List.of(from, to));
            start(() -> pump(to, from));
            pump(from, to);
        } catch (IOException nobody) {
            // the front sees that its connection is closed
        }
    }

    private static void pump(Socket from, Socket to) {
        byte[] buffer = new byte[8192];
        try (from;
                to;
                InputStream in = from.getInputStream();
                OutputStream out = to.getOutputStream()) {
            for (int read = in.read(buffer); read >= 0; read = in.read(buffer)) {
                out.write(buffer, 0, read);
                out.flush();
            }
        } catch (IOException cut) {
            // both ends notice it
        }
    }

    @Override
    public void close() throws IOException {
        listening.close();
    }
}
